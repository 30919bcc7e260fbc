// The buttons on the front wall: every ray to one finds it, and none of them covers another or the panel of
// words.
#include "cave/overlay/wall_buttons.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>

#include "cave/hud/panel_place.h"
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

}  // namespace
}  // namespace carom
