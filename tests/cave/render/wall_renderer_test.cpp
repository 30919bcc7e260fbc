// Whole pictures against the emission of every vertex solved in double and projected.
#include "cave/render/wall_renderer.h"
#include "cave/frame/bodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>

#include "cave/bumpy_sphere.h"
#include "cave/glowing_puck.h"
#include "cave/mesh_input/mesh_file.h"
#include "cave/pictures/image.h"
#include "cave/room/off_axis.h"
#include "cave/scene/scene_builder.h"
#include "cave/scene/table_model.h"
#include "engine/colour/exposure.h"
#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using namespace test;

/// The same from the engine: every vertex's emission, seen from the eye, projected to the wall.
Box expectedBox(const Scene& scene, const WorldLine& line, const Event& eye, const Lorentz& headFromBoard,
                const glm::dmat4& clip, const glm::ivec2& pixels) {
  Box box{1e9, -1e9, 1e9, -1e9};
  for (const ScenePart& part : scene.parts) {
    for (vtkIdType i = 0; i < part.mesh->GetNumberOfPoints(); ++i) {
      const double* offset = part.mesh->GetPoint(i);
      const auto seen = emission(line, {offset[0], offset[1], offset[2]}, eye, headFromBoard);
      if (!seen) continue;
      const glm::dvec4 p = clip * glm::dvec4(seen->seen.dr_m, 1.0);
      include(box, (p.x / p.w + 1.0) * 0.5 * pixels.x, (p.y / p.w + 1.0) * 0.5 * pixels.y);
    }
  }
  return box;
}

/// What rests, and the puck.
std::array<BodyView, 2> viewsOf(const WorldLine& line, const Event& eye, const Lorentz& headFromBoard) {
  std::array<BodyView, 2> views;
  viewBody(WorldLine(Knot{}, kC_m_s), eye, headFromBoard, views[0]);
  viewBody(line, eye, headFromBoard, views[1]);
  return views;
}

class WallRendererTest : public testing::Test {
 protected:
  /// Draws `line` for one eye on a wall towards it, and says what is lit and what should be.
  std::array<Box, 2> litAndExpected(WallRenderer& renderer, const Scene& scene, const WorldLine& line,
                                    const Event& eye, const Lorentz& headFromBoard,
                                    const glm::ivec2& pixels) {
    const glm::dvec3 eyeInRoom_m(0.2, -0.1, 1.6);
    const auto centre = emission(line, Vec3(0.0), eye, headFromBoard);
    const Wall wall = wallTowards(eyeInRoom_m, centre ? centre->seen.dr_m : glm::dvec3(0, 1, 0), pixels);
    RenderTarget picture(pixels);
    renderer.look(headFromBoard, {eye, eyeInRoom_m}, viewsOf(line, eye, headFromBoard));
    EXPECT_TRUE(renderer.draw(wall, eyeInRoom_m, picture));
    return {litBox(readBack(picture)),
            expectedBox(scene, line, eye, headFromBoard, *clipFromEye(wall, eyeInRoom_m), pixels)};
  }

  Graphics graphics_;
};

TEST_F(WallRendererTest, BouncingBodiesAppearWhereTheirVerticesAreSeen) {
  test::Random random(21);
  const Scene scene = glowingPuck(0.15);
  WallRenderer renderer(graphics_, scene, kC_m_s, 1);
  int drawn = 0;
  for (int i = 0; i < 150; ++i) {
    const WorldLine line = randomWorldLine(random, kC_m_s, 0.2, static_cast<int>(random.in(0, 5)), 0.5, 0.9);
    const Event eye{random.in(0.0, line.knots().back().turn.t_s + 2.0), random.inBox(2.5)};
    const Lorentz headFromBoard = Lorentz::boost(random.u(0.95), kC_m_s);
    const glm::ivec2 pixels(i % 3 == 0 ? 300 : 400, i % 2 == 0 ? 400 : 260);
    const auto [lit, expected] = litAndExpected(renderer, scene, line, eye, headFromBoard, pixels);
    const bool within =
        expected[0] > 3 && expected[1] < pixels.x - 3 && expected[2] > 3 && expected[3] < pixels.y - 3;
    if (!within || expected[1] - expected[0] < 6 || expected[3] - expected[2] < 6) continue;
    ++drawn;
    for (std::size_t side = 0; side < 4; ++side) {
      // The outermost vertices of a thin tip may cover no pixel's middle: then less is lit, never more.
      const double beyond = side % 2 == 0 ? expected[side] - lit[side] : lit[side] - expected[side];
      ASSERT_LT(beyond, kLitBox_px) << "case " << i << " side " << side;
      ASSERT_GT(beyond, -3.0) << "case " << i << " side " << side << ": " << lit[side] << " for "
                              << expected[side];
    }
  }
  EXPECT_GT(drawn, 40);
}

