// What everyone knows of fast things' looks, measured on walls as they are drawn: a sphere keeps a circular
// outline, a rod seen end-on is stretched by its Doppler factor, apparent speeds exceed light; and the pixels
// that `carom observe` foretells.
#include <gtest/gtest.h>

#include <cstdio>
#include <glm/matrix.hpp>
#include <numbers>
#include <sstream>

#include "app/program.h"
#include "app/scenario/scenario.h"
#include "cave/scene/scene_builder.h"
#include "cave/silhouettes.h"
#include "engine/light/mesh_emission.h"
#include "places.h"

namespace carom {
namespace {

using namespace test;

constexpr double kPixelsPerRadian = kWall_px / kWall_m * kWallDistance_m;  // in the middle of a wall

/// A ball as a mesh file.
std::string ballObj(double radius_m, int rings) {
  const int sectors = 2 * rings;
  std::ostringstream text;
  text.precision(9);
  for (int ring = 0; ring <= rings; ++ring) {
    const double polar = std::numbers::pi * ring / rings;
    for (int i = 0; i < sectors; ++i) {
      const double azimuth = 2.0 * std::numbers::pi * i / sectors;
      text << "v " << radius_m * std::sin(polar) * std::cos(azimuth) << ' '
           << radius_m * std::sin(polar) * std::sin(azimuth) << ' ' << radius_m * std::cos(polar) << '\n';
    }
  }
  const auto point = [sectors](int ring, int i) { return 1 + ring * sectors + i % sectors; };
  for (int ring = 0; ring < rings; ++ring) {
    for (int i = 0; i < sectors; ++i) {
      const int a = point(ring, i), b = point(ring + 1, i), c = point(ring + 1, i + 1),
                d = point(ring, i + 1);
      if (ring + 1 < rings) text << "f " << a << ' ' << b << ' ' << c << '\n';
      if (ring > 0) text << "f " << a << ' ' << c << ' ' << d << '\n';
    }
  }
  return text.str();
}

/// A scenario file with one body that passes `at` at board time 0.
std::string flight(const std::string& mesh, const Vec3& at_m, double betaX) {
  std::ostringstream text;
  text.precision(17);
  text << "light_speed_m_s = " << kC_m_s << "\n[[body]]\nname = \"it\"\n";
  if (!mesh.empty()) text << "mesh = \"" << mesh << "\"\n";
  text << "at = { t_s = 0.0, r_m = [" << at_m.x << ", " << at_m.y << ", " << at_m.z << "] }\n"
       << "[[body.leg]]\nbeta = [" << betaX << ", 0.0, 0.0]\n";
  return text.str();
}

/// The first scripted body of a scenario file, alone and shining.
struct ScriptedScene {
  WorldLine line;
  Scene scene;
};

ScriptedScene scriptedScene(const std::filesystem::path& file) {
  const Scenario scenario = readScenario(file);
  const ScriptedBody& body = scenario.bodies.at(0);
  const BodyLooks looks{body.name, body.mesh ? body.mesh->string() : "", 0.0, 0.0};
  const Scene whole = buildScene(scenario.billiard, {}, {&looks, 1});
  ScriptedScene told{body.worldLine, {}};
  told.scene.bodyCount = 2;
  test::addNumbered(told.scene, whole, 1, 1);
  return told;
}

class SeenShapes : public testing::Test {
 protected:
  const test::TemporaryFolder folder_;
  Graphics graphics_;
};

// ---- spheres --------------------------------------------------------------------------------------------

/// A circle of directions: all n with n·axis = cos(radius).
struct Circle {
  Vec3 axis{0.0};
  double radius_rad = 0.0;
};

/// Penrose (1959): a ball of radius R at rest fills a cone n'·a' = cos α', sin α' = R/|e|, a' towards it.
/// With the null vector k = (−1, n) of a ray followed backwards that is W·k = 0 for W = (−cos α', a'), in
/// every frame; in the head's, n·W_r = −W_t.
Circle outlineOfBall(double radius_m, const reference::Leg& leg, const reference::Eye& eye) {
  const Vec3 fromEye = -reference::boosted(eye.event - leg.turn, leg.v).r;
  const double distance = glm::length(fromEye);
  const double sine = radius_m / distance;
  const reference::Event inBody{-std::sqrt(1.0 - sine * sine), fromEye / distance};
  const reference::Event inHead = reference::boosted(reference::boosted(inBody, -leg.v), eye.v);
  const double size = glm::length(inHead.r);
  return {inHead.r / size, std::acos(-inHead.t / size)};
}

/// Directions of the middle of the edges between lit and dark pixels, in rows and columns.
std::vector<Vec3> outlineOf(const Image& image, const reference::Screen& screen) {
  std::vector<Vec3> outline;
  for (int y = 1; y < image.size_px.y; ++y) {
    for (int x = 1; x < image.size_px.x; ++x) {
      const int here = test::numberAt(image, x, y);
      if (here != test::numberAt(image, x - 1, y)) outline.push_back(screen.direction(x, y + 0.5));
      if (here != test::numberAt(image, x, y - 1)) outline.push_back(screen.direction(x + 0.5, y));
    }
  }
  return outline;
}

/// The circle through directions: least squares of n·w = 1, w = axis/cos(radius).
Circle fitCircle(const std::vector<Vec3>& directions) {
  glm::dmat3 squares(0.0);
  Vec3 sum(0.0);
  for (const Vec3& n : directions) {
    squares += glm::outerProduct(n, n);
    sum += n;
  }
  const Vec3 w = glm::inverse(squares) * sum;
  return {glm::normalize(w), std::acos(1.0 / glm::length(w))};
}

TEST_F(SeenShapes, ABallThatPassesHasACircularOutline) {
  constexpr double kRadius_m = 0.05;
  constexpr double kFit_px = 0.2;
  const std::string mesh = folder_.file("ball.obj", ballObj(kRadius_m, 128)).filename();
  double worstFit_px = 0.0, worstCircle_px = 0.0;
  for (const double beta : {0.5, 0.8, 0.99}) {
    const ScriptedScene told = scriptedScene(folder_.file("ball.toml", flight(mesh, {0.0, 0.5, 0.1}, beta)));
    WallRenderer renderer(graphics_, told.scene, kC_m_s, 1);
    const auto legs = test::referenceLegs(told.line);
    for (const double seenAt_m : {-0.5, 0.0, 0.5}) {  // coming, abeam, going
      const double sent_s = seenAt_m / (beta * kC_m_s);
      const double distance_m = glm::length(Vec3(seenAt_m, 0.5, 0.1));
      const test::Look look{{sent_s + distance_m / kC_m_s, Vec3(0.0)},
                            beta == 0.8 ? Vec3(0.1, -0.5, 0.2) : Vec3(0.0)};
      const Circle expected = outlineOfBall(kRadius_m, legs[0], look.eye(kC_m_s));
      SCOPED_TRACE(testing::Message() << "ball at " << beta << " c seen at x = " << seenAt_m << " m");
      // Only a part of the wall is drawn, but finer: the circle fills most of it.
      const double part_m = 2.3 * kWallDistance_m * std::tan(expected.radius_rad);
      const Wall part = test::squareWall(look.inRoom_m, expected.axis, kWallDistance_m, part_m, kWall_px);
      ASSERT_LT(part_m, 0.4 * kWall_m) << "finer than the wall itself";
      const Image image = test::drawn(graphics_, renderer, {&told.line, 1}, look, part);
      const std::vector<Vec3> outline = outlineOf(image, test::screenOf(part, look.inRoom_m));
      ASSERT_GT(outline.size(), 4000U);
      const Circle circle = fitCircle(outline);
      for (const Vec3& n : outline) {
        const double off = std::abs(std::acos(glm::dot(n, circle.axis)) - circle.radius_rad);
        worstFit_px = std::max(worstFit_px, off * kPixelsPerRadian);
      }
      const double off =
          glm::length(circle.axis - expected.axis) + std::abs(circle.radius_rad - expected.radius_rad);
      worstCircle_px = std::max(worstCircle_px, off * kPixelsPerRadian);
      EXPECT_LT(worstFit_px, kFit_px);
      EXPECT_LT(worstCircle_px, 0.05) << "the circle is where the aberrated cone is";
    }
  }
  std::printf("balls: outlines off their circles by %.3f px of 1920, the circles off Penrose's by %.4f px\n",
              worstFit_px, worstCircle_px);
}

// ---- rods -----------------------------------------------------------------------------------------------

// A rod that flies at the eye along itself: light from its far end left earlier, so its length is seen
// sqrt((1+β)/(1−β)) times what it is; going away, the inverse.
TEST_F(SeenShapes, ARodSeenEndOnIsAsLongAsItsDopplerFactorSays) {
  double worst = 0.0;
  for (const double beta : {-0.99, -0.8, -0.5, 0.5, 0.8, 0.99}) {
    const ScriptedScene told = scriptedScene(folder_.file("rod.toml", flight("", {0.0, 0.0, 0.0}, beta)));
    const reference::Mesh mesh = test::referenceMesh(*told.scene.parts.at(0).mesh);
    std::vector<float> x, y, z;
    for (const Vec3& p : mesh.points) {
      if (std::hypot(p.y, p.z) > 1e-6) continue;  // on the axis: the middles of both ends
      x.push_back(static_cast<float>(p.x)), y.push_back(0.0F), z.push_back(0.0F);
    }
    ASSERT_GE(x.size(), 2U);
    const Event eye{0.0, {30.0, 0.0, 0.0}};
    BodyView view;
    viewBody(told.line, eye, Lorentz(kC_m_s), view);
    std::vector<float> seenX(x.size()), seenY(x.size()), seenZ(x.size());
    seePoints(view, {x, y, z}, {seenX, seenY, seenZ, {}, {}});
    const auto [least, most] = std::minmax_element(x.begin(), x.end());
    const double length_m = static_cast<double>(seenX[most - x.begin()]) - seenX[least - x.begin()];
    const double expected_m = std::sqrt((1.0 + beta) / (1.0 - beta)) * (*most - *least);
    EXPECT_NEAR(*most - *least, 1.0, 1e-6) << "the built-in rod is 1 m long";
    // In float, of the distance of the eye in the rod's rest frame at emission: some hundred metres.
    EXPECT_NEAR(length_m / expected_m, 1.0, 1e-4) << beta;
    worst = std::max(worst, std::abs(length_m / expected_m - 1.0));
  }
  std::printf("rods end-on: lengths off by %.2g of themselves at most\n", worst);
}

// ---- apparent speed -------------------------------------------------------------------------------------

/// The middle twentieth of a wall's rows.
Wall stripOf(Wall wall) {
  const glm::dvec3 up = wall.upperLeft_m - wall.lowerLeft_m;
  wall.upperLeft_m = wall.lowerLeft_m + 0.525 * up;
  wall.lowerLeft_m += 0.475 * up;
  wall.lowerRight_m += 0.475 * up;
  wall.pixels.y /= 20;
  return wall;
}

/// Mean column of the lit pixels; NaN if nothing is lit or it touches the border.
double middleColumn(const Image& image) {
  double sum = 0.0;
  long count = 0;
  for (int y = 0; y < image.size_px.y; ++y) {
    for (int x = 0; x < image.size_px.x; ++x) {
      if (test::numberAt(image, x, y) == 0) continue;
      if (x == 0 || x + 1 == image.size_px.x) return NAN;
      sum += x + 0.5;
      ++count;
    }
  }
  return sum / static_cast<double>(count);
}

// From one frame to the next the seen place moves at v/(1 − β cos θ), θ between the motion and the way of the
// light to the eye.
TEST_F(SeenShapes, ApparentSpeedFromFrameToFrame) {
  const std::string mesh = folder_.file("ball.obj", ballObj(0.03, 48)).filename();
  constexpr double kFrame_s = 1.0 / 60.0;
  constexpr double kMiddle_px = 0.25;  // how far the middles of two pictures' lit pixels may be off together
  double worst_px = 0.0, fastest_c = 0.0;
  for (const double beta : {0.5, 0.8, 0.99}) {
    // On a line parallel to the wall and as far away, so that places on the wall are places on the line.
    const Vec3 nearest_m(0.0, kWallDistance_m, 0.0007);
    const ScriptedScene told = scriptedScene(folder_.file("ball.toml", flight(mesh, nearest_m, beta)));
    WallRenderer renderer(graphics_, told.scene, kC_m_s, 1);
    const auto seenAt_m = [&](double eye_s) {
      const test::Look look{{eye_s, Vec3(0.0)}, Vec3(0.0)};
      const Wall wall =
          stripOf(test::squareWall(look.inRoom_m, {0, 1, 0}, kWallDistance_m, kWall_m, kWall_px));
      const Image image = test::drawn(graphics_, renderer, {&told.line, 1}, look, wall);
      return (middleColumn(image) / kWall_px - 0.5) * kWall_m;
    };
    for (double x_m = -1.3; x_m < 1.3; x_m += 0.2) {
      const double eye_s = x_m / (beta * kC_m_s) + std::hypot(x_m, kWallDistance_m) / kC_m_s;
      const double first_m = seenAt_m(eye_s), second_m = seenAt_m(eye_s + kFrame_s);
      const double middle_m = 0.5 * (first_m + second_m);
      const double cosine = -middle_m / std::hypot(middle_m, kWallDistance_m);
      const double expected_m_s = beta * kC_m_s / (1.0 - beta * cosine);
      const double speed_m_s = (second_m - first_m) / kFrame_s;
      const double off_px = std::abs(speed_m_s - expected_m_s) * kFrame_s / kWall_m * kWall_px;
      EXPECT_LT(off_px, kMiddle_px) << beta << " c, seen at x = " << middle_m << " m: " << speed_m_s
                                    << " m/s, expected " << expected_m_s;
      worst_px = std::max(worst_px, off_px);
      fastest_c = std::max(fastest_c, speed_m_s / kC_m_s);
    }
  }
  std::printf("apparent speeds: the fastest %.2f c, the worst %.3f px a frame off\n", fastest_c, worst_px);
  EXPECT_GT(fastest_c, 2.0) << "faster than light";
}

// ---- carom observe --------------------------------------------------------------------------------------

struct Marker {
  std::size_t puck;
  const char* name;
  Vec3 offset_m;
};

/// A small octahedron about a place of a body.
reference::Mesh markerMesh(const Vec3& place_m, double radius_m) {
  reference::Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-radius_m, radius_m}) {
      Vec3 p = place_m;
      p[axis] += side;
      mesh.points.push_back(p);
    }
  }
  for (std::size_t x = 0; x < 2; ++x) {
    for (std::size_t y = 2; y < 4; ++y) {
      for (std::size_t z = 4; z < 6; ++z) mesh.triangles.push_back({x, y, z});
    }
  }
  return mesh;
}

