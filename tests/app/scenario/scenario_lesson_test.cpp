// The lesson and the tasks of a scenario file.
#include "app/scenario/scenario_lesson.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/file_keys/lesson_keys.h"
#include "app/scenario/scenario_text.h"
#include "app/toml/input_file.h"
#include "places.h"

namespace carom {
namespace {

using test::puckText;
using test::read;

TEST(Scenario, ReadsTasksAndLamps) {
  const std::string pucks = puckText("white", 0.03, {0, 0}, {0, 0}) + puckText("red", 0.03, {0.3, 0}, {0, 0});
  const std::string task = "[[task]]\nname = 'a'\ntext = 'b'\nstars_j = [0.1, 0.2]\n";
  const Scenario scenario =
      read("light_speed_m_s = 1\n" + pucks + task +
           "goal = { hit-both = ['red', 'white'] }\nworld = 'measured'\n" +
           "[[lamp]]\nposition_m = [1, 2, 3]\non_s = 4\ncolour = [1, 0.5, 0]\npower = 2\n");
  ASSERT_EQ(scenario.tasks.size(), 1u);
  EXPECT_EQ(scenario.tasks[0].goal.kind, TaskGoal::Kind::hitBoth);
  EXPECT_EQ(scenario.tasks[0].goal.pucks, (std::vector<std::size_t>{1, 0}));
  EXPECT_EQ(scenario.tasks[0].world, TaskWorld::measured);
  ASSERT_EQ(scenario.lamps.size(), 1u);
  EXPECT_EQ(scenario.lamps[0].light, glm::vec3(2.0F, 1.0F, 0.0F));
  const auto refused = [&](const std::string& rest) {
    EXPECT_THROW(read("light_speed_m_s = 1\n" + pucks + task + rest), InputErrors) << rest;
  };
  refused("");
  refused("goal = {}\n");
  refused("goal = { hit = 'blue' }\n");
  refused("goal = { hit-both = ['red'] }\n");
  refused("goal = { hit-both = ['red', 'red'] }\n");
  refused("goal = { hit = 'red', cushions = 2 }\n");
  refused("goal = { cushions = 0 }\n");
  refused("goal = { hit = 'red' }\nworld = 'flat'\n");
  refused("goal = { hit = 'red' }\n" + task + "goal = { hit = 'red' }\n");
}

// The wheel's mesh is painted in sectors, an even number, and its lesson offers two effects.
TEST(Scenario, ReadsTheSectorsOfAMeshAndTheEffectsOfALesson) {
  const std::string wheel = test::contentOf(CAROM_CONFIG_DIR "/scenarios/rolling-wheel.toml");
  const auto with = [&](const std::string& old, const std::string& other) {
    std::string text = wheel;
    text.replace(text.find(old), old.size(), other);
    return text;
  };
  const Scenario scenario = read(wheel);
  EXPECT_EQ(scenario.puckMeshes.at(0)->sectors, 8);
  EXPECT_EQ(scenario.lesson->plan.effects, (std::vector<std::uint8_t>{0, 1}));
  EXPECT_EQ(read(with("sectors = 8", "")).puckMeshes.at(0)->sectors, 0);
  EXPECT_THROW(read(with("sectors = 8", "sectors = 7")), InputErrors);
  EXPECT_THROW(read(with("mesh = \"models/wheel.obj\"", "")), InputErrors);
  EXPECT_THROW(read(with("\"retardation\", \"contraction\"", "\"retardaton\"")), InputErrors);
}

TEST(Scenario, LessonsFitTheWallsThatShowThem) {
  const std::string wheel = test::contentOf(CAROM_CONFIG_DIR "/scenarios/rolling-wheel.toml");
  const std::size_t at = wheel.find("\ntodo = ");
  ASSERT_NE(at, std::string::npos);
  const auto withTodo = [&](std::size_t letters) {
    std::string words;
    for (std::size_t i = 0; i < letters; ++i) words += "é";  // two bytes, one letter
    std::string text = wheel;
    return text.replace(at + 1, text.find('\n', at + 1) - at - 1, "todo = '" + words + "'");
  };
  EXPECT_NO_THROW(read(withTodo(kLessonTextLetters)));
  EXPECT_THROW(read(withTodo(kLessonTextLetters + 1)), InputErrors);
}

}  // namespace
}  // namespace carom