TEST_F(WallRendererTest, ABodyWhoseLightHasNotArrivedIsNotDrawn) {
  const Scene scene = glowingPuck(0.3);
  WallRenderer renderer(graphics_, scene, kC_m_s, 1);
  const Lorentz atRest(kC_m_s);
  const WorldLine line({{0.0, {0.0, 2.0, 0.0}}, Vec3(0.0), 0.0, {}, 0.0}, kC_m_s, 0.4,
                       5.0);  // appears at 5 s
  const double arrives_s = 5.0 + 2.0 / kC_m_s;
  const auto before =
      litAndExpected(renderer, scene, line, {arrives_s - 0.25, Vec3(0.0)}, atRest, {200, 200});
  EXPECT_GT(before[0][0], before[0][1]) << "nothing is lit";
  const auto after = litAndExpected(renderer, scene, line, {arrives_s + 0.4, Vec3(0.0)}, atRest, {200, 200});
  EXPECT_NEAR(after[0][0], after[1][0], 1.0);
  EXPECT_NEAR(after[0][1], after[1][1], 1.0);
  // When the light of its middle arrives, its near half is seen and its far half is not.
  const auto half = litAndExpected(renderer, scene, line, {arrives_s, Vec3(0.0)}, atRest, {200, 200});
  EXPECT_LT(half[0][0], half[0][1]);
}

TEST_F(WallRendererTest, AnEyeBehindTheWallSeesBlack) {
  const Scene scene = glowingPuck(0.3);
  WallRenderer renderer(graphics_, scene, kC_m_s, 1);
  const WorldLine line({{0.0, {0.0, 2.0, 0.0}}, Vec3(0.0), 0.0, {}, 0.0}, kC_m_s);
  renderer.look(Lorentz(kC_m_s), {}, viewsOf(line, {}, Lorentz(kC_m_s)));
  const Wall wall = wallTowards({0, 0, 0}, {0, 1, 0}, {64, 64});
  RenderTarget picture({64, 64});
  EXPECT_TRUE(renderer.draw(wall, {0, 0, 0}, picture));
  EXPECT_LT(litBox(readBack(picture))[0], 64.0);
  EXPECT_FALSE(renderer.draw(wall, {0, 2, 0}, picture));
  EXPECT_GT(litBox(readBack(picture))[0], 64.0);
}

