// Retardation, contraction and aberration switched off: what the kernel sees of points, against their world
// lines looked up in the board frame.
#include "engine/light/switches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "engine/light/light_cone.h"
#include "engine/light/seen_point.h"
#include "engine/light/vertex_history.h"
#include "sanitized.h"

namespace carom {
namespace {

using test::kC_m_s, test::kTolerance_m;

using Case = test::SeenPoint;

/// Where the kernel says that the point is drawn, as the shaders do it.
Vec3 drawnByKernel(const Case& c, const Switches& switches) {
  BodyView view;
  viewBody(c.line, c.eye, c.headFromBoard, view, switches);
  const auto vertex = emissionIn(view, c.offset_m);
  const Vec3 seen = seenFromEye(view, vertex);
  if (view.retarded) return seen;
  return kernel::rayThrough(ViewFrame(c.headFromBoard, switches).drawnFromSeen.matrix(), seen);
}

/// The board's axes turned into the head's without any motion: what the head's frame is before its boost.
Vec3 turned(const Case& c, const Vec3& onBoard_m) {
  const Vec3 u = c.headFromBoard.u();
  return (Lorentz::boost(-u, kC_m_s) * (c.headFromBoard * Displacement{0.0, onBoard_m})).dr_m;
}

/// Light that has come straight from there, as the head sees it.
Vec3 aberrated(const Case& c, const Vec3& onBoard_m) {
  return (c.headFromBoard * Displacement{-glm::length(onBoard_m) / kC_m_s, onBoard_m}).dr_m;
}

/// The point's place at board time t: on its history, or without contraction the centre's + d.
Vec3 placeAt(const Case& c, double t_s, bool contraction) {
  if (!contraction) return c.line.at(t_s).event.r_m + c.offset_m;
  const auto history = vertexHistory(c.line, c.offset_m);
  return carom::placeAt(pieceAt(history, t_s), t_s, kC_m_s);
}

/// Where light that the eye receives left the point, by bisection.
Vec3 emissionPlace(const Case& c, bool contraction) {
  const auto ahead = [&](double t_s) {
    return kC_m_s * (c.eye.t_s - t_s) - glm::length(c.eye.r_m - placeAt(c, t_s, contraction));
  };
  double early_s = c.eye.t_s - 1.0;
  while (!(ahead(early_s) > 0.0)) early_s -= 2.0 * (c.eye.t_s - early_s);
  double late_s = c.eye.t_s;
  for (int i = 0; i < 100; ++i) {
    const double middle_s = 0.5 * (early_s + late_s);
    (ahead(middle_s) > 0.0 ? early_s : late_s) = middle_s;
  }
  return placeAt(c, early_s, contraction);
}

Vec3 expected(const Case& c, const Switches& s) {
  const Vec3 place_m = s.retardation ? emissionPlace(c, s.contraction) : placeAt(c, c.eye.t_s, s.contraction);
  return s.aberration ? aberrated(c, place_m - c.eye.r_m) : turned(c, place_m - c.eye.r_m);
}

Switches switchesOf(int bits) {
  Switches s;
  s.retardation = bits & 1;
  s.contraction = (bits >> 1) & 1;
  s.aberration = (bits >> 2) & 1;
  return s;
}

/// Every state of the three, on points of bodies with so many bounces.
void compare(int cases, int mostBounces, double spacing_s, double friction_m_s2) {
  test::Random random(31);
  for (int i = 0; i < test::casesOf(cases); ++i) {
    CASE(random, i);
    const Case c = test::randomSeenPoint(random, i % (mostBounces + 1), spacing_s, friction_m_s2, 3.0);
    for (int bits = 0; bits < 8; ++bits) {
      const Switches s = switchesOf(bits);
      const double error_m = glm::length(drawnByKernel(c, s) - expected(c, s));
      ASSERT_LT(error_m, kTolerance_m)
          << "case " << i << ", retardation " << +s.retardation << ", contraction " << +s.contraction
          << ", aberration " << +s.aberration << ", eye at " << c.eye.t_s << " s";
    }
  }
}

TEST(Switches, EachStateIsTheWorldLineLookedUp) { compare(2000, 8, 0.3, 0.0); }

// Bounces far enough apart that signal comes in turn.
TEST(Switches, AlsoUnderFriction) { compare(120, 3, 2.0, 0.7); }

// A puck at 0.9 c, at the moment when its centre passes straight ahead: with contraction its outline along
// the motion is √(1 − 0.81) = 0.436 of the uncontracted one.
TEST(Switches, ContractionShortens) {
  const WorldLine line({{0.0, {0.0, 2.0, 0.0}}, uFromBeta({0.9, 0.0, 0.0}), 0.0, {}, 0.0}, kC_m_s, 0.1);
  const Event eye{0.0, Vec3(0.0)};
  const auto length_m = [&](const Switches& s) {
    const Case front{line, {0.1, 0.0, 0.0}, eye, Lorentz(kC_m_s)};
    const Case back{line, {-0.1, 0.0, 0.0}, eye, Lorentz(kC_m_s)};
    return drawnByKernel(front, s).x - drawnByKernel(back, s).x;
  };
  EXPECT_NEAR(length_m({0, 0, 1, 0, 0}), 0.2, 1e-12);
  EXPECT_NEAR(length_m({0, 1, 1, 0, 0}), 0.2 * std::sqrt(1.0 - 0.81), 1e-12);
}

}  // namespace
}  // namespace carom
