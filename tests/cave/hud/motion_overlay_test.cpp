// The compass on the floor as pixels, against where its lines must be in the room; and its numbers in words.
#include "cave/hud/motion_overlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>

#include "cave/display/window.h"
#include "cave/gl/view_colours.h"
#include "cave/overlay/hud_panel.h"
#include "cave/pictures/image.h"

namespace carom {
namespace {

constexpr double kC_m_s = 1.42, kPixelsPerMetre = 400.0;

Wall wallAt(const char* name, const glm::dvec3& lowerLeft_m, const glm::dvec3& lowerRight_m,
            const glm::dvec3& upperLeft_m) {
  Wall wall;
  wall.name = name;
  wall.lowerLeft_m = lowerLeft_m;
  wall.lowerRight_m = lowerRight_m;
  wall.upperLeft_m = upperLeft_m;
  wall.pixels = {1200, 1200};
  return wall;
}

const Wall kFront = wallAt("front", {-1.5, 0.0, -1.5}, {1.5, 0.0, -1.5}, {-1.5, 3.0, -1.5});
const Wall kFloor = wallAt("floor", {-1.5, 0.0, 1.5}, {1.5, 0.0, 1.5}, {-1.5, 0.0, -1.5});

RoomGeometry roomOf(std::vector<Wall> walls) {
  RoomGeometry room;
  room.walls = std::move(walls);
  return room;
}

FrameRecord moving(const Vec3& beta) {
  FrameRecord record;
  // The room is turned by 0.7 about its up: what is drawn goes by the room's axes, not the board's.
  const glm::dquat turn = glm::angleAxis(0.7, Vec3(0.0, 1.0, 0.0));
  record.boardFromRoom = Lorentz::boost(uFromBeta(turn * beta), kC_m_s) * Lorentz::rotation(turn, kC_m_s);
  return record;
}

class Compass : public testing::Test {
 protected:
  Image drawn(const FrameRecord& record) {
    graphics_.makeCurrent();
    RenderTarget picture(kFloor.pixels);
    aid_.draw(roomOf({kFront, kFloor}), kFloor, {0.1, 1.7, 0.5}, record, picture);
    return readBack(picture);
  }

  /// On the floor's picture, what is there (metres to the right and ahead of the middle): its lines lie in
  /// that wall's plane, so for every eye at its own place.
  static glm::vec3 at(const Image& image, double right_m, double ahead_m) {
    const glm::dvec3 middle_m = MotionOverlay::middle_m(roomOf({kFront, kFloor}));
    const auto x = static_cast<std::size_t>(std::lround((middle_m.x + right_m + 1.5) * kPixelsPerMetre));
    const auto y = static_cast<std::size_t>(std::lround((1.5 - middle_m.z + ahead_m) * kPixelsPerMetre));
    const std::size_t i = 3 * (y * static_cast<std::size_t>(image.size_px.x) + x);
    return {image.rgb.at(i) / 255.0F, image.rgb.at(i + 1) / 255.0F, image.rgb.at(i + 2) / 255.0F};
  }

  static void expectColour(const glm::vec3& seen, const glm::vec3& colour, const char* what) {
    EXPECT_LT(glm::distance(seen, colour), 0.1F) << what << ": " << seen.x << ' ' << seen.y << ' ' << seen.z;
  }

