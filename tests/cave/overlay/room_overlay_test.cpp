// The warning grid and the trackers' crosses as pixels, against lines of sight cut with the wall's plane.
#include "cave/overlay/room_overlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "cave/display/window.h"
#include "cave/pictures/image.h"

namespace carom {
namespace {

using Rgb = std::array<int, 3>;

/// A wall of 3 × 2 m, askew in the room; 5 mm a pixel.
Wall leaningWall() {
  const glm::dvec3 right = glm::normalize(glm::dvec3(1.0, 0.2, 0.4));
  const glm::dvec3 up = glm::normalize(glm::cross(glm::dvec3(0.3, 0.1, 1.0), right));
  Wall wall;
  wall.lowerLeft_m = {-1.5, 0.1, -1.2};
  wall.lowerRight_m = wall.lowerLeft_m + 3.0 * right;
  wall.upperLeft_m = wall.lowerLeft_m + 2.0 * up;
  wall.pixels = {600, 400};
  return wall;
}

class RoomOverlayPicture : public testing::Test {
 protected:
  /// At the wall's (right, up) metres, and off it into the room.
  glm::dvec3 place(double x_m, double y_m, double off_m) const {
    const glm::dvec3 right = glm::normalize(wall_.lowerRight_m - wall_.lowerLeft_m);
    const glm::dvec3 up = glm::normalize(wall_.upperLeft_m - wall_.lowerLeft_m);
    return wall_.lowerLeft_m + x_m * right + y_m * up + off_m * glm::cross(right, up);
  }

  /// Where the line of sight to a place meets the wall, as a pixel.
  glm::dvec2 pixelOf(const glm::dvec3& place_m) const {
    const glm::dvec3 right = glm::normalize(wall_.lowerRight_m - wall_.lowerLeft_m);
    const glm::dvec3 up = glm::normalize(wall_.upperLeft_m - wall_.lowerLeft_m);
    const glm::dvec3 normal = glm::cross(right, up);
    const double share = glm::dot(wall_.lowerLeft_m - eye_m_, normal) / glm::dot(place_m - eye_m_, normal);
    const glm::dvec3 on_m = eye_m_ + share * (place_m - eye_m_) - wall_.lowerLeft_m;
    return glm::dvec2(glm::dot(on_m, right) / 3.0, glm::dot(on_m, up) / 2.0) * glm::dvec2(wall_.pixels);
  }

  Image drawn(const FrameRecord& record) {
    graphics_.makeCurrent();
    RenderTarget picture(wall_.pixels);
    aids_.draw(room_, wall_, isFront_, eye_m_, record, picture);
    return readBack(picture);
  }

  /// The head there; no sensor known.
  static FrameRecord headAt(const glm::dvec3& place_m) {
    FrameRecord record;
    record.viewers[0].observer.middle.positionInRoom_m = place_m;
    return record;
  }

  static Rgb at(const Image& image, const glm::dvec2& pixel) {
    const auto x = static_cast<std::size_t>(pixel.x), y = static_cast<std::size_t>(pixel.y);
    const std::size_t i = 3 * (y * static_cast<std::size_t>(image.size_px.x) + x);
    return {image.rgb.at(i), image.rgb.at(i + 1), image.rgb.at(i + 2)};
  }

  static int brightest(const Image& image) { return *std::max_element(image.rgb.begin(), image.rgb.end()); }

