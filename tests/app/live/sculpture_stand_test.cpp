// Where spacetime stands in the room, and the order of events in it: that of the table of events in every
// frame, flipped where no light connects two events, and nowhere else.
#include "app/live/sculpture_stand.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

#include "app/stage/scenario_scene.h"
#include "app/tables/event_table.h"
#include "app/temporary_folder.h"
#include "cave/texts/format.h"
#include "cave/texts/texts.h"
#include "engine/billiard/billiard.h"
#include "engine/random_world.h"
#include "engine/sculpture/event_order.h"
#include "log_lines.h"
#include "places.h"

namespace carom {
namespace {

Rig deskRig() { return readRig(CAROM_CONFIG_DIR "/rigs/desk.toml"); }
Scenario shipped(const std::string& name) {
  return readScenario(CAROM_CONFIG_DIR "/scenarios/" + name + ".toml");
}

FrameRecord recordOf(const Scenario& scenario, const Rig& rig) {
  FrameRecord record;
  record.boardFromRoom = startingRoom(scenario.observer, rig.axes, scenario.billiard.lightSpeed_m_s);
  record.viewers[0].observer.headFromBoard = record.boardFromRoom.inverse();
  record.viewers[0].observer.middle.positionInRoom_m = {0.0, 1.7, 0.2};
  record.viewers[0].observer.middle.observation = {0.0, scenario.observer.position_m + Vec3(0.0, 0.0, 1.7)};
  record.views.spacetime = 1;
  return record;
}

TEST(SculptureStand, StandsOnTheFloorWithinTheWallsAndUpright) {
  const Rig rig = deskRig();
  const Scenario scenario = shipped("table");
  SculptureStand stand(rig, scenario, {});
  FrameRecord record = recordOf(scenario, rig);
  stand.putInto(record);
  const SculpturePlace& place = record.sculpture.place;
  EXPECT_NEAR(place.roomFromFoot.position_m.y, 0.0, 1e-9);
  EXPECT_GT(place.roomFromFoot.position_m.x, 0.5);
  EXPECT_LT(place.roomFromFoot.position_m.x, 1.5);
  EXPECT_LT(glm::distance(place.roomFromFoot.orientation * Vec3(0.0, 0.0, 1.0), rig.axes.up), 1e-9);
  EXPECT_NEAR(place.past_s, 0.8 * 2.2 / (0.25 * scenario.billiard.lightSpeed_m_s), 1e-9) << "5 s at 1.42 m/s";
  // The axes are those of the board as the room has it.
  const Vec3 x = (record.boardFromRoom.inverse() * Displacement{0.0, {1.0, 0.0, 0.0}}).dr_m;
  EXPECT_LT(glm::distance(place.roomFromFoot.orientation * Vec3(1.0, 0.0, 0.0), x), 1e-9);
}

TEST(SculptureStand, TheFileSaysWhereAndHowLarge) {
  Rig rig = deskRig();
  Scenario scenario = shipped("table");
  rig.spacetime = {Vec3(0.5, 0.0, -0.5), 1.5, 0.2, {}, {}};
  FrameRecord record = recordOf(scenario, rig);
  SculptureStand(rig, scenario, {}).putInto(record);
  EXPECT_EQ(record.sculpture.place.roomFromFoot.position_m, Vec3(0.5, 0.0, -0.5));
  EXPECT_EQ(record.sculpture.place.height_m, 1.5);
  scenario.spacetime = SpacetimeSetup{{}, 2.0, 0.5, 1.0, 0.5};
  SculptureStand(rig, scenario, {}).putInto(record);
  EXPECT_EQ(record.sculpture.place.scale, 0.5);
  EXPECT_NEAR(record.sculpture.place.height_m, 1.5 * 0.5 * scenario.billiard.lightSpeed_m_s, 1e-12);
}

TEST(SculptureStand, AHeightOfNothingIsRefusedWithItsPlace) {
  const test::TemporaryFolder folder;
  const auto file = folder.file(
      "flat.toml", test::contentOf(CAROM_CONFIG_DIR "/rigs/desk.toml") + "\n[spacetime]\nheight_m = 0.0\n");
  try {
    readRig(file);
    FAIL() << "a height of 0 is taken";
  } catch (const InputErrors& error) {
    EXPECT_NE(std::string(error.what()).find("height_m is 0"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("0.1"), std::string::npos) << error.what();
  }
}

TEST(SculptureStand, APlaceOutsideTheRoomIsWarnedOf) {
  Rig rig = deskRig();
  const Scenario scenario = shipped("table");
  for (const auto& [place_m, isOutside] : {std::pair{Vec3(0.9, 0.0, -0.5), false},
                                           {Vec3(0.0, 0.0, 0.0), false},
                                           {Vec3(30.0, 0.0, 0.0), true},
                                           {Vec3(0.0, 12.0, 0.0), true}}) {
    rig.spacetime.place_m = place_m;
    const test::LogLines log;
    const SculptureStand stand(rig, scenario, {});
    const std::vector<std::string> said = log.said();
    ASSERT_EQ(said.size(), isOutside ? 1U : 0U) << place_m.x;
    if (isOutside) {
      EXPECT_NE(said[0].find("warning: [spacetime] place = ["), std::string::npos) << said[0];
    }
    FrameRecord record = recordOf(scenario, rig);
    SculptureStand(rig, scenario, {}).putInto(record);
    EXPECT_EQ(record.sculpture.place.roomFromFoot.position_m, place_m) << "it stands where the file says";
  }
}

TEST(SculptureStand, OfTenThousandPucksTheHundredNearestAreShownAndThatIsSaid) {
  const Rig rig = deskRig();
  Scenario scenario = shipped("table");
  const Puck first = scenario.billiard.pucks.front();
  scenario.billiard.pucks.assign(10000, first);
  for (std::size_t i = 0; i < 10000; ++i)
    scenario.billiard.pucks[i].position_m = {0.001 * static_cast<double>((7919 * i) % 10000), 0.0};
  const SculptedBodies shown = sculptedBodies(scenario);
  ASSERT_EQ(shown.pucks.size(), 100U);
  EXPECT_EQ(shown.leftOut, 9900U);
  for (const std::size_t puck : shown.pucks) EXPECT_LT(scenario.billiard.pucks[puck].position_m.x, 0.1);
  FrameRecord record = recordOf(scenario, rig);
  SculptureStand stand(rig, scenario, {});
  stand.putInto(record);
  const World world;
  EXPECT_EQ(stand.touch({}, 0, world, record).said, texts::say(texts::message::kNotSculpted, 100, 9900));
  EXPECT_EQ(stand.touch({}, 0, world, record).said.english(), "") << "once";
}

TEST(SculptureStand, BodiesThatMoveAsToldHaveTheOutlinesOfTheirMeshes) {
  const Scenario scenario = shipped("train-in-tunnel");
  int compared = 0;
  for (const ScriptedBody& body : scenario.bodies) {
    const Puck puck = outlineOf(body);
    double least_m = 0.0, most_m = 0.0;
    for (const Vec2& corner : puck.outline_m) {
      least_m = std::min(least_m, corner.x);
      most_m = std::max(most_m, corner.x);
    }
    if (body.name != "train" && body.name != "tunnel") continue;
    EXPECT_NEAR(most_m - least_m, body.name == "train" ? 1.5 : 1.0, 0.03) << body.name;
    ++compared;
  }
  EXPECT_EQ(compared, 2);
  ScriptedBody rod{"rod", scenario.bodies.front().worldLine, {}, Material::lacquer, true};
  EXPECT_NEAR(outlineOf(rod).radius_m, 0.5, 0.01);
  rod.isDrawn = false;
  EXPECT_EQ(outlineOf(rod).radius_m, 0.02);
}

TEST(SculptureStand, BeadsHaveTheOrderOfTheTableOfEventsInEveryFrame) {
  const Scenario scenario = shipped("two-cushions");
  Billiard billiard(scenario.billiard);
  billiard.advanceTo(8.0);
  const std::vector<GameEvent> events(billiard.events().begin(), billiard.events().end());
  ASSERT_GT(events.size(), 3u);
  const double c_m_s = scenario.billiard.lightSpeed_m_s;
  const std::vector<std::string> names(scenario.billiard.pucks.size(), "puck");
  const std::vector<std::string> flashes(scenario.billiard.flashes.size(), "flash");
  test::Random random(3640);
  int compared = 0;
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    const double speed = random.in(0.0, kMostSculptureBeta), angle = random.in(0.0, 6.3);
    SculpturePlace place;
    place.past_s = 5.0;
    place.beta = {speed * std::cos(angle), speed * std::sin(angle), 0.0};
    const SculptureMap map(place, {random.in(0.0, 8.0), Vec3(0.3, -1.6, 0.9)}, c_m_s);
    const std::vector<EventRow> rows = eventRows(events, names, flashes, place.beta, c_m_s);
    for (const EventRow& a : rows) {
      for (const EventRow& b : rows) {
        if (std::abs(a.moving.t_s - b.moving.t_s) < 1e-9) continue;
        const bool isFirst = a.moving.t_s < b.moving.t_s;
        ASSERT_EQ(map.model_m(a.event.at).z < map.model_m(b.event.at).z, isFirst);
        ASSERT_EQ(firstOf(a.event.at, b.event.at, place.beta, c_m_s), isFirst ? -1 : 1);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 1000);
}

TEST(SculptureStand, ABoostFlipsThoseThatNoLightConnectsAndNoOthers) {
  const Scenario scenario = shipped("two-cushions");
  const double c_m_s = scenario.billiard.lightSpeed_m_s;
  Billiard billiard(scenario.billiard);
  billiard.advanceTo(8.0);
  int flipped = 0, kept = 0;
  for (const GameEvent& a : billiard.events()) {
    for (const GameEvent& b : billiard.events()) {
      Displacement way = b.at - a.at;
      way.dr_m.z = 0.0;
      const double apart_m = glm::length(way.dr_m), light_m = c_m_s * way.dt_s;
      if (a.number == b.number || way.dt_s < -1e-9 || interval_m2(way, c_m_s) == 0.0) continue;
      const Vec3 along = apart_m > 0.0 ? way.dr_m / apart_m : Vec3(1.0, 0.0, 0.0);
      const int most = firstOf(a.at, b.at, kMostSculptureBeta * along, c_m_s);
      if (std::abs(way.dt_s) <= 1e-9 &&
          apart_m > 1e-6) {  // simultaneous on the table: either one is first for somebody
        EXPECT_EQ(most, 1);
        EXPECT_EQ(firstOf(a.at, b.at, -kMostSculptureBeta * along, c_m_s), -1);
        ++flipped;
      } else if (way.dt_s > 1e-9 && light_m < kMostSculptureBeta * apart_m * (1.0 - 1e-12)) {
        EXPECT_EQ(most, 1) << a.number << ' ' << b.number;
        ++flipped;
      } else if (way.dt_s > 1e-9) {
        for (int k = 0; k < 360; ++k) {
          const double angle = k * 0.0174533;
          ASSERT_EQ(
              firstOf(a.at, b.at,
                      kMostSculptureBeta * (1.0 - 1e-9) * Vec3(std::cos(angle), std::sin(angle), 0.0), c_m_s),
              -1);
        }
        ++kept;
      }
    }
  }
  EXPECT_GT(flipped, 1);
  EXPECT_GT(kept, 2);
}

}  // namespace
}  // namespace carom
