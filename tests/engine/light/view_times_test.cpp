// Bodies at the board's moment and at the head's own: what the kernel places, against their world lines
// looked up by bisection, and against the closed form of contraction.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "engine/light/light_cone.h"
#include "engine/light/seen_point.h"
#include "engine/light/vertex_history.h"

namespace carom {
namespace {

using test::kC_m_s, test::kTolerance_m;

using Case = test::SeenPoint;

Case randomCase(test::Random& random, int bounces, double spacing_s, double friction_m_s2) {
  return test::randomSeenPoint(random, bounces, spacing_s, friction_m_s2, 2.0);
}

/// The event that the kernel finds, from the eye: its place where the head draws it, and its board time.
struct Placed {
  Vec3 inHead_m{0.0};
  double boardTime_s = 0.0;
};

Placed placedByKernel(const Case& c, const Switches& switches = {}) {
  BodyView view;
  viewBody(c.line, c.eye, c.headFromBoard, view, switches, ViewTime::myNow);
  const auto vertex = emissionIn(view, c.offset_m);
  const LegView& leg = view.legs[static_cast<std::size_t>(vertex.leg)];
  return {kernel::seenFromEye(leg, vertex.event), kernel::boardTimeOf(leg, vertex.event) / kC_m_s};
}

/// From the eye to the point's event at which the head's clocks show the time of the observation: the head's
/// time grows along whatever is slower than light.
Displacement atHeadsMoment(const Case& c) {
  const auto history = vertexHistory(c.line, c.offset_m);
  const auto from = [&](double t_s) {
    return Event{t_s, placeAt(pieceAt(history, t_s), t_s, kC_m_s)} - c.eye;
  };
  double early_s = c.eye.t_s - 1.0, late_s = c.eye.t_s + 1.0;
  while (!((c.headFromBoard * from(early_s)).dt_s < 0.0)) early_s -= 2.0 * (c.eye.t_s - early_s);
  while (!((c.headFromBoard * from(late_s)).dt_s > 0.0)) late_s += 2.0 * (late_s - c.eye.t_s);
  for (int i = 0; i < 200; ++i) {
    const double middle_s = 0.5 * (early_s + late_s);
    ((c.headFromBoard * from(middle_s)).dt_s < 0.0 ? early_s : late_s) = middle_s;
  }
  return from(early_s);
}

void compareMyNow(int cases, int mostBounces, double spacing_s, double friction_m_s2, int& turning) {
  test::Random random(51);
  for (int i = 0; i < cases; ++i) {
    CASE(random, i);
    const Case c = randomCase(random, i % (mostBounces + 1), spacing_s, friction_m_s2);
    const Placed placed = placedByKernel(c);
    const Displacement expected = atHeadsMoment(c);
    ASSERT_LT(glm::length(placed.inHead_m - (c.headFromBoard * expected).dr_m), kTolerance_m)
        << "case " << i << ", eye at " << c.eye.t_s << " s";
    ASSERT_LT(std::abs(placed.boardTime_s - expected.dt_s) * kC_m_s, kTolerance_m) << "case " << i;
    if (c.eye.t_s + expected.dt_s > c.line.knots().front().turn.t_s + 0.1) ++turning;
  }
}

TEST(MyNow, IsTheWorldLineAtTheHeadsTimeThroughBounces) {
  int turning = 0;
  compareMyNow(4000, 8, 0.3, 0.0, turning);
  EXPECT_GT(turning, 2000) << "the cases do reach beyond bounces";
}

// Bounces far enough apart that signals come in turn.
TEST(MyNow, AlsoUnderFriction) {
  for (const double friction_m_s2 : {0.05, 0.7, 3.0}) {
    int turning = 0;
    compareMyNow(3000, 3, 2.0, friction_m_s2, turning);
    EXPECT_GT(turning, 1000);
  }
}

// It looks ahead on the board by β·(r − r_o)/c.
TEST(MyNow, LiesAheadOnTheBoardWhereTheHeadGoes) {
  test::Random random(52);
  for (int i = 0; i < 500; ++i) {
    CASE(random, i);
    const Case c = randomCase(random, i % 4, 0.5, 0.0);
    const Displacement found = atHeadsMoment(c);
    const Vec3 beta = betaFromU(c.headFromBoard.inverse().u());
    ASSERT_NEAR(placedByKernel(c).boardTime_s, glm::dot(beta, found.dr_m) / kC_m_s, kTolerance_m) << i;
  }
}

// A rod along its motion relative to the head is there 1/γ of its length, γ = γ1 γ2 (1 − β1·β2); one across
// is as long as at rest.
TEST(MyNow, BodiesAreContractedByTheirMotionRelativeToTheHead) {
  test::Random random(53);
  for (int i = 0; i < 500; ++i) {
    CASE(random, i);
    const Vec3 u = random.u(0.95), uHead = random.u(0.95);
    const WorldLine line({{0.3, random.inBox(1.0)}, u, 0.0, {}, 0.0}, kC_m_s, 0.5);
    const Lorentz headFromBoard = Lorentz::boost(-uHead, kC_m_s);
    const Event eye{random.in(-2.0, 2.0), random.inBox(2.0)};
    const auto lengthOf = [&](const Vec3& halfRod_m) {
      return glm::length(placedByKernel({line, halfRod_m, eye, headFromBoard}).inHead_m -
                         placedByKernel({line, -halfRod_m, eye, headFromBoard}).inHead_m);
    };
    const Vec3 headInBody = (Lorentz::boost(-u, kC_m_s) * Lorentz::boost(uHead, kC_m_s)).u();
    const double gamma = gammaFromU(u) * gammaFromU(uHead) - glm::dot(u, uHead);
    const Vec3 along = glm::normalize(headInBody);
    const Vec3 across = glm::normalize(glm::cross(along, random.direction()));
    ASSERT_NEAR(lengthOf(0.5 * along), 1.0 / gamma, kTolerance_m) << "case " << i;
    ASSERT_NEAR(lengthOf(0.5 * across), 1.0, kTolerance_m) << "case " << i;
  }
}

// For a head at rest on the board its moment is the board's.
TEST(MyNow, OfAHeadAtRestIsTheBoards) {
  test::Random random(54);
  for (int i = 0; i < 500; ++i) {
    CASE(random, i);
    Case c = randomCase(random, i % 5, 0.3, 0.0);
    c.headFromBoard = Lorentz(kC_m_s);
    const auto history = vertexHistory(c.line, c.offset_m);
    const Vec3 place_m = placeAt(pieceAt(history, c.eye.t_s), c.eye.t_s, kC_m_s);
    ASSERT_LT(glm::length(placedByKernel(c).inHead_m - (place_m - c.eye.r_m)), kTolerance_m) << i;
  }
}

// Without aberration the same events are drawn where they are on the board.
TEST(MyNow, WithoutAberrationIsDrawnWhereItIsOnTheBoard) {
  test::Random random(55);
  for (int i = 0; i < 500; ++i) {
    CASE(random, i);
    Case c = randomCase(random, i % 5, 0.3, 0.0);
    c.headFromBoard = Lorentz::boost(random.u(0.95), kC_m_s);  // axes as the board's
    ASSERT_LT(glm::length(placedByKernel(c, {1, 1, 0}).inHead_m - atHeadsMoment(c).dr_m), kTolerance_m) << i;
  }
}

// Asked for, the board's moment is what switching retardation off shows.
TEST(BoardNow, IsTheViewWithoutRetardation) {
  test::Random random(56);
  for (int i = 0; i < 500; ++i) {
    CASE(random, i);
    const Case c = randomCase(random, i % 5, 0.3, i % 2 == 0 ? 0.0 : 0.3);
    BodyView asked, switched;
    viewBody(c.line, c.eye, c.headFromBoard, asked, {}, ViewTime::boardNow);
    viewBody(c.line, c.eye, c.headFromBoard, switched, {0, 1, 1});
    ASSERT_FALSE(asked.retarded);
    ASSERT_EQ(asked.legs.size(), switched.legs.size());
    for (std::size_t leg = 0; leg < asked.legs.size(); ++leg) {
      ASSERT_EQ(asked.legs[leg].seenCentre, switched.legs[leg].seenCentre) << "case " << i;
      ASSERT_EQ(asked.legs[leg].toMoment, switched.legs[leg].toMoment) << "case " << i;
    }
  }
}

// The centre's own event and clock, as the solve for single points finds them.
TEST(CentreSeen, IsTheCentresEmission) {
  test::Random random(57);
  for (int i = 0; i < 2000; ++i) {
    CASE(random, i);
    const Case c = randomCase(random, i % 9, 0.3, i % 2 == 0 ? 0.0 : 0.3);
    const Motion centre = centreSeen(c.line, c.eye);
    const double late_m = kC_m_s * (c.eye.t_s - centre.event.t_s) - glm::length(c.eye.r_m - centre.event.r_m);
    ASSERT_NEAR(late_m, 0.0, kTolerance_m) << "case " << i;
    const Motion there = c.line.at(centre.event.t_s);
    ASSERT_LT(glm::length(centre.event.r_m - there.event.r_m), kTolerance_m) << "case " << i;
    ASSERT_NEAR(centre.properTime_s, there.properTime_s, kTolerance_m) << "case " << i;
    const Motion now = centreSeen(c.line, c.eye, {0, 1, 1});
    ASSERT_EQ(now.event.t_s, c.eye.t_s);
    ASSERT_LT(glm::length(now.event.r_m - c.line.at(c.eye.t_s).event.r_m), kTolerance_m) << "case " << i;
  }
}

}  // namespace
}  // namespace carom