// Behind the wall's border lies half of the mesh, then all of it.
TEST_F(WallRendererTest, TheMeterCountsOnlyTrianglesThatTheWallMayShow) {
  const std::string file = (std::filesystem::temp_directory_path() / "carom_meter.ply").string();
  std::ofstream(file, std::ios::binary) << bumpySphere(100);  // 39 600 triangles and a few at the poles
  Scene scene = glowingPuck(0.3);
  scene.parts.back() = meshPart(readMeshFile(file), 0.5, 1, glm::vec3(1.0F), {});
  std::filesystem::remove(file);
  WallRenderer renderer(graphics_, scene, kC_m_s, 1);
  const Wall wall = wallTowards({0, 0, 0}, {0, 1, 0}, {64, 64});  // 4 m wide
  RenderTarget picture({64, 64});
  DrawingMeter meter;
  const auto triangles = [&](double aside_m) {
    const WorldLine line({{0.0, {aside_m, 2.0, 0.0}}, Vec3(0.0), 0.0, {}, 0.0}, kC_m_s, 0.6);
    renderer.look(Lorentz(kC_m_s), {}, viewsOf(line, {}, Lorentz(kC_m_s)));
    const WallPicture shown{&wall, &picture, {}, &meter};
    EXPECT_EQ(renderer.draw({&shown, 1}, {0, 0, 0}), 1U);
    return meter.triangles;
  };
  const std::size_t whole = triangles(0.0), half = triangles(4.0), none = triangles(12.0);
  EXPECT_GT(whole, 39'000U);
  EXPECT_GT(half, whole / 4);
  EXPECT_LT(half, 3 * whole / 4);
  EXPECT_EQ(none, 0U);
}

/// The sRGB code, 0 to 255, of linear light (IEC 61966-2-1) behind the exposure of a head at rest.
double screenStepOf(double light) {
  const Exposure exposure = exposureFor(0.0, false, false);
  const double x = exposure.gain * light;
  const double shown = std::min(x * (1.0 + exposure.rise * x) / (1.0 + exposure.fall * x), 1.0);
  return 255.0 * (shown <= 0.0031308 ? 12.92 * shown : 1.055 * std::pow(shown, 1.0 / 2.4) - 0.055);
}

TEST_F(WallRendererTest, LightIsShownByTheExposureAndTheCurveOfSrgb) {
  const WorldLine line({{0.0, {0.0, 2.0, 0.0}}, Vec3(0.0), 0.0, {}, 0.0}, kC_m_s);
  const Event eye{5.0, Vec3(0.0)};
  const Wall wall = wallTowards({0, 0, 0}, {0, 1, 0}, {16, 16});
  RenderTarget picture(wall.pixels);
  for (const float light : {0.0F, 0.002F, 0.01F, 0.05F, 0.2F, 0.5F, 1.0F, 1.5F, 2.5F}) {
    const std::array<float, 3> colour{light, 0.7F * light, 0.3F * light};
    WallRenderer renderer(graphics_, glowingPuck(2.0, glm::vec3(colour[0], colour[1], colour[2])), kC_m_s, 1);
    renderer.look(Lorentz(kC_m_s), {eye, {}}, viewsOf(line, eye, Lorentz(kC_m_s)));
    renderer.draw(wall, {0, 0, 0}, picture);
    const Image image = readBack(picture);
    for (std::size_t part = 0; part < 3; ++part)
      EXPECT_NEAR(image.rgb[3 * (8 * 16 + 8) + part], screenStepOf(colour[part]), 2.0) << colour[part];
  }
}

TEST_F(WallRendererTest, TheSameFrameGivesTheSamePixels) {
  BilliardSetup setup;
  setup.board = Board{2.84, 1.42};
  const Scene scene = buildScene(setup, {});
  const WorldLine resting(Knot{}, kC_m_s);
  const Event eye{3.0, {0.0, -1.6, 0.9}};
  const Lorentz headFromBoard = Lorentz::boost(uFromBeta({0.3, 0.6, 0.0}), kC_m_s);
  BodyView view;
  viewBody(resting, eye, headFromBoard, view);
  const Wall wall = wallTowards({0, 0, 1.65}, {0, 1, 0}, {320, 240});
  std::array<Image, 2> images;
  for (Image& image : images) {
    WallRenderer renderer(graphics_, scene, kC_m_s, 4);
    RenderTarget picture(wall.pixels);
    renderer.look(headFromBoard, {eye, {0, 0, 1.65}}, {&view, 1});
    renderer.draw(wall, {0, 0, 1.65}, picture);
    image = readBack(picture);
  }
  EXPECT_EQ(images[0].rgb, images[1].rgb);
  EXPECT_GT(*std::max_element(images[0].rgb.begin(), images[0].rgb.end()), 100);
}

// A clock 2 m away shows the time t_o − 2 m/c at which light left it, to a tenth of a second, and nothing
// finer.
TEST_F(WallRendererTest, AClockShowsTheTimeAtWhichItsLightLeft) {
  Scene scene;
  scene.bodyCount = 1;
  ClockMaker clocks;
  clocks.add({0.0, 2.0, -0.23 * 0.5}, {0.0, -1.0, 0.0}, 0.5, kAnyCell_m);  // its middle level with the eye
  scene.parts = clocks.parts();
  const double distance_m = 2.0 - 0.5 * 0.05;  // to its face
  const auto clockAt = [&](double emitted_s, double c_m_s) {
    WallRenderer renderer(graphics_, scene, c_m_s, 1);
    const EyeView eye{{emitted_s + distance_m / c_m_s, Vec3(0.0)}, Vec3(0.0)};
    BodyView view;
    viewBody(restingWorldLine(c_m_s), eye.observation, Lorentz(c_m_s), view);
    const Wall wall = wallTowards({0, 0, 0}, {0, 1, 0}, {600, 600});
    RenderTarget picture(wall.pixels);
    renderer.look(Lorentz(c_m_s), eye, {&view, 1});
    renderer.draw(wall, {0, 0, 0}, picture);
    return readBack(picture).rgb;
  };
  const auto reference = clockAt(12.35, kC_m_s);
  EXPECT_TRUE(clockAt(12.301, kC_m_s) == reference);
  EXPECT_TRUE(clockAt(12.399, kC_m_s) == reference);
  EXPECT_FALSE(clockAt(12.299, kC_m_s) == reference);
  EXPECT_FALSE(clockAt(12.401, kC_m_s) == reference);
  EXPECT_TRUE(clockAt(12.35, 7.0) == reference) << "whatever the speed of light";
  EXPECT_FALSE(clockAt(2.35, kC_m_s) == reference);
  EXPECT_FALSE(clockAt(-12.25, kC_m_s) == reference) << "a minus sign";
  EXPECT_TRUE(clockAt(-12.21, kC_m_s) == clockAt(-12.29, kC_m_s));
}

// What a lamp's light missed at the puck's top it misses on the cloth later, while the puck goes on:
// S(t) = P(t − l/c) + n l, P a place of the upper rim, n the ray there and l its way to the cloth. Seen from
// above, the furthest shadow begins where that of the rim's last place is seen (bisection), to within its
// softness.
TEST_F(WallRendererTest, AFastPucksShadowLagsBehindItByTheLightsWay) {
  // A disc, and a block that shows the same front along the way.
  constexpr double kRadius_m = 0.1, kHeight_m = 0.08, kEye_m = 1.2, kSoft_m = 0.15 * kHeight_m;
  BilliardSetup setup;
  setup.board = Board{2.84, 1.42};
  const std::vector<glm::dvec2> block_m{
      {-kRadius_m, -kRadius_m}, {kRadius_m, -kRadius_m}, {kRadius_m, kRadius_m}, {-kRadius_m, kRadius_m}};
  const glm::ivec2 pixels(400, 2000);  // rows along x
  const Event eye{kEye_m / kC_m_s, {-0.1, 0.0, kEye_m}};
  const Wall wall = wallTowards({0, 0, 0}, {0, 0, -1}, pixels);
  for (const auto& [beta, isBlock] :
       {std::pair{0.0, false}, std::pair{0.6, false}, std::pair{0.9, false}, std::pair{0.9, true}}) {
    const Scene with = buildScene(
        setup, std::vector<BodyLooks>{{"white", "", isBlock ? std::sqrt(2.0) * kRadius_m : kRadius_m,
                                       kHeight_m, isBlock ? block_m : std::vector<glm::dvec2>{}}});
    Scene without = with;
    std::erase_if(without.parts, [](const ScenePart& part) { return part.paint == Paint::shadow; });
    const WorldLine line({{0.0, {0.0, 0.0, 0.5 * kHeight_m}}, uFromBeta({beta, 0.0, 0.0}), 0.0, {}, 0.0},
                         kC_m_s, 0.2);
    const auto views = viewsOf(line, eye, Lorentz(kC_m_s));
    const auto draw = [&](const Scene& scene) {
      WallRenderer renderer(graphics_, scene, kC_m_s, 1);
      graphics_.makeCurrent();
      RenderTarget picture(pixels);
      renderer.look(Lorentz(kC_m_s), {eye, Vec3(0.0), Vec3(0.0)}, views);
      EXPECT_TRUE(renderer.draw(wall, {0, 0, 0}, picture));
      return readBack(picture);
    };
    const Image shaded = draw(with), plain = draw(without);
    double first_m = 1e9;
    for (std::size_t i = 0; i < shaded.rgb.size(); ++i) {
      if (std::abs(int{shaded.rgb[i]} - int{plain.rgb[i]}) < 3) continue;
      const double row = static_cast<double>(i / (3 * static_cast<std::size_t>(pixels.x))) + 0.5;
      first_m = std::min(first_m, eye.r_m.x + kEye_m * (row / pixels.y - 0.5) * 4.0);
    }
    double expected_m = 1e9;
    for (const glm::dvec3& lamp_m : with.lamps_m) {
      const auto shadow = [&](double t_s) {
        double way_m = kHeight_m;
        Vec3 rim_m(0.0), n(0.0);
        for (int k = 0; k < 5; ++k) {
          const double then_s = t_s - way_m / kC_m_s;
          rim_m = Vec3(beta * kC_m_s * then_s - kRadius_m * std::sqrt(1.0 - beta * beta), 0.0, kHeight_m);
          n = glm::normalize(rim_m - lamp_m);
          way_m = -kHeight_m / n.z;
        }
        return rim_m + way_m * n;
      };
      double early_s = eye.t_s - 3.0, late_s = eye.t_s;
      for (int k = 0; k < 60; ++k) {
        const double t_s = 0.5 * (early_s + late_s);
        (t_s + glm::distance(shadow(t_s), eye.r_m) / kC_m_s < eye.t_s ? early_s : late_s) = t_s;
      }
      expected_m = std::min(expected_m, shadow(early_s).x);
    }
    EXPECT_NEAR(first_m, expected_m - 0.5 * kSoft_m * std::sqrt(1.0 - beta * beta), kSoft_m)
        << "at " << beta << " c, " << (isBlock ? "block" : "disc");
  }
}

TEST_F(WallRendererTest, AnotherNumberOfBodiesIsRefused) {
  WallRenderer renderer(graphics_, glowingPuck(0.1), kC_m_s, 1);
  EXPECT_THROW(renderer.look(Lorentz(kC_m_s), {}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace carom
