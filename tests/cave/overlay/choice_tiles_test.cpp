// Which buttons are offered on the front wall, and when.
#include "cave/overlay/wall_buttons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "cave/hud/panel_place.h"
#include "cave/room/off_axis.h"
#include "engine/random_world.h"

namespace carom {
namespace {

TEST(ChoiceTiles, AreOfferedOnlyBetweenDeeds) {
  FrameRecord record;
  EXPECT_TRUE(offersChoicesNow(record));
  record.viewers[0].hand.pulling = 1;
  EXPECT_FALSE(offersChoicesNow(record)) << "a stroke is drawn back";
  record.viewers[0].hand.pulling = 0;
  record.drive.thrust = {0.0, 0.5, 0.0};
  EXPECT_FALSE(offersChoicesNow(record)) << "the platform is driven";
  record.drive.mode = DriveMode::tour;
  EXPECT_TRUE(offersChoicesNow(record)) << "a scripted flight can be left";
  for (const auto& [phase, offered] :
       {std::pair{LessonPhase::asks, false}, {LessonPhase::shows, false}, {LessonPhase::explains, true}}) {
    record.lesson.phase = phase;
    EXPECT_EQ(offersChoicesNow(record), offered);
  }
}

/// The kinds of the tiles that are offered.
std::vector<WallAction::Kind> kindsOf(const FrameRecord& record, const OfferedTiles& offered) {
  Wall wall;
  wall.lowerLeft_m = {-1.0, 0.0, -1.0};
  wall.lowerRight_m = {1.0, 0.0, -1.0};
  wall.upperLeft_m = {-1.0, 2.0, -1.0};
  wall.pixels = {800, 800};
  std::vector<WallButton> tiles;
  addTiles(wall, record, offered, tiles);
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    EXPECT_GE(tiles[i].place.from_m.y, 0.0);
    for (std::size_t j = 0; j < i; ++j) {
      const Tile &a = tiles[i].place, &b = tiles[j].place;
      const bool apart = a.from_m.x >= b.from_m.x + b.size_m.x || b.from_m.x >= a.from_m.x + a.size_m.x ||
                         a.from_m.y >= b.from_m.y + b.size_m.y || b.from_m.y >= a.from_m.y + a.size_m.y;
      EXPECT_TRUE(apart) << i << " and " << j;
    }
  }
  std::vector<WallAction::Kind> kinds;
  for (const WallButton& tile : tiles) kinds.push_back(tile.action.kind);
  return kinds;
}

/// The kinds, and behind them the Doppler colour, which every game with choices offers outside lessons and
/// tasks.
std::vector<WallAction::Kind> withColour(std::vector<WallAction::Kind> kinds) {
  kinds.push_back(WallAction::Kind::effect);
  return kinds;
}

TEST(ChoiceTiles, TasksAreOfferedAfterTheFirstStrokeAndInATaskTheNextOneAndAnotherTry) {
  using Kind = WallAction::Kind;
  FrameRecord record;
  record.boardFromRoom = Lorentz(1.42);
  const std::vector<Kind> three(3, Kind::choice);
  EXPECT_EQ(kindsOf(record, {true, false, false, false}), withColour(three));
  record.viewers[0].score.strokes = 1;
  EXPECT_EQ(kindsOf(record, {true, false, false, false}),
            withColour({Kind::choice, Kind::choice, Kind::choice, Kind::tasks}));
  EXPECT_TRUE(kindsOf(record, {false, false, false, false}).empty()) << "a game that offers nothing";
  const std::vector<Kind> inTask = kindsOf(record, {true, true, false, true});
  EXPECT_EQ(inTask, (std::vector<Kind>{Kind::choice, Kind::choice, Kind::choice, Kind::keys, Kind::nextTask,
                                       Kind::again}));
}

TEST(ChoiceTiles, WhatKeysDoIsOfferedWhereItDoesSomething) {
  using Kind = WallAction::Kind;
  using Kinds = std::vector<Kind>;
  const Kinds three(3, Kind::choice);
  const auto with = [&](Kinds more) {
    more.insert(more.begin(), three.begin(), three.end());
    return more;
  };
  FrameRecord record;
  record.boardFromRoom = Lorentz(1.42);
  EXPECT_EQ(kindsOf(record, {true, false, false}), with({Kind::effect}));
  EXPECT_EQ(kindsOf(record, {true, true, false}), with({Kind::keys, Kind::effect}));
  EXPECT_EQ(kindsOf(record, {false, true, false}), Kinds{});
  EXPECT_EQ(kindsOf(record, {false, true, true}), Kinds{Kind::home});
  record.viewers[0].score.caroms = 1;
  EXPECT_EQ(kindsOf(record, {true, true, true}), with({Kind::goOn, Kind::home, Kind::keys, Kind::effect}));
  EXPECT_EQ(kindsOf(record, {true, true, false}),
            with({Kind::goOn, Kind::keepShot, Kind::keys, Kind::effect}));
  record.drive.mode = DriveMode::home;
  EXPECT_EQ(kindsOf(record, {true, true, true}), with({Kind::goOn, Kind::keepShot, Kind::keys, Kind::effect}))
      << "under way already";
  record.drive.mode = DriveMode::free;
  record.views.frozen = 1;
  EXPECT_EQ(kindsOf(record, {true, true, true}), (Kinds{Kind::goOn, Kind::unfreeze}));
  record.viewers[0].hand.pulling = 1;
  EXPECT_EQ(kindsOf(record, {true, true, true}), Kinds{});
  record = {};
  record.lesson.phase = LessonPhase::explains;
  EXPECT_EQ(kindsOf(record, {true, true, true}), three);
  record.lesson.phase = LessonPhase::shows;
  EXPECT_EQ(kindsOf(record, {true, true, true}), Kinds{});
}

TEST(ChoiceTiles, TheNextLanguageHasATileWhereThereAreSeveralAlsoInALesson) {
  using Kind = WallAction::Kind;
  const auto hasLanguage = [](const std::vector<Kind>& kinds) {
    return std::count(kinds.begin(), kinds.end(), Kind::language) == 1;
  };
  FrameRecord record;
  record.viewers[0].score = {1, 3};
  record.views.frozen = 1;
  const OfferedTiles all{.choices = true, .keys = true, .isAstray = true, .hasTasks = true};
  const std::vector<Kind> without = kindsOf(record, all);
  EXPECT_FALSE(hasLanguage(without));
  record.languagesOnTile = 1;
  EXPECT_EQ(kindsOf(record, all), without) << "one language is no choice";
  record.languagesOnTile = 2;
  EXPECT_TRUE(hasLanguage(kindsOf(record, all)));
  record.views.frozen = 0;
  EXPECT_TRUE(hasLanguage(kindsOf(record, all)));
  EXPECT_EQ(kindsOf(record, {}), (std::vector<Kind>{Kind::language, Kind::goOn, Kind::keepShot}))
      << "a game without choices";
  for (const LessonPhase phase : {LessonPhase::asks, LessonPhase::shows, LessonPhase::explains}) {
    record.lesson.phase = phase;
    EXPECT_TRUE(hasLanguage(kindsOf(record, all)));
  }
  record.viewers[0].hand.pulling = 1;
  EXPECT_FALSE(hasLanguage(kindsOf(record, all))) << "a stroke is drawn back";
}

TEST(ChoiceTiles, ATileOfALanguageGoesRoundForEachViewer) {
  Wall wall;
  wall.lowerLeft_m = {-1.0, 0.0, -1.0};
  wall.lowerRight_m = {1.0, 0.0, -1.0};
  wall.upperLeft_m = {-1.0, 2.0, -1.0};
  FrameRecord record;
  record.viewerCount = 2;
  record.languagesOnTile = 3;
  record.viewers[1].language = 2;
  for (const auto& [viewer, next] : {std::pair<std::size_t, int>{0, 1}, {1, 0}}) {
    std::vector<WallButton> tiles;
    addTiles(wall, SeenFrame(record, viewer), {}, tiles);
    ASSERT_EQ(tiles.size(), 1U);
    EXPECT_EQ(tiles[0].action.number, next);
  }
}

}  // namespace
}  // namespace carom
