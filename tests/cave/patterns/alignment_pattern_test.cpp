// The seam pattern as drawn: its lines lie where the planes cut the walls, and go on over shared edges.
#include "cave/patterns/alignment_pattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <vector>

#include "app/rig/rig.h"
#include "cave/display/window.h"
#include "cave/pictures/image.h"
#include "places.h"

namespace carom {
namespace {

class Seams : public testing::Test {
 protected:
  Image drawn(const Wall& wall, double time_s) {
    graphics_.makeCurrent();
    AlignmentPattern pattern;
    RenderTarget picture(wall.pixels);
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

const Wall& named(const Rig& rig, const std::string& name) {
  return *std::find_if(rig.walls.begin(), rig.walls.end(),
                       [&](const Wall& wall) { return wall.name == name; });
}

/// A place on a wall, as shares of its width and height.
glm::dvec2 onWall(const Wall& wall, const glm::dvec3& place) {
  const glm::dvec3 across = wall.lowerRight_m - wall.lowerLeft_m, up = wall.upperLeft_m - wall.lowerLeft_m;
  const glm::dvec3 from = place - wall.lowerLeft_m;
  return {glm::dot(from, across) / glm::dot(across, across), glm::dot(from, up) / glm::dot(up, up)};
}

/// Along an edge of a wall, whose ends are corners of it: metres from `from` at which the lines cross it of
/// the planes across `axis`.
std::vector<double> crossings_m(const Wall& wall, const Image& image, const glm::dvec3& from,
                                const glm::dvec3& to, int axis) {
  const glm::ivec2 last = wall.pixels - 1;
  const auto pixelOf = [&](const glm::dvec3& corner) {
    return glm::ivec2(glm::round(onWall(wall, corner) * glm::dvec2(last)));
  };
  const glm::ivec2 start = pixelOf(from), way = pixelOf(to) - start;
  const int count = std::max(std::abs(way.x), std::abs(way.y)) + 1;
  std::vector<double> lines = middles(image, axis, start, way / (count - 1), count);
  for (double& line : lines) line *= glm::distance(from, to) / count;
  return lines;
}

void expectSame(const std::vector<double>& one_m, const std::vector<double>& other_m, double halfPixel_m) {
  ASSERT_EQ(one_m.size(), other_m.size());
  ASSERT_GE(one_m.size(), 2u);  // 1.3 m of edge at least, a line every half metre
  for (std::size_t i = 0; i < one_m.size(); ++i) EXPECT_NEAR(one_m[i], other_m[i], halfPixel_m) << i;
}

std::array<glm::dvec3, 4> cornersOf(const Wall& wall) {
  return {wall.lowerLeft_m, wall.lowerRight_m, wall.lowerRight_m + wall.upperLeft_m - wall.lowerLeft_m,
          wall.upperLeft_m};
}

/// The corners that two walls share: none, or the ends of an edge.
std::vector<glm::dvec3> sharedCorners(const Wall& a, const Wall& b) {
  std::vector<glm::dvec3> shared;
  for (const glm::dvec3& corner : cornersOf(a)) {
    for (const glm::dvec3& other : cornersOf(b)) {
      if (glm::distance(corner, other) < 1e-9) shared.push_back(corner);
    }
  }
  return shared;
}

/// The axis that an edge runs along, or −1.
int axisOf(const glm::dvec3& edge) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(edge[axis]) > 0.999 * glm::length(edge)) return axis;
  }
  return -1;
}

TEST_F(Seams, LinesMeetAtEverySharedEdgeOfEveryShippedRig) {
  std::size_t ofFive = 0;
  for (const auto& file : std::filesystem::directory_iterator(CAROM_CONFIG_DIR "/rigs")) {
    const Rig rig = readRig(file.path());
    for (const double time_s : {0.7, 77.1, 5000.3}) {
      std::vector<Image> images;
      for (const Wall& wall : rig.walls) images.push_back(drawn(wall, time_s));
      std::size_t edges = 0;
      for (std::size_t i = 0; i < rig.walls.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          const Wall &a = rig.walls[i], &b = rig.walls[j];
          const auto shared = sharedCorners(a, b);
          if (shared.size() != 2) continue;
          ++edges;
          SCOPED_TRACE(testing::Message()
                       << rig.title << ", " << a.name << " and " << b.name << ", " << time_s << " s");
          const int axis = axisOf(shared[1] - shared[0]);
          ASSERT_GE(axis, 0);
          const double pixel_m = glm::distance(shared[0], shared[1]) / std::min(a.pixels.x, b.pixels.x);
          expectSame(crossings_m(a, images[i], shared[0], shared[1], axis),
                     crossings_m(b, images[j], shared[0], shared[1], axis), 0.5 * pixel_m);
        }
      }
      if (file.path().stem() == "five-walls-cluster") ofFive = edges;
    }
  }
  EXPECT_EQ(ofFive, 8U) << "front, left, right, floor and ceiling meet along eight edges";
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
