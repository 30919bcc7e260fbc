// The ray, the cue and the scale of its cost as pixels, against lines of sight cut with the wall's plane.
#include "cave/overlay/cue_overlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "cave/display/window.h"
#include "cave/pictures/image.h"

namespace carom {
namespace {

using Rgb = std::array<int, 3>;
constexpr glm::dvec3 kEyes_m(0.1, 1.7, 0.4);

/// 3 × 2 m, 1.5 m before the origin; 2.5 mm a pixel. x right, y up.
Wall frontWall() {
  Wall wall;
  wall.lowerLeft_m = {-1.5, 0.0, -1.5};
  wall.lowerRight_m = {1.5, 0.0, -1.5};
  wall.upperLeft_m = {-1.5, 2.0, -1.5};
  wall.pixels = {1200, 800};
  return wall;
}

/// A wand that has a puck on the table drawn back for, towards the right and away.
FrameRecord pulling(double beta) {
  FrameRecord record;
  for (EyeView* eye : {&record.viewers[0].observer.left, &record.viewers[0].observer.right,
                       &record.viewers[0].observer.middle})
    eye->positionInRoom_m = kEyes_m;
  HandView& hand = record.viewers[0].hand;
  hand.shown = hand.pulling = 1;
  hand.target = 1;
  hand.from_m = {0.4, 1.1, 0.0};
  hand.target_m = {-0.1, 0.85, -1.9};
  hand.to_m = hand.target_m + glm::dvec3(0.0, 0.01, 0.03);
  hand.towards = glm::normalize(glm::dvec3(0.8, 0.0, -0.6));
  hand.u = beta / std::sqrt(1.0 - beta * beta);
  return record;
}

class CueOverlayPicture : public testing::Test {
 protected:
  Image drawn(const FrameRecord& record) {
    graphics_.makeCurrent();
    RenderTarget picture(wall_.pixels);
    aids_.draw(room_, wall_, eye_m_, record, picture);
    return readBack(picture);
  }

  glm::dvec2 pixelOf(const glm::dvec3& place_m) const {
    const glm::dvec3 on_m = eye_m_ + (place_m - eye_m_) * ((-1.5 - eye_m_.z) / (place_m.z - eye_m_.z));
    return glm::dvec2((on_m.x + 1.5) / 3.0, on_m.y / 2.0) * glm::dvec2(wall_.pixels);
  }

  Rgb at(const Image& image, const glm::dvec3& place_m) const {
    const glm::ivec2 pixel = glm::floor(pixelOf(place_m));
    const auto i = 3 * static_cast<std::size_t>(pixel.y * image.size_px.x + pixel.x);
    return {image.rgb.at(i), image.rgb.at(i + 1), image.rgb.at(i + 2)};
  }

  static long lit(const Image& image) {
    return std::count_if(image.rgb.begin(), image.rgb.end(), [](int value) { return value > 40; });
  }

