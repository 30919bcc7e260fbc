// The buttons on the front wall: every ray to one finds it, and none of them covers another or the panel of
// words.
#include "cave/overlay/wall_buttons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "cave/overlay/panel_place.h"
#include "cave/room/off_axis.h"
#include "engine/random_world.h"

namespace carom {
namespace {

/// A wall of any size that stands upright, turned about the vertical.
Wall anyWall(test::Random& random) {
  const double turned = random.in(-3.0, 3.0), width_m = random.in(0.4, 6.0), height_m = random.in(0.4, 4.0);
  Wall wall;
  wall.lowerLeft_m = {random.in(-2.0, 2.0), random.in(0.0, 1.0), random.in(-2.0, 2.0)};
  wall.lowerRight_m = wall.lowerLeft_m + width_m * glm::dvec3(std::cos(turned), 0.0, std::sin(turned));
  wall.upperLeft_m = wall.lowerLeft_m + glm::dvec3(0.0, height_m, 0.0);
  wall.pixels = {1280, 720};
  return wall;
}

TEST(ChoiceTiles, ARayFromAnywhereInFrontFindsTheTileThatItMeets) {
  test::Random random(7);
  for (int run = 0; run < 300; ++run) {
    SCOPED_TRACE(run);
    const Wall wall = anyWall(random);
    const glm::dvec2 wall_m = sizeOf_m(wall);
    const glm::dvec3 right = (wall.lowerRight_m - wall.lowerLeft_m) / wall_m.x, up{0.0, 1.0, 0.0};
    const bool atFoot = random.in(0.0, 1.0) < 0.5;
    const glm::dvec2 at_m{random.in(0.0, wall_m.x), random.in(0.0, wall_m.y)};
    const glm::dvec3 onWall_m = wall.lowerLeft_m + at_m.x * right + at_m.y * up;
    const glm::dvec3 eye_m = onWall_m + random.in(0.2, 3.0) * normalOf(wall) + random.in(-2.0, 2.0) * right;
    const auto tiles = tilesOn(wall, atFoot);
    std::vector<WallButton> buttons;
    for (std::size_t i = 0; i < kChoices; ++i)
      buttons.push_back({actionOf(static_cast<Choice>(i)), tiles[i]});
    std::optional<Choice> expected;
    for (std::size_t i = 0; i < kChoices; ++i) {
      const glm::dvec2 in = (at_m - tiles[i].from_m) / tiles[i].size_m;
      if (in.x >= 0.0 && in.x <= 1.0 && in.y >= 0.0 && in.y <= 1.0) expected = static_cast<Choice>(i);
    }
    const auto found = buttonAt(wall, buttons, eye_m, random.in(0.1, 2.0) * (onWall_m - eye_m));
    ASSERT_EQ(found.has_value(), expected.has_value());
    EXPECT_FALSE(buttonAt(wall, buttons, eye_m, eye_m - onWall_m)) << "the ray goes away from the wall";
    if (!found) continue;
    EXPECT_EQ(found->action, actionOf(*expected));
    EXPECT_LT(glm::distance(found->onWall_m, onWall_m), 1e-9);
  }
}

TEST(ChoiceTiles, TheyAreOnTheWallSideBySideAndRightOfTheWords) {
  test::Random random(8);
  for (int run = 0; run < 300; ++run) {
    SCOPED_TRACE(run);
    const Wall wall = anyWall(random);
    const glm::dvec2 wall_m = sizeOf_m(wall);
    for (const bool atFoot : {false, true}) {
      const auto tiles = tilesOn(wall, atFoot);
      for (std::size_t i = 0; i < kChoices; ++i) {
        EXPECT_GE(tiles[i].from_m.x, 0.0);
        EXPECT_LE(tiles[i].from_m.x + tiles[i].size_m.x, wall_m.x);
        const double free_m = i > 0 ? tiles[i - 1].from_m.x + tiles[i - 1].size_m.x : -1.0;
        EXPECT_GT(tiles[i].from_m.x, free_m);
      }
      // The panel of words begins at the margin and is at most so wide.
      const double wordsEnd_m = PanelPlace::kMargin * wall_m.y + PanelPlace::kMostOfWidth * wall_m.x;
      if (atFoot || wall_m.y > wall_m.x) continue;
      EXPECT_GT(tiles[0].from_m.x, wordsEnd_m - 1e-9);
    }
  }
}

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