  Graphics graphics_;
  MotionOverlay aid_;
};

TEST_F(Compass, IsThereOnlyWhileThereIsSomethingToShow) {
  const auto brightest = [](const Image& image) {
    return *std::max_element(image.rgb.begin(), image.rgb.end());
  };
  EXPECT_EQ(brightest(drawn(moving(Vec3(0.0)))), 0);
  EXPECT_GT(brightest(drawn(moving({0.1, 0.0, 0.0}))), 200);
  FrameRecord thrusting = moving(Vec3(0.0));
  thrusting.drive.thrust = {0.0, 0.0, -0.5};
  EXPECT_GT(brightest(drawn(thrusting)), 200);
}

TEST_F(Compass, TheArrowIsBetaAndTheEllipseIsContractedAlongIt) {
  const double r_m = MotionOverlay::kRadius_m;
  for (const double beta : {0.6, 0.95}) {
    const double short_m = r_m * std::sqrt(1.0 - beta * beta);
    for (const glm::dvec2& way :
         {glm::dvec2(1.0, 0.0), glm::dvec2(0.0, -1.0), glm::normalize(glm::dvec2(-1.0, 2.0))}) {
      SCOPED_TRACE(testing::Message() << "β " << beta << " to the right " << way.x << ", ahead " << way.y);
      const Image image = drawn(moving({beta * way.x, 0.0, -beta * way.y}));
      const glm::dvec2 across(-way.y, way.x);
      const auto on = [&](double along_m, double across_m) {
        const glm::dvec2 place_m = along_m * way + across_m * across;
        return at(image, place_m.x, place_m.y);
      };
      expectColour(on(0.5 * beta * r_m, 0.0), kMotionColour, "the arrow");
      expectColour(on(beta * r_m - 0.004, 0.0), kMotionColour, "its tip");
      EXPECT_LT(glm::length(on(-0.5 * short_m, 0.0)), 0.2F) << "there is no arrow behind";
      expectColour(on(-short_m, 0.0), kContractedColour, "the ellipse's end");
      expectColour(on(0.0, 0.999 * r_m), kContractedColour, "the ellipse's side");
      expectColour(on(-r_m, 0.0), glm::vec3(0.95F), "the circle");
    }
  }
}

TEST_F(Compass, ThrustIsRedAtTheLimit) {
  FrameRecord record = moving(Vec3(0.0));
  record.drive.thrust = {1.0, 0.0, 0.0};
  expectColour(at(drawn(record), 0.15, 0.0), kThrustColour, "thrust");
  record.drive.atLimit = 1;
  expectColour(at(drawn(record), 0.15, 0.0), kLimitColour, "the strongest");
}

TEST_F(Compass, StandsClearOfTheFrontWall) {
  const glm::dvec3 middle_m = MotionOverlay::middle_m(roomOf({kFront, kFloor}));
  EXPECT_NEAR(middle_m.x, 0.0, 1e-12);
  EXPECT_NEAR(middle_m.y, 0.0, 1e-12);
  EXPECT_NEAR(middle_m.z, -1.5 + MotionOverlay::kClear_m + MotionOverlay::kRadius_m, 1e-12);
}

// Through the only screen: all of it, from before its middle, in its lower right quarter.
TEST_F(Compass, InARoomWithoutAFloorIsSeenThroughTheScreensCorner) {
  const RoomGeometry room = roomOf({kFront});
  const glm::dvec3 middle_m = MotionOverlay::middle_m(room), eye_m(0.0, 1.7, 0.0);
  for (int i = 0; i < 16; ++i) {
    const double angle_rad = 0.125 * std::numbers::pi * i;
    const glm::dvec3 way(std::cos(angle_rad), 0.0, std::sin(angle_rad));
    const glm::dvec3 rim_m = middle_m + MotionOverlay::radius_m(room) * way;
    const glm::dvec3 on_m = eye_m + (rim_m - eye_m) * (-1.5 / rim_m.z);
    EXPECT_GT(on_m.x, 0.5) << i;
    EXPECT_LT(on_m.x, 1.5) << i;
    EXPECT_GT(on_m.y, -1e-9) << i;
    EXPECT_LT(on_m.y, 0.5) << i;
  }
}

TEST(CompassInWords, SaysHowFastAndHowContracted) {
  const auto says = [](const FrameRecord& record, const std::string& words) {
    std::vector<HudLine> lines;
    describe(record, {}, {}, {}, kPanelRoom, lines);
    return std::any_of(lines.begin(), lines.end(),
                       [&](const HudLine& line) { return line.text.find(words) != std::string::npos; });
  };
  FrameRecord record = moving({0.0, 0.0, -0.6});
  record.drive = {.thrust = {0.3, 0.0, 0.4}, .mode = DriveMode::home};
  EXPECT_TRUE(says(record, "0.600 c, γ = 1.25"));
  EXPECT_TRUE(says(record, "contracted to 0.80"));
  EXPECT_TRUE(says(record, "thrust: 50 % of maximum (returning home)"));
  EXPECT_FALSE(says(moving(Vec3(0.0)), "γ"));
  EXPECT_FALSE(says(moving({0.6, 0.0, 0.0}), "thrust")) << "none, and nobody asks for any";
}

}  // namespace
}  // namespace carom
