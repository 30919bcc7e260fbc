// The edge of a lamp's light on the cloth and on a moving puck, pixel by pixel, against rays traced
// backwards: a place is lit if the lamp's light had arrived there when it sent the light that the pixel
// shows.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "cave/frame/bodies.h"
#include "cave/glowing_puck.h"
#include "cave/pictures/image.h"
#include "cave/render/wall_renderer.h"
#include "cave/scene/scene_builder.h"
#include "engine/light_speed.h"

namespace carom {
namespace {

using test::kC_m_s;

constexpr double kPuckRadius_m = 0.3, kPuckHeight_m = 0.1, kBeta = 0.6;
const glm::ivec2 kTable_px{800, 800};
const Vec3 kLamp_m(0.4, 0.1, 1.2);

Scene lampScene() {
  BilliardSetup setup;
  setup.lightSpeed_m_s = kC_m_s;
  setup.board = Board{2.84, 1.42};
  const BodyLooks puck{"white", "", kPuckRadius_m, kPuckHeight_m};
  Hall hall;
  hall.lamps = {{kLamp_m, 1.0, glm::vec3(3.0F)}};
  return buildScene(setup, std::array{puck}, {}, hall, {});
}

/// What the pixel shows: the phase of the lamp's light there, in metres of light, or nothing if it is neither
/// the cloth, far from the cushions, nor the top of the puck.
struct Reference {
  Event eye;
  Vec3 beta;  // of the head
  bool retarded = true;

  std::optional<double> phase_m(const Vec3& inHead) const {
    const Lorentz boardFromHead = Lorentz::boost(uFromBeta(beta), kC_m_s);
    const Vec3 n = glm::normalize((boardFromHead * Displacement{-glm::length(inHead) / kC_m_s, inHead}).dr_m);
    if (n.z >= 0.0) return {};
    const auto at = [&](double height_m) { return (height_m - eye.r_m.z) / n.z; };  // how far along the ray
    const double top_m = at(kPuckHeight_m);
    const auto gap = [&](double s_m) {  // of the puck's rest frame: across it is γ times longer
      const Vec3 r = eye.r_m + s_m * n;
      const double t_s = eye.t_s - s_m / kC_m_s, gamma = 1.0 / std::sqrt(1.0 - kBeta * kBeta);
      return std::hypot(gamma * (r.x - kBeta * kC_m_s * t_s), r.y) - kPuckRadius_m;
    };
    double s_m = top_m;
    if (gap(top_m) > -0.03) {
      s_m = at(0.0);
      if (gap(top_m) < 0.05 || gap(s_m) < 0.15) return {};  // its rim, its side, its shadow
      const Vec3 r = eye.r_m + s_m * n;
      if (std::abs(r.x) > 1.2 || std::abs(r.y) > 0.5) return {};
    }
    const Vec3 r = eye.r_m + s_m * n;
    return -s_m - glm::distance(r, kLamp_m) - kC_m_s * (1.0 - eye.t_s);
  }
};

/// Whether a pixel has the amber of the clocks' digits, which shine by themselves.
bool isOfClock(const Image& image, std::size_t at) {
  return image.rgb[at] > image.rgb[at + 1] && image.rgb[at + 1] > 2 * image.rgb[at + 2];
}

class LampEdge : public testing::Test {
 protected:
  void compare(const Event& eyeEvent, const Vec3& beta) {
    const Scene scene = lampScene();
    WallRenderer renderer(graphics_, scene, kC_m_s, 1);
    const Lorentz headFromBoard = Lorentz::boost(uFromBeta(beta), kC_m_s).inverse();
    const EyeView eye{eyeEvent, Vec3(0.0)};
    std::array<BodyView, 2> views;
    viewBody(WorldLine(Knot{}, kC_m_s, 20.0), eyeEvent, headFromBoard, views[kRestingBody], {});
    const WorldLine line({{0.0, {0.0, 0.0, 0.5 * kPuckHeight_m}}, uFromBeta({kBeta, 0.0, 0.0}), 0.0, {}, 0.0},
                         kC_m_s, 0.4);
    viewBody(line, eyeEvent, headFromBoard, views[1], {});
    const Wall wall = test::wallTowards({0, 0, 0}, Vec3(0.0, 0.5, -1.0), kTable_px);
    RenderTarget picture(kTable_px);
    renderer.look(headFromBoard, eye, views, {});
    ASSERT_TRUE(renderer.draw(wall, eye.positionInRoom_m, picture));
    judge(readBack(picture), wall, {eyeEvent, beta});
  }

