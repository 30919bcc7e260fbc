// Pucks with corners as they are drawn, against rays traced backwards and meshes solved by halving
// (reference/ray_reference.h): random outlines, flights, spins and blows.
#include "reference/ray_reference.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>

#include "cave/scene/outline_model.h"
#include "cave/silhouettes.h"
#include "engine/billiard/billiard.h"
#include "engine/polygons/outline.h"

namespace carom {
namespace {

using namespace test;
using Corners = std::vector<Vec2>;

constexpr int kWidest_px = 500;

/// A bar, a regular polygon, an angle or a star with dents, its farthest corner at the radius.
Corners randomOutline(Random& random, double radius_m) {
  const double width = random.in(0.15, 0.8);
  Corners corners;
  switch (static_cast<int>(random.in(0.0, 4.0))) {
    case 0:
      corners = {{-1.0, -width}, {1.0, -width}, {1.0, width}, {-1.0, width}};
      break;
    case 1:
      corners = {{-0.5, -0.5},       {1.0, -0.5}, {1.0, width - 0.5}, {width - 0.5, width - 0.5},
                 {width - 0.5, 1.0}, {-0.5, 1.0}};
      break;
    default: {
      const int points = static_cast<int>(random.in(3.0, 9.0));
      const bool hasDents = random.in(0.0, 1.0) < 0.5;
      for (int k = 0; k < (hasDents ? 2 : 1) * points; ++k) {
        const double angle = std::numbers::pi * (hasDents ? k : 2 * k) / points;
        const double radius = hasDents && k % 2 == 1 ? width : 1.0;
        corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
      }
    }
  }
  const double farthest = Outline(corners).radius();
  for (Vec2& corner : corners) corner *= radius_m / farthest;
  return corners;
}

/// Places along the sides, above and below.
std::vector<Vec3> rimOf(const Corners& outline_m, double height_m) {
  constexpr int kPerSide = 12;
  std::vector<Vec3> rim;
  for (std::size_t k = 0; k < outline_m.size(); ++k) {
    for (int i = 0; i < kPerSide; ++i) {
      const double share = static_cast<double>(i) / kPerSide;
      const Vec2 at = outline_m[k] + share * (outline_m[(k + 1) % outline_m.size()] - outline_m[k]);
      for (const double z : {-0.5, 0.5}) rim.push_back({at, z * height_m});
    }
  }
  return rim;
}

vtkSmartPointer<vtkPolyData> prismIn(const Corners& outline_m, double height_m, double pixel_rad) {
  return surfacePart(prismOver(outline_m, height_m), 1, glm::vec3(1.0F), {.pixel_rad = pixel_rad}).mesh;
}

/// A prism whose outline the next world line brings. It is drawn as pucks with corners are, or in the
/// reference's own mesh where a bounce or a spin bends it within a facet.
class Prisms {
 public:
  Prisms(Graphics& graphics, Drawn drawn) : graphics_(graphics), drawn_(drawn) {}

  template <typename MakeLine, typename Accept>
  Comparison compare(std::uint64_t seed, int pictures, const MakeLine& makeLine, const Accept& accept) {
    const auto line = [&](Random& random, double radius_m) {
      outline_m_ = randomOutline(random, radius_m);
      return makeLine(random, radius_m, outline_m_);
    };
    const auto flyer = [&](const WorldLine& of, double, double height_m) { return flyerOf(of, height_m); };
    const auto body = [&](const WorldLine& of, double, double height_m) {
      return ReferenceBody{1, referenceLegs(of), {}, {}, rimOf(outline_m_, height_m)};
    };
    return compareRandom(graphics_, seed, pictures, line, flyer, accept, kWidest_px, body);
  }

 private:
  Flyer flyerOf(const WorldLine& line, double height_m) const {
    // The pixels of the test's wall, nearer than the nearest eye of a CAVE; edges grow with the root.
    constexpr double kPixel_rad = 0.0005, kCoarser = 8.0;
    const auto mesh =
        prismIn(outline_m_, height_m, drawn_ == Drawn::fine ? kCoarser * kPixel_rad : kPixel_rad);
    const reference::Mesh fine = reference::fourTimesFiner(referenceMesh(*mesh));
    Flyer flyer{
        {{1, referenceLegs(line), reference::meshShape(referenceMesh(*prismIn(outline_m_, height_m, 1.0))),
          fine, rimOf(outline_m_, height_m)}},
        {}};
    Scene plain;
    plain.parts.push_back(
        {1, drawn_ == Drawn::fine ? polyData(fine) : mesh, Paint::lamp, glm::vec3(1.0F), 0.0F});
    flyer.scene.bodyCount = 2;
    addNumbered(flyer.scene, plain, 1, 1);
    return flyer;
  }

