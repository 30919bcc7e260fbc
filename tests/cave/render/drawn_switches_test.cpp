// The switches in whole pictures: where a shining puck is drawn, and in which colour.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "cave/glowing_puck.h"
#include "cave/render/wall_renderer.h"
#include "cave/room/off_axis.h"
#include "engine/colour/doppler_colour.h"
#include "engine/colour/exposure.h"
#include "engine/colour_reference.h"
#include "engine/light_speed.h"

namespace carom {
namespace {

using test::Box;
using test::kC_m_s;

constexpr double kScreenSteps = 3.0;  // 1.5 for the shader's sRGB curve, the rest for the table and rounding
const glm::ivec2 kPicture_px{600, 600};

class DrawnSwitches : public testing::Test {
 protected:
  /// The puck, drawn for an eye at the origin at board time `t_s` on a wall in front of it (y).
  Image draw(const WorldLine& line, const Scene& scene, double t_s, const Switches& switches,
             const Lorentz& headFromBoard = Lorentz(kC_m_s)) {
    WallRenderer renderer(graphics_, scene, kC_m_s, 1);
    const EyeView eye{{t_s, Vec3(0.0)}, Vec3(0.0)};
    std::array<BodyView, 2> views;
    viewBody(WorldLine(Knot{}, kC_m_s), eye.observation, headFromBoard, views[0], switches);
    viewBody(line, eye.observation, headFromBoard, views[1], switches);
    RenderTarget picture(kPicture_px);
    renderer.look(headFromBoard, eye, views, switches);
    EXPECT_TRUE(renderer.draw(wall_, eye.positionInRoom_m, picture));
    return readBack(picture);
  }

  /// Where the puck's vertices come to lie that are drawn at `centre_m` + `shape` times their offsets.
  Box boxOf(const Scene& scene, const Vec3& centre_m, const Vec3& shape) const {
    const glm::dmat4 clip = *clipFromEye(wall_, Vec3(0.0));
    Box box{1e9, -1e9, 1e9, -1e9};
    for (const ScenePart& part : scene.parts) {
      for (vtkIdType i = 0; i < part.mesh->GetNumberOfPoints(); ++i) {
        const double* p = part.mesh->GetPoint(i);
        const glm::dvec4 at = clip * glm::dvec4(centre_m + shape * Vec3(p[0], p[1], p[2]), 1.0);
        test::include(box, (at.x / at.w + 1.0) * 0.5 * kPicture_px.x,
                      (at.y / at.w + 1.0) * 0.5 * kPicture_px.y);
      }
    }
    return box;
  }

  void expectBox(const Image& image, const Box& expected) const {
    const Box lit = test::litBox(image);
    for (std::size_t side = 0; side < 4; ++side)
      EXPECT_NEAR(lit[side], expected[side], test::kLitBox_px) << side;
  }

