// The force of a drawn cue: along the draw in the plane of the cloth, and of the size that the law says.
#include "devices/force/force_loop.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <glm/geometric.hpp>

namespace carom {
namespace {

constexpr double kTick_s = 1e-3;

/// A hand that draws a cue along a straight way, slowly.
class Draw {
 public:
  explicit Draw(const glm::dvec3& up) {
    law_.kind = ForceLaw::Kind::cue;
    law_.cue = {0.403, 0.08, 1.0};
    law_.up = up;
    law_.held = true;
  }
  ForceCommand to(const glm::dvec3& place_m) {
    constexpr int kTicks = 400;
    const glm::dvec3 from_m = device_.position_m;
    ForceCommand command;
    for (int i = 1; i <= kTicks; ++i) {
      now_s_ += kTick_s;
      device_.position_m = from_m + std::min(1.0, i / 300.0) * (place_m - from_m);
      law_.posted_s = device_.time_s = now_s_;
      command = loop.tick(now_s_, device_, law_);
      device_.held_n = command.force_n;
    }
    return command;
  }
  /// Releases the button for a tick.
  void release() {
    law_.held = false;
    to(device_.position_m);
    law_.held = true;
  }

  ForceLoop loop{ForceLimits{}};

 private:
  double now_s_ = 0.0;
  ForceDeviceState device_;
  ForceLaw law_;
};

TEST(ForceLoop, ADrawPullsBackInThePlaneOfTheCloth) {
  const CueForce cue{0.403, 0.08, 1.0};
  for (const glm::dvec3& up : {glm::dvec3(0, 1, 0), glm::dvec3(0.6, 0.8, 0.0)}) {
    Draw draw(up);
    draw.to({0.0, 0.0, 0.0});
    const glm::dvec3 place_m(-0.05, 0.03, -0.04);
    const ForceCommand command = draw.to(place_m);
    const glm::dvec3 drawn_m = place_m - glm::dot(place_m, up) * up;
    const double size_m = glm::length(drawn_m), force_n = cue.force_n(size_m);
    EXPECT_LT(glm::distance(draw.loop.report().draw_m, drawn_m), 1e-12);
    EXPECT_LT(glm::distance(command.force_n, -force_n * drawn_m / size_m), 1e-9);
    EXPECT_NEAR(draw.loop.report().energy_j, cue.energy_j(size_m), 1e-12);
    EXPECT_EQ(command.at_m, place_m);
    // The stiffness is the derivative of the force, by differences.
    constexpr double kStep_m = 1e-6;
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 step_m(0.0);
      step_m[axis] = kStep_m;
      const auto forceAt = [&](const glm::dvec3& at_m) {
        const glm::dvec3 flat_m = at_m - glm::dot(at_m, up) * up;
        return -cue.force_n(glm::length(flat_m)) * flat_m / glm::length(flat_m);
      };
      const glm::dvec3 slope = (forceAt(place_m + step_m) - forceAt(place_m - step_m)) / (2.0 * kStep_m);
      EXPECT_LT(glm::distance(command.stiffness_n_m[axis], slope), 1e-4) << axis;
    }
  }
}

// A draw begins where the button goes down.
TEST(ForceLoop, AReleasedCueIsDrawnAnew) {
  Draw draw({0.0, 1.0, 0.0});
  draw.to({0.0, 0.0, 0.0});
  EXPECT_GT(glm::length(draw.to({-0.06, 0.0, 0.0}).force_n), 1.0);
  draw.release();
  EXPECT_EQ(draw.loop.report().force_n, glm::dvec3(0.0));
  EXPECT_EQ(draw.to({-0.06, 0.0, 0.0}).force_n, glm::dvec3(0.0));
  const glm::dvec3 force_n = draw.to({-0.06, 0.0, 0.03}).force_n;
  EXPECT_NEAR(force_n.z, -CueForce({0.403, 0.08, 1.0}).force_n(0.03), 1e-9);
  EXPECT_NEAR(force_n.x, 0.0, 1e-9);
}

}  // namespace
}  // namespace carom