  static void judge(const Image& image, const Wall& wall, const Reference& reference) {
    const Vec3 right = (wall.lowerRight_m - wall.lowerLeft_m) / static_cast<double>(kTable_px.x);
    const Vec3 up = (wall.upperLeft_m - wall.lowerLeft_m) / static_cast<double>(kTable_px.y);
    std::size_t lit = 0, dark = 0, wrong = 0;
    for (int y = 1; y + 1 < kTable_px.y; ++y) {
      for (int x = 1; x + 1 < kTable_px.x; ++x) {
        const auto phase_m = [&](double dx, double dy) {
          return reference.phase_m(wall.lowerLeft_m + (x + 0.5 + dx) * right + (y + 0.5 + dy) * up);
        };
        const auto here = phase_m(0.0, 0.0);
        if (!here) continue;
        const std::size_t at = 3 * (static_cast<std::size_t>(y) * kTable_px.x + static_cast<std::size_t>(x));
        if (isOfClock(image, at)) continue;
        const bool isLit = image.rgb[at + 1] > 2;
        (isLit ? lit : dark) += 1;
        if (isLit == (*here > 0.0)) continue;
        bool isNearEdge = false;
        for (int k = 0; k < 8; ++k) {
          const auto beside = phase_m(std::cos(0.785398 * k), std::sin(0.785398 * k));
          isNearEdge = isNearEdge || !beside || (*beside > 0.0) == isLit;
        }
        if (!isNearEdge) ++wrong;
      }
    }
    EXPECT_EQ(wrong, 0U) << "pixels further than one from the edge, of " << lit << " lit and " << dark
                         << " dark";
    EXPECT_GT(lit, 2000U);
    EXPECT_GT(dark, 2000U);
  }

  Graphics graphics_;
};

TEST_F(LampEdge, IsWhereLightHasComeForAnEyeAtRest) {
  for (const double t_s : {2.7, 2.8, 2.9}) {
    SCOPED_TRACE(t_s);
    compare({t_s, {0.1, -0.5, 1.1}}, Vec3(0.0));
  }
}

TEST_F(LampEdge, IsWhereLightHasComeForAnEyeThatMoves) {
  for (const Vec3& beta : {Vec3(0.6, 0.0, 0.0), Vec3(-0.3, 0.5, 0.0)}) {
    SCOPED_TRACE(beta.x);
    compare({2.75, {0.1, -0.5, 1.1}}, beta);
  }
}

TEST_F(LampEdge, BeforeItNothingIsSeen) {
  const Scene scene = lampScene();
  WallRenderer renderer(graphics_, scene, kC_m_s, 1);
  const EyeView eye{{0.9, {0.1, -0.5, 1.1}}, Vec3(0.0)};
  std::array<BodyView, 2> views;
  for (BodyView& view : views)
    viewBody(WorldLine(Knot{}, kC_m_s, 20.0), eye.observation, Lorentz(kC_m_s), view, {});
  RenderTarget picture(kTable_px);
  renderer.look(Lorentz(kC_m_s), eye, views, {});
  ASSERT_TRUE(
      renderer.draw(test::wallTowards({0, 0, 0}, Vec3(0.0, 0.5, -1.0), kTable_px), Vec3(0.0), picture));
  const Image image = readBack(picture);
  for (std::size_t at = 0; at < image.rgb.size(); at += 3)
    ASSERT_TRUE(image.rgb[at + 1] < 3 || isOfClock(image, at)) << at / 3;
}

}  // namespace
}  // namespace carom
