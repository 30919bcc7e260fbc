// The shipped scenarios, and what a file may leave out.
#include "app/scenario/scenario.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "app/scenario/scenario_text.h"
#include "places.h"

namespace carom {
namespace {

using test::kRounding;
using test::puckText;
using test::read;

TEST(Scenario, ReadsTheThreePucks) {
  const Scenario scenario = readScenario(CAROM_CONFIG_DIR "/scenarios/three-pucks.toml");
  EXPECT_EQ(scenario.title, "Three pucks");
  EXPECT_EQ(scenario.billiard.lightSpeed_m_s, 1.42);
  ASSERT_TRUE(scenario.billiard.board);
  EXPECT_EQ(scenario.billiard.board->length_m, 2.84);
  EXPECT_EQ(scenario.billiard.board->width_m, 1.42);
  ASSERT_EQ(scenario.billiard.pucks.size(), 3u);
  EXPECT_EQ(scenario.billiard.pucks[0].name, "white");
  EXPECT_EQ(scenario.billiard.pucks[0].beta, Vec2(0.8, 0.0));
  EXPECT_EQ(scenario.observer.position_m, Vec3(0.0, -1.6, -0.75));
  EXPECT_NEAR(scenario.observer.facing_rad, std::numbers::pi / 2, kRounding);
}

TEST(Scenario, EveryShippedFileIsRight) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(CAROM_CONFIG_DIR "/scenarios")) {
    SCOPED_TRACE(entry.path());
    EXPECT_NO_THROW(readScenario(entry.path()));
    ++count;
  }
  EXPECT_GE(count, 2);
}

TEST(Scenario, LeavesOutWhatIsOptional) {
  const Scenario scenario = read("light_speed_m_s = 2\n" + puckText("a", 1.0, {0, 0}, {0, 0}));
  EXPECT_FALSE(scenario.billiard.board);
  EXPECT_EQ(scenario.billiard.rules.puckRestitution, 1.0);
  EXPECT_EQ(scenario.billiard.rules.cushionRestitution, 1.0);
  EXPECT_EQ(scenario.billiard.rules.friction_m_s2, 0.0);
  EXPECT_EQ(scenario.billiard.rules.collisionEvent, CollisionEvent::centre);
  EXPECT_EQ(scenario.observer.position_m, Vec3(0.0, -1.6, -0.75));
  EXPECT_FALSE(scenario.puckMeshes.at(0));
}

// The choices of the front wall belong to a lesson, unless the file says otherwise.
TEST(Scenario, OffersWhatItHas) {
  const std::string puck = puckText("a", 0.1, {0, 0}, {0, 0});
  const GameOffers bare = offersOf(read("light_speed_m_s = 2\n" + puck));
  const GameOffers table =
      offersOf(read("light_speed_m_s = 2\nchoices = true\n[board]\nlength_m = 2\nwidth_m = 1\n" + puck +
                    "[[task]]\nname = 'a'\ntext = 'b'\nstars_j = [0.1, 0.2]\ngoal = { hit = 'a' }\n"));
  const GameOffers lesson = offersOf(readScenario(CAROM_CONFIG_DIR "/scenarios/rolling-wheel.toml"));
  EXPECT_FALSE(bare.choices || bare.hasTable || bare.hasTasks);
  EXPECT_TRUE(table.choices && table.hasTable && table.hasTasks);
  EXPECT_TRUE(lesson.choices);
}

}  // namespace
}  // namespace carom
