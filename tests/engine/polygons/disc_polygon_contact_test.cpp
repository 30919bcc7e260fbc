// Contacts of discs with bodies with corners.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "engine/polygons/corner_contact.h"
#include "engine/polygons/corner_pairs.h"

namespace carom {
namespace {

using test::expectRandomPairs;
using test::flight;
using test::RandomPairs;
using test::regular;
using Vec2 = glm::dvec2;

TEST(CornerContact, RandomPairsWithDiscsAsSampled) { expectRandomPairs(3, 1000, true, 0.33); }

// A side of a spinning body is straight in its own frame, and between its corners in the frame of equal
// speeds.
TEST(CornerContact, ManyCornersTouchAsADiscDoes) {
  constexpr double kRadius = 0.03;
  RandomPairs random(4);
  for (int n = 0; n < 200; ++n) {
    SCOPED_TRACE(n);
    const Outline many(regular(64, kRadius));
    const Vec2 beta1 = random.beta(), beta2 = random.beta();
    const auto [place1, place2] = random.placesFor(beta1, beta2);
    const MovingShape first = flight(place1, beta1, many), second = flight(place2, beta2, many);
    const Disc disc1{first.start, first.u, kRadius}, disc2{second.start, second.u, kRadius};
    const auto meeting = findMeeting(disc1, disc2, TurnConvention::signalAtCentre);
    const MovingShape rim{second.start, second.u, kRadius, nullptr, 0.0, 0.0};
    const auto found = findCornerContact(first, second), withRim = findCornerContact(first, rim);
    const double b = std::abs(dot(cross(first.u, second.u), second.start - first.start)) /
                     std::sqrt(std::pow(dot(first.u, second.u), 2) - 1.0);
    if (!meeting || b > 1.5 * kRadius || meeting->withoutDelay) continue;
    ASSERT_TRUE(found && withRim);
    const PairContact expected = contactOf(disc1, disc2, false);
    const double gamma = dot(first.u, second.u);
    for (const PairContact& contact : {found->contact, withRim->contact}) {
      // The outline lies up to R (1 − cos(π/64)) inside each disc.
      const Vec21 apart = contact.event - expected.event;
      EXPECT_WITHIN(dot(apart, expected.U), 0.0, 0.02 * kRadius * gamma);
      EXPECT_WITHIN(std::sqrt(std::max(0.0, dot(apart, apart) * -1.0)), 0.0, 0.12 * kRadius * gamma);
    }
  }
}

}  // namespace
}  // namespace carom
