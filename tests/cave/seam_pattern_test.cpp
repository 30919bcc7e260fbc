// The seam pattern as drawn: its lines lie where the planes cut the walls, and go on over shared edges.
#include "cave/seam_pattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/rig.h"
#include "cave/capture.h"
#include "cave/window.h"

namespace carom {
namespace {

class Seams : public testing::Test {
 protected:
  Image drawn(const Wall& wall, double time_s) {
    graphics_.makeCurrent();
    const SeamPattern pattern;
    WallPicture picture(wall.pixels);
    pattern.draw(wall, time_s, picture);
    return readBack(picture);
  }

  Graphics graphics_;
};

Rig desk() { return readRig(std::string(CAROM_CONFIG_DIR) + "/rigs/desk.toml"); }

/// Where lines of one colour cross a column or row of pixels: their middles, in pixels along it.
std::vector<double> middles(const Image& image, int channel, const glm::ivec2& start, const glm::ivec2& step,
                            int count) {
  std::vector<double> found;
  int from = -1;
  for (int i = 0; i <= count; ++i) {
    const glm::ivec2 place = start + i * step;
    const bool lit =
        i < count &&
        image.rgb[static_cast<std::size_t>(3 * (place.y * image.size_px.x + place.x) + channel)] > 127;
    if (lit && from < 0) from = i;
    if (lit || from < 0) continue;
    if (from > 0 && i < count) found.push_back(0.5 * (from + i));  // not cut off by an end
    from = -1;
  }
  return found;
}

/// Along the edge of a wall at its left or right: heights (m) of the lines of y, from the bottom.
std::vector<double> heights_m(const Wall& wall, const Image& image, bool atRight) {
  std::vector<double> lines = middles(image, 1, {atRight ? wall.pixels.x - 1 : 0, 0}, {0, 1}, wall.pixels.y);
  for (double& line : lines) {
    line = wall.lowerLeft_m.y + line / wall.pixels.y * (wall.upperLeft_m.y - wall.lowerLeft_m.y);
  }
  return lines;
}

/// Along the lower edge of the front wall and the upper edge of the floor: lines of x.
std::vector<double> widths_m(const Wall& wall, const Image& image, bool atTop) {
  std::vector<double> lines = middles(image, 0, {0, atTop ? wall.pixels.y - 1 : 0}, {1, 0}, wall.pixels.x);
  for (double& line : lines) {
    line = wall.lowerLeft_m.x + line / wall.pixels.x * (wall.lowerRight_m.x - wall.lowerLeft_m.x);
  }
  return lines;
}

const Wall& named(const Rig& rig, const std::string& name) {
  return *std::find_if(rig.walls.begin(), rig.walls.end(),
                       [&](const Wall& wall) { return wall.name == name; });
}

void expectSame(const std::vector<double>& one_m, const std::vector<double>& other_m) {
  ASSERT_EQ(one_m.size(), other_m.size());
  ASSERT_GE(one_m.size(), 5u);  // 3 m of edge, a line every half metre, perhaps one cut off at an end
  constexpr double kHalfPixel_m = 0.0025;  // 3 m over 600 pixels
  for (std::size_t i = 0; i < one_m.size(); ++i) EXPECT_NEAR(one_m[i], other_m[i], kHalfPixel_m) << i;
}

TEST_F(Seams, LinesMeetAtTheSharedEdgesOfTheDesk) {
  const Rig rig = desk();
  const Wall &front = named(rig, "front"), &left = named(rig, "left"), &right = named(rig, "right"),
             &floor = named(rig, "floor");
  for (const double time_s : {0.7, 1.234, 77.1, 5000.3}) {
    SCOPED_TRACE(time_s);
    const Image onFront = drawn(front, time_s);
    expectSame(heights_m(left, drawn(left, time_s), true), heights_m(front, onFront, false));
    expectSame(heights_m(front, onFront, true), heights_m(right, drawn(right, time_s), false));
    expectSame(widths_m(front, onFront, false), widths_m(floor, drawn(floor, time_s), true));
  }
}

// Against the planes themselves, by hand: at 1.2 s they have gone 0.12 m.
TEST_F(Seams, LinesAreWhereThePlanesAreAndMove) {
  const Wall front = named(desk(), "front");
  const std::vector<double> found_m = heights_m(front, drawn(front, 1.2), false);
  const std::vector<double> expected_m{0.12, 0.62, 1.12, 1.62, 2.12, 2.62};
  ASSERT_EQ(found_m.size(), expected_m.size());
  for (std::size_t i = 0; i < expected_m.size(); ++i) EXPECT_NEAR(found_m[i], expected_m[i], 0.0025) << i;
}

// A wall 30° askew to the axes: its lines of x lie where x is, whatever the wall's own directions are.
TEST_F(Seams, LinesOfALeaningWallFollowTheRoom) {
  Wall wall;
  wall.pixels = {800, 400};
  wall.lowerLeft_m = {-1.0, 0.0, -2.0};
  const glm::dvec3 across(2.0 * std::cos(M_PI / 6.0), 0.0, 2.0 * std::sin(M_PI / 6.0));
  wall.lowerRight_m = wall.lowerLeft_m + across;
  wall.upperLeft_m = wall.lowerLeft_m + glm::dvec3(0.0, 1.0, 0.0);
  const std::vector<double> lines = middles(drawn(wall, 1.2), 0, {0, 200}, {1, 0}, wall.pixels.x);
  const std::vector<double> expected_m{-0.88, -0.38, 0.12, 0.62};
  ASSERT_EQ(lines.size(), expected_m.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_NEAR(wall.lowerLeft_m.x + lines[i] / 800.0 * across.x, expected_m[i], 0.0013)
        << i;  // half a pixel
  }
}

// Planes along a wall would flood it: they are left out.
TEST_F(Seams, NoWallIsFlooded) {
  const Wall front = named(desk(), "front");
  for (double time_s = 0.0; time_s < 5.0; time_s += 0.05) {
    const Image image = drawn(front, time_s);
    for (std::size_t i = 2; i < image.rgb.size(); i += 3)
      ASSERT_EQ(image.rgb[i], 0) << "blue, " << time_s << " s";
  }
}

}  // namespace
}  // namespace carom