  Graphics graphics_;
  RoomOverlay aids_;
  RoomGeometry room_;
  Wall wall_ = leaningWall();
  glm::dvec3 eye_m_ = place(1.2, 1.1, 1.4);
  bool isFront_ = false;
};

TEST_F(RoomOverlayPicture, TheGridComesWithTheHeadAndWithTheHand) {
  EXPECT_EQ(brightest(drawn(headAt(place(1.5, 1.0, 0.61)))), 0);
  const int faint = brightest(drawn(headAt(place(1.5, 1.0, 0.45))));
  const int full = brightest(drawn(headAt(place(1.5, 1.0, 0.30))));
  EXPECT_GT(faint, 60);
  EXPECT_GT(full, faint + 40);
  EXPECT_EQ(full, brightest(drawn(headAt(place(1.5, 1.0, 0.05)))));
  // Beside the wall, near its plane but far from the screen.
  EXPECT_EQ(brightest(drawn(headAt(place(-0.7, 1.0, 0.05)))), 0);

  FrameRecord record = headAt(place(1.5, 1.0, 1.4));
  record.viewers[0].tracked.roomFromHand.position_m = place(0.6, 0.5, 0.2);
  EXPECT_EQ(brightest(drawn(record)), 0) << "a hand that no tracker knows";
  record.viewers[0].tracked.handKnown = 1;
  const Image image = drawn(record);
  EXPECT_GT(brightest(image), full - 2);
  EXPECT_EQ(at(image, {500.0, 300.0}), (Rgb{0, 0, 0})) << "1.9 m from the hand";
}

// Crossings of its lines and middles of its cells, as this eye sees those places of the wall's plane.
TEST_F(RoomOverlayPicture, TheGridsLinesAreTenCentimetresApartOnTheWall) {
  const Image image = drawn(headAt(place(1.5, 1.0, 0.2)));
  for (int x = 13; x <= 17; ++x) {
    for (int y = 8; y <= 12; ++y) {
      const Rgb line = at(image, pixelOf(place(0.1 * x, 0.1 * y, 0.0)));
      EXPECT_GT(line[0], 120) << x << ", " << y;
      EXPECT_GT(line[0], line[2] + 100) << "amber";
      EXPECT_LT(at(image, pixelOf(place(0.1 * x + 0.05, 0.1 * y + 0.05, 0.0)))[0], 5) << x << ", " << y;
    }
  }
  EXPECT_EQ(at(image, pixelOf(place(0.7, 1.0, 0.0))), (Rgb{0, 0, 0})) << "beyond its reach";
}

TEST_F(RoomOverlayPicture, CrossesSitOnTheSensors) {
  FrameRecord record = headAt(place(1.5, 1.0, 1.5));
  record.viewers[0].tracked.handKnown = record.viewers[0].tracked.headKnown = 1;
  const glm::dquat turned = glm::normalize(glm::dquat(0.9, 0.2, -0.3, 0.1));
  record.viewers[0].tracked.roomFromHand = {place(0.8, 0.7, 0.6), turned};
  record.viewers[0].tracked.roomFromHeadSensor = {place(2.2, 1.3, 0.4), turned};
  EXPECT_EQ(brightest(drawn(record)), 0) << "not asked for";
  record.controls.trackerCross = 1;
  room_.forward = {0.0, 0.0, -1.0};
  for (const double aside_m : {-0.032, 0.032}) {  // for each eye
    eye_m_ = place(1.2 + aside_m, 1.1, 1.4);
    const Image image = drawn(record);
    for (const Pose& sensor :
         {record.viewers[0].tracked.roomFromHand, record.viewers[0].tracked.roomFromHeadSensor}) {
      for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 on_m(0.0);
        on_m[axis] = 0.085;  // near the arm's end, where no other covers it
        const Rgb seen = at(image, pixelOf(sensor * on_m));
        for (int other = 0; other < 3; ++other) {
          if (other == axis) continue;
          EXPECT_GT(seen[axis], seen[other] + 80) << "axis " << axis;
        }
        on_m[axis] = 0.12;  // beyond it
        const Rgb beyond = at(image, pixelOf(sensor * on_m));
        EXPECT_EQ(beyond, (Rgb{0, 0, 0})) << "axis " << axis;
      }
    }
  }
}

TEST_F(RoomOverlayPicture, OneCrossIsBeforeTheEyes) {
  FrameRecord record = headAt(place(1.5, 1.0, 1.5));
  record.controls.trackerCross = record.viewers[0].tracked.headKnown = 1;
  record.viewers[0].tracked.roomFromHeadSensor.position_m = place(1.5, 1.0, 1.6);
  const glm::dvec3 towards = glm::normalize(place(1.7, 1.1, 0.0) - place(1.5, 1.0, 1.5));
  room_.forward = towards;
  eye_m_ = place(1.5, 1.0, 1.5);
  const Rgb seen = at(drawn(record), pixelOf(eye_m_ + towards));
  EXPECT_GT(*std::max_element(seen.begin(), seen.end()), 150);
}

// By similar triangles: a bar `off` before a wall at distance d moves across it by −e·off/(d − off) for an
// eye that is e beside the middle.
TEST_F(RoomOverlayPicture, TheBarsDifferInParallaxAlone) {
  isFront_ = true;
  constexpr double kFar_m = 1.4, kPerMetre = 200.0;
  FrameRecord record = headAt(place(1.5, 1.0, kFar_m));
  record.controls.trackerCross = 1;
  const auto middles = [&](double aside_m) {
    eye_m_ = place(1.5 + aside_m, 1.0, kFar_m);
    const Image image = drawn(record);
    std::array<double, 2> sum{}, count{};
    for (int x = 0; x < 600; ++x) {
      const Rgb seen = at(image, {x, 0.46 * 400});
      sum[x < 300 ? 0 : 1] += seen[0] * (x + 0.5);
      count[x < 300 ? 0 : 1] += seen[0];
    }
    EXPECT_NEAR(count[0], count[1], 0.03 * count[0]) << "equally wide";
    return std::array<double, 2>{sum[0] / count[0], sum[1] / count[1]};
  };
  for (const double aside_m : {-0.032, 0.0, 0.032}) {
    const auto [left, right] = middles(aside_m);
    EXPECT_NEAR(left, 0.42 * 600 + kPerMetre * aside_m * 0.3 / (kFar_m + 0.3), 0.1) << aside_m;
    EXPECT_NEAR(right, 0.58 * 600 - kPerMetre * aside_m * 0.3 / (kFar_m - 0.3), 0.1) << aside_m;
  }
}

}  // namespace
}  // namespace carom
