// Soft bodies in free flight, and against closed forms of shock waves and of the light cone.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <memory>

#include "engine/soft/soft_discs.h"
#include "engine/soft/soft_group.h"

namespace carom {
namespace {

using test::disc, test::kMass, test::kRadius, test::movingWith;

// Relaxed matter that moves evenly is an exact solution of the discrete equations, too.
TEST(SoftBody, KeepsShapeAndClockInFreeFlight) {
  SoftBody body = disc(10, {0.5, 0.3}, {0.0, 0.0}, {0.7, -0.5});
  const SoftBody::State before = body.state();
  SoftGroup group({&body}, {});
  group.advance(0.5);
  for (std::size_t i = 0; i < body.size(); ++i) {
    EXPECT_NEAR(body.place(i).x, before.x[i] + 0.5 * 0.7, 1e-12) << i;
    EXPECT_NEAR(body.place(i).y, before.y[i] - 0.5 * 0.5, 1e-12) << i;
  }
  EXPECT_NEAR(body.totals().restMass(), kMass, 1e-14);
}

// A rod pushed at one end to 0.6 c, sound 0.5: behind the shock own length 0.33743 of the relaxed one, the
// shock at 0.82186 c (closed form of the jump conditions). The far end rests until it comes, 1.2167 ℓ0 later.
TEST(SoftBody, TheFarEndOfAPushedRodWaitsForTheShock) {
  constexpr double kHalf = 0.04;
  auto mesh = std::make_shared<SoftMesh>(softRectangle({kHalf, 0.125 * kHalf}, 40));
  SoftBody rod(mesh, {0.5, 0.15}, kMass, {0.0, 0.0}, movingWith({0.0, 0.0}));
  SoftGroup group({&rod}, {});
  HeldSide side{0, {}, {0.6, 0.0}};
  std::size_t farEnd = 0, middle = 0;
  for (std::size_t i = 0; i < rod.size(); ++i) {
    const glm::dvec2 place = mesh->places()[i];
    if (place.x < -kHalf + 1e-9) side.nodes.push_back(static_cast<int>(i));
    if (glm::length(place - glm::dvec2(kHalf, 0.0)) < 1e-9) farEnd = i;
    if (glm::length(place) < 1e-9) middle = i;
  }
  group.held().push_back(side);
  constexpr double kShock = 0.8218572002286, kStretch = 0.337432707541667;
  const double arrives = 2.0 * kHalf / kShock;
  group.advance(0.8 * arrives);
  EXPECT_NEAR(rod.place(farEnd).x, kHalf, 8e-7);
  EXPECT_NEAR(rod.velocity(farEnd).x, 0.0, 1e-3);
  const double pushed = -kHalf + 0.6 * 0.8 * arrives;
  EXPECT_NEAR(rod.place(middle).x, pushed + kHalf * kStretch * 0.8, 4.8e-4);  // contracted by γ = 1.25
  EXPECT_NEAR(rod.velocity(middle).x, 0.6, 0.02);
  group.advance(0.35 * arrives);
  EXPECT_GT(rod.velocity(farEnd).x, 0.5);
}

// A kicked node of the rim is not felt outside its light cone, but for the numerical precursor.
TEST(SoftBody, NothingIsFeltOutsideTheLightCone) {
  constexpr int kCells = 16;
  SoftBody body = disc(kCells, {0.5, 0.3}, {0.0, 0.0}, {0.0, 0.0});
  SoftBody::State state = body.state();
  const auto kicked = static_cast<std::size_t>(body.mesh().hull().front());
  const double gamma = 1.0 / std::sqrt(1.0 - 0.2 * 0.2);
  state.px[kicked] = gamma * state.e[kicked] * -0.2;
  state.e[kicked] *= gamma;
  state.vx[kicked] = -0.2;
  body.restore(state);
  SoftGroup group({&body}, {});
  group.advance(1.5 * kRadius);
  const glm::dvec2 from = body.mesh().places()[kicked];
  double moved = 0.0;
  for (std::size_t i = 0; i < body.size(); ++i) {
    const glm::dvec2 place = body.mesh().places()[i];
    if (glm::length(place - from) > 1.5 * kRadius + 2.0 * kRadius / kCells)
      moved = std::max(moved, glm::length(body.place(i) - place));
  }
  EXPECT_LT(moved, 2e-6 * kRadius);
}

// The loop over triangles gives the same bits in every vector length.
TEST(SoftBody, HasTheSameBitsOnEveryInstructionSet) {
  std::vector<SoftBody::State> ends;
  for (const InstructionSet set : {InstructionSet::baseline, bestInstructionSet()}) {
    SoftBody body = disc(6, {0.6, 0.2}, {0.0, 0.0}, {0.5, 0.3}, set);
    SoftGroup group({&body}, {{{1.0, 0.0}, 1.1 * kRadius}});
    group.advance(6.0 * kRadius);
    ends.push_back(body.state());
  }
  EXPECT_EQ(ends[0].x, ends[1].x);
  EXPECT_EQ(ends[0].py, ends[1].py);
  EXPECT_EQ(ends[0].e, ends[1].e);
}

}  // namespace
}  // namespace carom