  Graphics& graphics_;
  Drawn drawn_;
  Corners outline_m_;
};

class CornerReference : public testing::Test {
 protected:
  Graphics graphics_;
};

bool settled(const ReferenceBody& body, const reference::Eye& eye) { return !inABounce(body, eye); }

TEST_F(CornerReference, StraightFlightsUpTo99HundredthsOfLight) {
  int made = 0;
  const auto line = [&](Random& random, double radius_m, const Corners&) {
    const std::array<double, 3> speeds{0.6, 0.9, 0.99};
    const Knot knot{
        {0.0, random.inBox(0.5)}, uFromBeta(random.direction() * speeds[made++ % 3]), 0.0, {}, 0.0};
    return WorldLine(knot, kC_m_s, radius_m);
  };
  const Comparison all = Prisms(graphics_, Drawn::builtIn).compare(71, 9, line, settled);
  all.print("corners, straight flights");
  EXPECT_EQ(all.tracedBodies, 9);
}

WorldLine bouncing(Random& random, double radius_m, const Corners&) {
  return randomWorldLine(random, kC_m_s, radius_m, 1 + static_cast<int>(random.in(0.0, 2.0)), 0.3, 0.9);
}

TEST_F(CornerReference, BeforeAndAfterBounces) {
  const Comparison all = Prisms(graphics_, Drawn::builtIn).compare(72, 6, bouncing, settled);
  all.print("corners, before and after bounces");
  EXPECT_EQ(all.tracedBodies, 6);
}

TEST_F(CornerReference, InTheMiddleOfABounceUpToNineTenthsOfLight) {
  const Comparison all = Prisms(graphics_, Drawn::fine).compare(73, 6, bouncing, inABounce);
  all.print("corners, in the middle of a bounce");
  EXPECT_EQ(all.turningBodies, 6);
}

TEST_F(CornerReference, SpinsWhoseCornersGoAtUpTo99HundredthsOfLight) {
  int made = 0;
  const auto spinning = [&](Random& random, double radius_m, const Corners&) {
    const std::array<double, 3> rims{0.6, 0.9, 0.99};
    const double rim = rims[static_cast<std::size_t>(made++ % 3)];
    return spun(random, randomWorldLine(random, kC_m_s, radius_m, 1, 0.3, 0.9), rim, 0.0, rim);
  };
  const Comparison all = Prisms(graphics_, Drawn::fine).compare(74, 3, spinning, settled);
  all.print("corners that turn, before and after bounces");
  const Comparison turning = Prisms(graphics_, Drawn::fine).compare(75, 3, spinning, inABounce);
  turning.print("corners that turn, in the middle of a bounce");
  EXPECT_EQ(turning.turningBodies, 3);
}

/// The world line of the first of two pucks with corners that meet, as the game plays it, until its second
/// turn.
WorldLine kicked(Random& random, double radius_m, const Corners& outline_m) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = kC_m_s;
  setup.rules.puckFriction = random.in(0.0, 1.0);
  for (;;) {
    setup.pucks.clear();
    for (const double side : {-1.0, 1.0}) {
      Puck puck;
      puck.name = side < 0.0 ? "first" : "second";
      puck.outline_m = side < 0.0 ? outline_m : randomOutline(random, radius_m);
      puck.radius_m = radiusOf_m(puck.outline_m);
      puck.inertia = momentsOf(puck.outline_m).inertia;
      puck.height_m = 0.02;
      puck.mass_kg = random.in(0.1, 0.3);
      puck.position_m = {side * 0.3, random.in(-0.5, 0.5) * radius_m};
      puck.beta = {-side * random.in(0.1, 0.9), random.in(-0.1, 0.1)};
      const double rim = random.in(-0.9, 0.9);
      puck.spin_kg_m2_s = spinAt_kg_m2_s(puck, rim * kC_m_s / puck.radius_m, kC_m_s);
      setup.pucks.push_back(puck);
    }
    const double puckRadius_m = setup.pucks[0].radius_m;
    Billiard game(setup);
    game.advanceTo(3.0);
    const WorldLine& played = game.worldLines()[0];
    if (played.knots().size() < 2) continue;
    WorldLine line(played.knots()[0], kC_m_s, puckRadius_m);
    line.append(played.knots()[1]);
    return line;
  }
}

TEST_F(CornerReference, BlowsThatTheGamePlays) {
  const Comparison before = Prisms(graphics_, Drawn::fine).compare(76, 3, kicked, settled);
  before.print("corners, before and after blows");
  const Comparison during = Prisms(graphics_, Drawn::fine).compare(77, 6, kicked, inABounce);
  during.print("corners, in the middle of blows");
  EXPECT_EQ(during.turningBodies, 6);
}

}  // namespace
}  // namespace carom
