// Touches that follow each other soon are one collision; later ones are another.
#include "engine/soft/soft_collisions.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>

#include "engine/soft/soft_discs.h"

namespace carom {
namespace {

using test::kMass, test::kSmallRadius;
constexpr std::array<std::size_t, 1> kMembers{7};  // the body's number in the play

/// A disc that runs to and fro between two cushions.
struct Bouncing {
  SoftBody body{
      std::make_shared<SoftMesh>(softDisc(kSmallRadius, 6)), {}, kMass, {0.0, 0.0}, {1.25, 0.75, 0.0}};
  SoftGroup group{{&body}, {{{1.0, 0.0}, 0.1}, {{-1.0, 0.0}, 0.1}}};
  double soundTime = 2.0 * kSmallRadius / body.material().soundSpeed;
  double time = 0.0;

  /// Steps, and notes and ends collisions. Returns how many have begun.
  std::size_t stepInto(SoftCollisions& collisions) {
    time += group.step(0.001);
    std::size_t begun = 0;
    for (const SoftExchange& touch : group.exchanges())
      begun += collisions.note(touch, group, kMembers, time) ? 1U : 0U;
    collisions.end(time, [&](std::size_t number) {
      EXPECT_EQ(number, kMembers[0]);
      return soundTime;
    });
    return begun;
  }
};

TEST(SoftCollisions, EachBounceIsOneCollision) {
  Bouncing bouncing;
  SoftCollisions collisions;
  std::size_t begun = 0;
  while (bouncing.time < 3.0) begun += bouncing.stepInto(collisions);
  ASSERT_GE(begun, 3U);
  ASSERT_EQ(collisions.all().size(), begun);
  EXPECT_GE(collisions.parted().size(), begun - 1);
  glm::dvec2 taken(0.0);
  for (std::size_t k = 0; k < begun; ++k) {
    const SoftCollision& one = collisions.all()[k];
    SCOPED_TRACE(k);
    EXPECT_EQ(one.body, 7U);
    EXPECT_EQ(one.other, SoftExchange::kNone);
    EXPECT_EQ(one.cushion, k % 2) << "to and fro";
    EXPECT_GT(one.lastTouch, one.contact.t);
    EXPECT_LT(one.lastTouch, one.contact.t + 3.0 * bouncing.soundTime);
    EXPECT_GT(one.heat(), 0.0) << "a bounce leaves heat in the body";
    EXPECT_NEAR(std::abs(one.contact.x), 0.1, 1e-3) << "at the cushion";
    if (k > 0) {
      EXPECT_GT(one.contact.t, collisions.all()[k - 1].lastTouch + bouncing.soundTime);
    }
    taken += one.impulse;
  }
  EXPECT_LT(glm::distance(taken, bouncing.group.impulseOf(0) + bouncing.group.impulseOf(1)), 1e-14);
}

// Brought back to where it was, it goes on in the same way; a list whose beginning is not known has something
// in its place.
TEST(SoftCollisions, GoesOnFromAnEarlierState) {
  Bouncing bouncing;
  SoftCollisions collisions;
  while (collisions.parted().empty()) bouncing.stepInto(collisions);
  const SoftCollisions::State whole = collisions.state({}), tail = collisions.state(collisions.lengths());
  const std::size_t size = collisions.all().size();
  while (collisions.all().size() < size + 2) bouncing.stepInto(collisions);
  SoftCollisions again;
  again.restore(tail);
  EXPECT_EQ(again.all().size(), size);
  collisions.restore(whole);
  EXPECT_EQ(collisions.all().size(), size);
  EXPECT_EQ(collisions.parted().size(), 1U);
  EXPECT_TRUE(collisions.all().front().isOver);
  EXPECT_GT(collisions.all().front().heat(), 0.0);
}

}  // namespace
}  // namespace carom
