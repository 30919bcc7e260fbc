// What a page shows of a game without a session: the game as the physics plays it, seen by one who stands at
// its start.
#include "app/page/visit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <string>

#include "app/temporary_folder.h"
#include "cave/frame/bodies.h"
#include "places.h"

namespace carom {
namespace {

using test::TemporaryFolder;

const std::filesystem::path kScenario = CAROM_CONFIG_DIR "/scenarios/three-pucks.toml";

TEST(Visit, HasTheGameAsThePhysicsPlaysIt) {
  constexpr double kUntil_s = 6.0;
  const Visit visit = visitOf(kScenario, kUntil_s);
  Billiard billiard(readScenario(kScenario).billiard);
  billiard.advanceTo(visit.known_s);
  EXPECT_GE(visit.known_s, kUntil_s);
  ASSERT_EQ(visit.changes.size(), 1U);
  EXPECT_EQ(visit.changes[0].frame, 0U) << "all is known from the first frame on";
  std::vector<WorldLine> known = visit.atStart;
  for (const BodyKnot& knot : visit.changes[0].knots) known.at(knot.body).append(knot.knot);
  for (std::size_t puck = 0; puck < billiard.worldLines().size(); ++puck) {
    const auto expected = billiard.worldLines()[puck].knots(), found = known.at(kFirstPuck + puck).knots();
    ASSERT_EQ(found.size(), expected.size()) << "puck " << puck;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].turn.t_s, expected[i].turn.t_s);
      EXPECT_EQ(found[i].u, expected[i].u);
    }
  }
  ASSERT_EQ(visit.events.size(), billiard.events().size());
  EXPECT_GT(visit.events.size(), 2U) << "a game with bounces";
  EXPECT_FALSE(visit.live);
}

// An observer who rests: their own time is the board's, and an eye is half the distance of the eyes from the
// middle.
TEST(Visit, ItsObserverStandsAtTheStart) {
  const TemporaryFolder folder;
  const std::string text =
      "title = \"t\"\nlight_speed_m_s = 1.42\n[observer]\nposition_m = [0.5, -1.7, -0.75]\n[board]\nlength_m "
      "= "
      "2.84\nwidth_m = 1.42\n[[puck]]\nname = \"white\"\nradius_m = 0.0305\nheight_m = 0.02\nmass_kg = 0.2\n"
      "position_m = [0.0, -0.2]\nbeta = [0.0, 0.0]\n";
  const Visit visit = visitOf(folder.file("rest.toml", text), 2.0);
  ASSERT_GE(visit.frames.size(), 40U);
  const Event& first = visit.frames[0].observer.middle.observation;
  for (std::size_t i = 0; i < visit.frames.size(); ++i) {
    SCOPED_TRACE(i);
    const VisitFrame& frame = visit.frames[i];
    EXPECT_EQ(frame.number, i);
    EXPECT_NEAR(frame.display_s, 0.05 * static_cast<double>(i), 1e-12);
    EXPECT_NEAR(frame.observer.middle.observation.t_s - first.t_s, frame.display_s, 1e-9);
    EXPECT_LT(glm::distance(frame.observer.middle.observation.r_m, first.r_m), 1e-9);
    EXPECT_NEAR(glm::distance(frame.observer.left.positionInRoom_m, frame.observer.right.positionInRoom_m),
                0.064, 1e-12);
  }
  EXPECT_NEAR(first.r_m.z, -0.75 + 1.7, 1e-9) << "eyes 1.7 m above the floor";
  EXPECT_LE(visit.frames.back().observer.middle.observation.t_s, 2.0 + 1e-9);
}

TEST(Visit, AGameThatIsFollowedBeginsWithOneFrameInItsRoom) {
  const Rig rig = readRig(std::filesystem::path(CAROM_CONFIG_DIR "/rigs/desk.toml"));
  const Scenario scenario = readScenario(kScenario);
  const Visit visit = visitToFollow(rig, scenario, 7);
  EXPECT_EQ(visit.live, 7U);
  EXPECT_EQ(visit.frames.size(), 1U);
  EXPECT_TRUE(visit.changes.empty() && visit.events.empty()) << "its news tell them";
  EXPECT_EQ(visit.axes.up, rig.axes.up);
  EXPECT_EQ(visit.atStart.size(), visitOf(kScenario, 0.5).atStart.size());
}

TEST(Visit, WhatAPageCannotHoldIsRefused) {
  const auto refusal = [](const Scenario& scenario) -> std::string {
    const Rig rig = readRig(std::filesystem::path(CAROM_CONFIG_DIR "/rigs/desk.toml"));
    try {
      visitToFollow(rig, scenario, 0);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  };
  Scenario scenario = readScenario(kScenario);
  scenario.billiard.pucks.resize(kMostVisitPucks + 1, scenario.billiard.pucks.front());
  EXPECT_EQ(refusal(scenario),
            "follow: the game has 201 pucks, expected at most 200 for a page; carom replay --movie makes a "
            "film of it");
  scenario.billiard.pucks.resize(3);
  scenario.billiard.pucks[2].soft.emplace();
  EXPECT_EQ(refusal(scenario),
            "follow: the game has soft bodies, which a page does not show; carom replay --movie makes a film "
            "of it");
}

}  // namespace
}  // namespace carom