  Graphics graphics_;
  CueOverlay aids_;
  RoomGeometry room_;
  Wall wall_ = frontWall();
  glm::dvec3 eye_m_ = kEyes_m;
};

TEST_F(CueOverlayPicture, WithoutAHandNothingIsDrawn) {
  FrameRecord record = pulling(0.8);
  record.viewers[0].hand.shown = 0;
  EXPECT_EQ(lit(drawn(record)), 0);
}

TEST_F(CueOverlayPicture, TheRayEndsWhereItPointsForEachEye) {
  FrameRecord record = pulling(0.8);
  record.viewers[0].hand.pulling = 0;
  record.viewers[0].hand.target = 0;
  for (const double aside_m : {-0.032, 0.032}) {
    eye_m_ = kEyes_m + glm::dvec3(aside_m, 0.0, 0.0);
    const Image idle = drawn(record);
    const glm::dvec3 way_m = record.viewers[0].hand.to_m - record.viewers[0].hand.from_m;
    for (const double share : {0.3, 0.6, 0.9}) {
      EXPECT_GT(at(idle, record.viewers[0].hand.from_m + share * way_m)[2], 70) << share;
      EXPECT_LT(at(idle, record.viewers[0].hand.from_m + share * way_m + glm::dvec3(0.0, 0.05, 0.0))[2], 5)
          << share;
    }
    EXPECT_GT(at(idle, record.viewers[0].hand.to_m)[2], 70);
    EXPECT_EQ(at(idle, record.viewers[0].hand.from_m + 1.1 * way_m), (Rgb{0, 0, 0})) << "beyond its end";
  }
}

TEST_F(CueOverlayPicture, AimedAtAPuckTheRayIsBrighterAndTheTargetRinged) {
  FrameRecord record = pulling(0.8);
  record.viewers[0].hand.pulling = 0;
  const auto onRay = [&] {
    return at(drawn(record), 0.5 * (record.viewers[0].hand.from_m + record.viewers[0].hand.to_m));
  };
  record.viewers[0].hand.target = 0;
  const Rgb idle = onRay();
  const long idleLit = lit(drawn(record));
  record.viewers[0].hand.target = 1;
  EXPECT_GT(onRay()[0], idle[0] + 80);
  EXPECT_GT(lit(drawn(record)), idleLit + 300);
  const Image image = drawn(record);
  const FacingPlane plane = facing(record.viewers[0].hand.target_m, kEyes_m, room_);
  for (int i = 0; i < 8; ++i) {
    const double angle = 0.1 + i;
    const glm::dvec3 ring_m = std::cos(angle) * plane.right + std::sin(angle) * plane.up;
    EXPECT_GT(at(image, record.viewers[0].hand.target_m + CueOverlay::kRing_m * ring_m)[0], 120) << i;
  }
}

TEST_F(CueOverlayPicture, ALargePuckIsWithinItsRingAndBeforeItsCue) {
  const double rim_m = 0.2;
  FrameRecord record = pulling(0.6);
  const auto behind = [&](double by_m) {
    return record.viewers[0].hand.target_m - by_m * record.viewers[0].hand.towards;
  };
  const double small_m = CueOverlay::kRim_m + CueOverlay::kDrawn_m * record.viewers[0].hand.u;
  EXPECT_GT(at(drawn(record), behind(small_m + 0.05))[0], 150) << "the cue at a small puck";
  aids_.setRims({0.0, rim_m});
  EXPECT_LT(at(drawn(record), behind(small_m + 0.05))[0], 60) << "the large puck is there";
  EXPECT_GT(at(drawn(record), behind(small_m + rim_m))[0], 150);
  record.viewers[0].hand.pulling = 0;
  const Image image = drawn(record);
  const FacingPlane plane = facing(record.viewers[0].hand.target_m, kEyes_m, room_);
  for (int i = 0; i < 8; ++i) {
    const double angle = 0.1 + i;
    const glm::dvec3 ring_m = std::cos(angle) * plane.right + std::sin(angle) * plane.up;
    EXPECT_GT(at(image, record.viewers[0].hand.target_m + (rim_m + CueOverlay::kBeside_m) * ring_m)[0], 120)
        << i;
  }
}

TEST_F(CueOverlayPicture, OnesOwnRayIsAPoint) {
  FrameRecord record = pulling(0.8);
  record.viewers[0].hand.pulling = 0;
  record.viewers[0].hand.target = 0;
  record.viewers[0].hand.from_m = kEyes_m + glm::dvec3(0.032, 0.0, 0.0);
  eye_m_ = kEyes_m - glm::dvec3(0.032, 0.0, 0.0);
  const Image image = drawn(record);
  EXPECT_GT(at(image, record.viewers[0].hand.to_m)[2], 70);
  EXPECT_LT(lit(image), 3 * 200);
}

TEST_F(CueOverlayPicture, TheCueIsBehindThePuckAsFarAsItIsPulled) {
  for (const double beta : {0.6, 0.8, 0.9}) {
    const FrameRecord record = pulling(beta);
    const Image image = drawn(record);
    const double tip_m = CueOverlay::kRim_m + CueOverlay::kDrawn_m * record.viewers[0].hand.u;
    const auto behind = [&](double by_m) {
      return record.viewers[0].hand.target_m - by_m * record.viewers[0].hand.towards;
    };
    const Rgb wood = at(image, behind(tip_m + 0.3));
    EXPECT_GT(wood[0], 150) << beta;
    EXPECT_GT(wood[0], wood[2] + 60) << beta;
    EXPECT_LT(at(image, behind(tip_m - 0.06))[0], 60) << beta << ": the gap";
  }
}

TEST_F(CueOverlayPicture, ACueThatIsNotYetDrawnBackGoesNowhere) {
  FrameRecord record = pulling(0.0);
  record.viewers[0].hand.towards = glm::dvec3(0.0);
  const long without = lit(drawn(record));
  record.viewers[0].hand.towards = {0.0, 0.0, -1.0};
  const Image touching = drawn(record);
  EXPECT_GT(lit(touching), without + 300) << "the cue";
  EXPECT_LT(at(touching, record.viewers[0].hand.target_m + glm::dvec3(0.0, 0.0, -0.15))[1], 40) << "no arrow";
}

TEST_F(CueOverlayPicture, TheScalesHeightIsTheCost) {
  for (const double beta : {-0.5, 0.5, 0.8, 0.9, 0.95}) {  // below 0: to the left
    FrameRecord record = pulling(std::abs(beta));
    record.viewers[0].hand.towards.x = std::copysign(record.viewers[0].hand.towards.x, beta);
    const Image image = drawn(record);
    const FacingPlane plane = facing(record.viewers[0].hand.target_m, kEyes_m, room_);
    const double cost = 1.0 / std::sqrt(1.0 - beta * beta) - 1.0;
    EXPECT_NEAR(CueOverlay::heightOf(cost), CueOverlay::kPerCost * cost, 1e-12);
    const auto bar = [&](double of) {
      return at(image, plane.at(beta > 0.0 ? CueOverlay::kScaleLeft : CueOverlay::kScaleRight,
                                CueOverlay::scaleFoot(plane, kEyes_m, room_) + CueOverlay::kPerCost * of));
    };
    const Rgb full = bar(cost - 0.06), empty = bar(cost + 0.06);
    EXPECT_GT(*std::max_element(full.begin(), full.end()), 170) << beta;
    EXPECT_LT(*std::max_element(empty.begin(), empty.end()), 110) << beta;
  }
  EXPECT_EQ(CueOverlay::heightOf(9.0), CueOverlay::heightOf(CueOverlay::kMostCost));
}

// A puck may lie near the lower rim of a wall.
TEST_F(CueOverlayPicture, WithAForceTheScaleEndsNoLower) {
  FrameRecord record = pulling(0.6);
  record.viewers[0].hand.towards = {-1.0, 0.0, 0.0};  // the scale is on the other side
  const auto lowestOf = [&](const Image& image) {
    const auto of = [&](double across) {
      const FacingPlane target = facing(record.viewers[0].hand.target_m, kEyes_m, room_);
      const double foot = CueOverlay::scaleFoot(target, kEyes_m, room_);
      return static_cast<int>(pixelOf(target.at(CueOverlay::kScaleRight + across, foot)).x);
    };
    for (int y = 0; y < image.size_px.y; ++y) {
      for (int x = of(0.0); x < of(0.1); ++x) {
        if (image.rgb.at(3 * static_cast<std::size_t>(y * image.size_px.x + x)) > 150) return y;
      }
    }
    return image.size_px.y;
  };
  const int plain = lowestOf(drawn(record));
  record.viewers[0].force.shown = 1;
  record.viewers[0].force.scale = 0.5;
  const int withForce = lowestOf(drawn(record));
  EXPECT_LT(plain, wall_.pixels.y);
  EXPECT_GE(withForce, plain - 8) << "rows from below; the last line is small";
  EXPECT_LE(withForce, plain + 30);
}

// Its lowest line is seen over all that lies on a table, 0.9 m below the eyes, up to 2.6 m away.
TEST_F(CueOverlayPicture, TheScaleStandsOverTheTable) {
  for (const glm::dvec3& from_m : {glm::dvec3(0.1, -0.9, -0.7), glm::dvec3(-0.8, -0.9, -1.5)}) {
    const FacingPlane target = facing(kEyes_m + from_m, kEyes_m, room_);
    const double readout = 0.08;
    const glm::dvec3 lowest_m =
        target.at(0.0, CueOverlay::scaleFoot(target, kEyes_m, room_) - readout) - kEyes_m;
    EXPECT_GT(lowest_m.y / std::hypot(lowest_m.x, lowest_m.z), -0.9 / 2.6) << from_m.x;
  }
}

TEST_F(CueOverlayPicture, TheScaleIsUprightAndEquallyLargeEverywhere) {
  for (const glm::dvec3& place_m : {glm::dvec3(0.3, 0.8, -1.0), glm::dvec3(-2.0, 0.8, -5.0)}) {
    const FacingPlane plane = facing(place_m, kEyes_m, room_);
    EXPECT_NEAR(glm::dot(plane.right, room_.up), 0.0, 1e-12);
    EXPECT_NEAR(glm::dot(plane.right, plane.up), 0.0, 1e-12);
    EXPECT_GT(glm::dot(plane.up, room_.up), 0.9);
    const glm::dvec3 normal = glm::cross(plane.right, plane.up), sight = glm::normalize(kEyes_m - place_m);
    EXPECT_GT(glm::dot(normal, sight), 0.8) << "to be read";
    EXPECT_NEAR(glm::length(plane.at(0.0, 0.1) - place_m) / glm::distance(place_m, kEyes_m), 0.1, 1e-12);
  }
  const FacingPlane below = facing(kEyes_m - glm::dvec3(0.0, 1.0, 0.0), kEyes_m, room_);
  EXPECT_NEAR(glm::length(below.right), 1.0, 1e-12);
  EXPECT_NEAR(below.right.x, 1.0, 1e-12);
  EXPECT_GT(glm::cross(below.right, below.up).y, 0.8) << "it lies as on a desk";
}

}  // namespace
}  // namespace carom