TEST_F(SeenShapes, PointsAreDrawnWhereObserveSaysTheyAreSeen) {
  const std::string file = CAROM_CONFIG_DIR "/scenarios/three-pucks.toml";
  const Scenario scenario = readScenario(file);
  const double c_m_s = scenario.billiard.lightSpeed_m_s;
  Billiard billiard(scenario.billiard);
  billiard.advanceTo(12.0);
  const std::vector<Marker> markers{{0, "white", {0.0, 0.0, 0.0}},    {0, "white", {0.02, 0.01, 0.01}},
                                    {1, "yellow", {-0.03, 0.0, 0.0}}, {1, "yellow", {0.0, 0.03, -0.01}},
                                    {2, "red", {0.0, 0.0, 0.01}},     {2, "red", {0.0, -0.03, 0.0}}};
  Scene scene;
  scene.bodyCount = 4;
  for (std::size_t i = 0; i < markers.size(); ++i) {
    ScenePart part{markers[i].puck + 1, test::polyData(markerMesh(markers[i].offset_m, 0.002)), Paint::lamp,
                   test::numberColour(static_cast<int>(i) + 1), 0.0F};
    scene.parts.push_back(part);
  }
  WallRenderer renderer(graphics_, scene, c_m_s, 1);
  double worst_px = 0.0;
  int compared = 0;
  for (const double t_s : {1.0, 2.2, 2.6, 4.0}) {
    for (const Vec3& beta : {Vec3(0.0), Vec3(0.3, -0.6, 0.1), Vec3(-0.5, -0.75, 0.2)}) {
      const test::Look look{{t_s, {0.4, -0.5, 0.4}}, beta};
      std::vector<std::string> arguments{"observe", file, "--event"};
      for (const double number : {t_s, 0.4, -0.5, 0.4}) arguments.push_back(test::exact(number));
      arguments.push_back("--beta");
      for (int i = 0; i < 3; ++i) arguments.push_back(test::exact(beta[i]));
      for (const Marker& marker : markers) {
        arguments.insert(arguments.end(), {"--point", marker.name});
        for (int i = 0; i < 3; ++i) arguments.push_back(test::exact(marker.offset_m[i]));
      }
      arguments.insert(arguments.end(), {"--json", "-"});
      const auto result = test::runCarom(folder_, arguments);
      ASSERT_EQ(result.status, 0) << result.err;
      const nlohmann::json points = nlohmann::json::parse(result.out)["points"];
      ASSERT_EQ(points.size(), markers.size());
      for (const Vec3& facing : {Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0.3, -1)}) {
        const Wall wall = test::squareWall(look.inRoom_m, facing, kWallDistance_m, kWall_m, kWall_px);
        const reference::Screen screen = test::screenOf(wall, look.inRoom_m);
        const Image image = test::drawn(graphics_, renderer, billiard.worldLines(), look, wall);
        for (std::size_t i = 0; i < markers.size(); ++i) {
          const auto& seen = points[i]["seen_m"];
          const auto pixel =
              screen.pixelOf({seen[0].get<double>(), seen[1].get<double>(), seen[2].get<double>()});
          constexpr double kMargin_px = 12.0;
          if (!(pixel.depth > 0.0 && pixel.x > kMargin_px && pixel.y > kMargin_px &&
                pixel.x < kWall_px - kMargin_px && pixel.y < kWall_px - kMargin_px)) {
            continue;
          }
          double sumX = 0.0, sumY = 0.0;
          int lit = 0;
          for (int y = static_cast<int>(pixel.y) - 10; y <= pixel.y + 10; ++y) {
            for (int x = static_cast<int>(pixel.x) - 10; x <= pixel.x + 10; ++x) {
              if (test::numberAt(image, x, y) != static_cast<int>(i) + 1) continue;
              sumX += x + 0.5, sumY += y + 0.5, ++lit;
            }
          }
          if (lit < 4) continue;  // hidden behind another, or too small
          const double off_px = std::hypot(sumX / lit - pixel.x, sumY / lit - pixel.y);
          EXPECT_LT(off_px, 1.0) << markers[i].name << " " << i << " at " << t_s << " s, observer at "
                                 << glm::length(beta) << " c: " << lit << " pixels about " << sumX / lit
                                 << " " << sumY / lit << ", expected " << pixel.x << " " << pixel.y;
          worst_px = std::max(worst_px, off_px);
          ++compared;
        }
      }
    }
  }
  std::printf("observe: %d points drawn, the worst %.2f px from where they should be seen\n", compared,
              worst_px);
  EXPECT_GT(compared, 40);
}

}  // namespace
}  // namespace carom