  Graphics graphics_;
  const Wall wall_ = test::wallTowards({0, 0, 0}, {0, 1, 0}, kPicture_px);
};

WorldLine straight(const Vec3& atZero_m, const Vec3& beta) {
  return {{{0.0, atZero_m}, uFromBeta(beta), 0.0, {}, 0.0}, kC_m_s, 0.3};
}

// An eye at rest, a puck that passes 2 m ahead at 0.9 c: without retardation it is drawn where it is now.
TEST_F(DrawnSwitches, WithoutRetardationPucksAreDrawnWhereTheyAre) {
  const Scene scene = test::glowingPuck(0.25);
  const WorldLine line = straight({0.0, 2.0, 0.0}, {0.9, 0.0, 0.0});
  const double contraction = std::sqrt(1.0 - 0.81);
  for (const double t_s : {-0.4, 0.0, 0.5}) {
    const Vec3 now_m(0.9 * kC_m_s * t_s, 2.0, 0.0);
    expectBox(draw(line, scene, t_s, {0, 1, 1}), boxOf(scene, now_m, {contraction, 1.0, 1.0}));
    expectBox(draw(line, scene, t_s, {0, 0, 1}), boxOf(scene, now_m, Vec3(1.0)));
    expectBox(draw(line, scene, t_s, kNoSwitches), boxOf(scene, now_m, Vec3(1.0)));
    // With it, light of the centre left when c (t_o − t) was its distance.
    const Box delayed = test::litBox(draw(line, scene, t_s, {}));
    EXPECT_LT(delayed[1], boxOf(scene, now_m, Vec3(1.0))[0]) << "seen farther back on its way";
  }
}

// An eye that moves at 0.6 c past a puck at rest: without aberration the picture is that of an eye at rest.
TEST_F(DrawnSwitches, WithoutAberrationTheHeadsMotionShowsNot) {
  const Scene scene = test::glowingPuck(0.25);
  const WorldLine line = straight({0.2, 2.0, 0.1}, Vec3(0.0));
  const Lorentz moving = Lorentz::boost(uFromBeta({-0.6, 0.0, 0.0}), kC_m_s);
  expectBox(draw(line, scene, 0.0, {1, 1, 0}, moving), boxOf(scene, {0.2, 2.0, 0.1}, Vec3(1.0)));
  const Box turned = test::litBox(draw(line, scene, 0.0, {}, moving));
  EXPECT_GT(turned[0], boxOf(scene, {0.2, 2.0, 0.1}, Vec3(1.0))[1]) << "seen farther ahead";
}

/// What the screen is told of linear light under an exposure for an eye at rest.
glm::ivec3 onScreen(const Vec3& linear, const Switches& s) {
  const Exposure e = exposureFor(0.0, s.colour != 0, s.searchlight != 0);
  glm::ivec3 steps{0};
  for (int i = 0; i < 3; ++i) {
    const double x = std::max(e.gain * linear[i], 0.0);
    steps[i] =
        static_cast<int>(std::lround(255.0 * test::encoded(x * (1.0 + e.rise * x) / (1.0 + e.fall * x))));
  }
  return steps;
}

glm::ivec3 middleOf(const Image& image) {
  const std::size_t at = 3 * (static_cast<std::size_t>(image.size_px.y / 2) * image.size_px.x +
                              static_cast<std::size_t>(image.size_px.x / 2));
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

// Straight ahead, D = sqrt((1 + β)/(1 − β)) for an approach at β. The colour is the engine's integral over
// the spectrum; searchlight multiplies by D⁴ = D_h⁴.
TEST_F(DrawnSwitches, ColourAndSearchlightAreTheEngines) {
  const Vec3 paint(0.10, 0.28, 0.15);
  const Scene scene = test::glowingPuck(0.25, glm::vec3(paint));
  for (const double beta : {-0.4, -0.1, 0.0, 0.1, 0.25}) {
    const double doppler = std::sqrt((1.0 + beta) / (1.0 - beta));
    const double fourth = std::pow(doppler, 4.0);
    const WorldLine line = straight({0.0, 2.0 + beta, 0.0}, {0.0, -beta, 0.0});
    const Vec3 shifted = colourResponse(doppler, doppler) * paint;
    const std::array<std::pair<Switches, Vec3>, 4> expected{{{Switches{1, 1, 1, 0, 0}, paint},
                                                             {Switches{1, 1, 1, 0, 1}, fourth * paint},
                                                             {Switches{1, 1, 1, 1, 1}, shifted},
                                                             {Switches{1, 1, 1, 1, 0}, shifted / fourth}}};
    for (const auto& [switches, linear] : expected) {
      const glm::ivec3 drawn = middleOf(draw(line, scene, 0.0, switches));
      const glm::ivec3 wanted = onScreen(linear, switches);
      for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(drawn[i], wanted[i], kScreenSteps)
            << "channel " << i << " at " << beta << " c, colour " << +switches.colour << ", searchlight "
            << +switches.searchlight;
      }
    }
  }
}

// Blue grows and red shrinks as a green puck approaches; receding, the other way round.
TEST_F(DrawnSwitches, ApproachShiftsTheHueToBlue) {
  const Scene scene = test::glowingPuck(0.25, {0.05F, 0.3F, 0.1F});
  const auto blueness = [&](double beta) {
    const WorldLine line = straight({0.0, 2.0 + beta, 0.0}, {0.0, -beta, 0.0});
    const glm::ivec3 drawn = middleOf(draw(line, scene, 0.0, {1, 1, 1, 1, 0}));
    return drawn.b - drawn.r;
  };
  const int atRest = blueness(0.0);
  EXPECT_GT(blueness(0.1), atRest + 20);
  EXPECT_LT(blueness(-0.1), atRest - 20);
}

// A person at rest who switches colour and searchlight on sees no change of what rests.
TEST_F(DrawnSwitches, AtRestColourAndSearchlightChangeNothing) {
  Scene scene = test::glowingPuck(0.25, {0.05F, 0.3F, 0.1F});
  for (ScenePart& part : scene.parts) part.paint = Paint::plain;
  scene.lamps_m = {{{-1.0, 0.0, 1.4}, {0.0, 0.0, 1.4}, {1.0, 0.0, 1.4}}};
  const WorldLine line = straight({0.0, 2.0, 0.0}, Vec3(0.0));
  const glm::ivec3 plain = middleOf(draw(line, scene, 0.0, {}));
  const glm::ivec3 with = middleOf(draw(line, scene, 0.0, {1, 1, 1, 1, 1}));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(plain[i], with[i], 6.0) << i;  // lamps are yellowish: metamerism
  EXPECT_GT(plain.g, 60);
}

}  // namespace
}  // namespace carom
