// Soft bodies against closed forms of shock waves, references of bounces that were extrapolated in the cell
// size, other frames, and the conservation laws.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <memory>

#include "engine/random_world.h"
#include "engine/soft/soft_group.h"
#include "sanitized.h"

namespace carom {
namespace {

constexpr double kRadius = 0.0305, kMass = 0.2;

Vec21 movingWith(const glm::dvec2& beta) {
  const double gamma = 1.0 / std::sqrt(1.0 - glm::dot(beta, beta));
  return {gamma, gamma * beta.x, gamma * beta.y};
}

SoftBody disc(int cells, const SoftMaterial& material, const glm::dvec2& centre, const glm::dvec2& beta,
              InstructionSet instructions = bestInstructionSet()) {
  return SoftBody(std::make_shared<SoftMesh>(softDisc(kRadius, cells)), material, kMass, centre,
                  movingWith(beta), instructions);
}

/// A four-momentum in a frame that moves with `beta`.
Vec21 seenFrom(const glm::dvec2& beta, const Vec21& p) {
  const Vec21 u = movingWith(beta);
  const double along = p.x * u.x + p.y * u.y, share = along / (u.t + 1.0) - p.t;
  return {u.t * p.t - along, p.x + share * u.x, p.y + share * u.y};
}

double angularMomentum(const SoftTotals& totals) {
  return totals.spin + totals.centre.x * totals.momentum.y - totals.centre.y * totals.momentum.x;
}

TEST(SoftMesh, HasTheNodesTrianglesAndMassOfItsShape) {
  for (const int cells : {4, 7, 12}) {
    const SoftMesh mesh = softDisc(1.0, cells);
    EXPECT_EQ(mesh.places().size(), 3u * cells * (cells + 1) + 1);
    EXPECT_EQ(mesh.triangles().size(), 6u * cells * cells);
    EXPECT_EQ(mesh.hull().size(), 6u * cells);
  }
  const SoftMesh mesh = softRectangle({0.04, 0.02}, 8);
  EXPECT_EQ(mesh.triangles().size(), 2u * 16 * 8);
  double mass = 0.0;
  glm::dvec2 centre(0.0);
  for (std::size_t i = 0; i < mesh.places().size(); ++i) {
    mass += mesh.nodeShare(i);
    centre += mesh.nodeShare(i) * mesh.places()[i];
  }
  EXPECT_NEAR(mass, 1.0, 1e-14);
  EXPECT_NEAR(glm::length(centre), 0.0, 1e-16);
}

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

struct Bounce {
  double normalRatio = 0.0, massRatio = 0.0;
  Vec21 momentum;
};

/// A disc that comes to a cushion with `normal` of c, in a frame that moves with `along` of c along it.
Bounce bounced(int cells, const SoftMaterial& material, double normal, double along) {
  const double slow = std::sqrt(1.0 - along * along);
  SoftBody body = disc(cells, material, {0.0, 0.0}, {normal * slow, along});
  const Vec21 before = body.totals().momentum;
  // 1.2 R away: a disc that moves obliquely is an ellipse aslant.
  SoftGroup group({&body}, {{{1.0, 0.0}, 1.2 * kRadius}});
  group.advance(20.0 * kRadius / slow);
  const SoftTotals after = body.totals();
  EXPECT_NEAR(after.momentum.t, before.t, 1e-12 * before.t);
  EXPECT_NEAR(after.momentum.x - group.impulseOf(0).x, before.x, 1e-12 * before.t);
  EXPECT_NEAR(after.momentum.y, before.y, 1e-12 * before.t);
  EXPECT_GT(after.heat, 0.0);
  return {after.momentum.x / before.x, after.restMass() / kMass, seenFrom({0.0, along}, after.momentum)};
}

// Momentum back, extrapolated in the cell size with another program: 0.675, 0.651, 0.653 at 0.3, 0.6, 0.8 c.
// With N cells it lacks about 0.33/N of the momentum.
TEST(SoftBody, BouncesOffACushionAsTheReferences) {
  struct Case {
    double speed, sound, ratio;
  };
  for (const Case& one : test::someOf({Case{0.6, 0.5, 0.651}, Case{0.3, 0.5, 0.675}, Case{0.8, 0.5, 0.653},
                                       Case{0.6, 0.25, 0.517}, Case{0.6, 0.7, 0.709}})) {
    SCOPED_TRACE(testing::Message() << one.speed << " c, sound " << one.sound);
    EXPECT_NEAR(bounced(8, {one.sound, 0.15}, one.speed, 0.0).normalRatio, -one.ratio, 0.05);
    EXPECT_NEAR(bounced(16, {one.sound, 0.15}, one.speed, 0.0).normalRatio, -one.ratio, 0.03);
  }
}

TEST(SoftBody, BouncesAlikeInEveryFrame) {
  const Bounce rest = bounced(12, {0.5, 0.15}, 0.6, 0.0);
  for (const double along : {0.3, 0.6}) {
    const Bounce moving = bounced(12, {0.5, 0.15}, 0.6, along);
    EXPECT_NEAR(moving.momentum.x / (0.75 * kMass), rest.momentum.x / (0.75 * kMass), 0.006) << along;
    EXPECT_NEAR(moving.momentum.y / kMass, 0.0, 1e-11) << along;
    EXPECT_NEAR(moving.massRatio, rest.massRatio, 0.006) << along;
  }
}

// Two discs, any directions: four-momentum to rounding, angular momentum to truncation.
TEST(SoftBody, ConservesMomentumBetweenTwo) {
  test::Random random(41);
  for (int k = 0; k < 6; ++k) {
    CASE(random, k);
    const double speed = random.in(0.1, 0.7), offset = random.in(-1.0, 1.0) * kRadius;
    const SoftMaterial one{random.in(0.3, 0.7), random.in(0.1, 0.4)}, two{random.in(0.3, 0.7), 0.3};
    SoftBody a = disc(8, one, {-1.2 * kRadius, offset}, {speed, 0.0});
    SoftBody b = disc(8, two, {1.2 * kRadius, -offset}, {-0.5 * speed, 0.2});
    const SoftTotals a0 = a.totals(), b0 = b.totals();
    SoftGroup group({&a, &b}, {});
    group.advance(10.0 * kRadius / speed);
    const SoftTotals a1 = a.totals(), b1 = b.totals();
    const Vec21 before = a0.momentum + b0.momentum, change = a1.momentum + b1.momentum - before;
    EXPECT_NEAR(change.t, 0.0, 1e-12 * before.t);
    EXPECT_NEAR(change.x, 0.0, 1e-12 * before.t);
    EXPECT_NEAR(change.y, 0.0, 1e-12 * before.t);
    EXPECT_NEAR(angularMomentum(a1) + angularMomentum(b1), angularMomentum(a0) + angularMomentum(b0),
                0.014 * kMass * kRadius);
    EXPECT_GT(a1.heat + b1.heat, -2e-3 * kMass);
  }
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
