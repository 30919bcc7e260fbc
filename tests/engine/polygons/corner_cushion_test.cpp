// Bodies with corners at cushions, against dense sampling and against discs.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "engine/polygons/corner_cushion.h"
#include "engine/polygons/corner_pairs.h"

namespace carom {
namespace {

using test::flight;
using test::RandomPairs;
using test::regular;
using test::SampledBody;
using Vec2 = glm::dvec2;

// The earliest corner by the body's own time, by dense sampling with explicit boosts.
TEST(CornerContact, CushionsAsSampled) {
  RandomPairs random(5);
  int contacts = 0, atCorners = 0;
  for (int n = 0; n < 500; ++n) {
    SCOPED_TRACE(n);
    const auto corners = random.outline();
    const Outline outline(corners);
    const Vec2 beta = random.beta();
    const double turning = n % 2 == 0 ? 0.0 : random.uniform(-0.9, 0.9) / outline.radius();
    const Vec2 place{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)};
    const CushionPlane plane{n % 4 < 2 ? 0 : 1, random.uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0, 0.4};
    const MovingShape body = flight(place, beta, outline, turning);
    const auto found = findCornerContact(body, 0.0, plane, TurnConvention::signalAtCentre);
    const double speed = plane.sign * (plane.axis == 0 ? beta.x : beta.y);
    ASSERT_TRUE(found || !(speed > 0.05));
    if (!found) continue;
    ++contacts;
    const SampledBody sampled(corners, body.start, beta, turning, outline.radius());
    EXPECT_WITHIN(plane.inside(found->contact.event), 0.0, 1e-15);
    // The centre turns when the light of the contact reaches it.
    const Vec21 signal = found->contact.turn.x - found->contact.event;
    EXPECT_WITHIN(dot(signal, signal), 0.0, 1e-13);
    EXPECT_GT(signal.t, 0.0);
    EXPECT_GE(plane.inside(found->contact.turn.x), 0.0);
    const double own = sampled.restPlace(found->contact.event).t;
    // Where a corner's news would come too late, the contact is straight ahead of the centre, after the
    // corner's.
    bool atCorner = found->sideOnSide;
    for (const Vec2& d : corners)
      atCorner = atCorner || std::abs(glm::length(d) - (found->contact.turn.properTime - own)) < 1e-9;
    if (!atCorner) continue;
    ++atCorners;
    EXPECT_TRUE(found->sideOnSide || std::abs(sampled.depthOf(found->contact.event)) <= 1e-10);
    for (int k = 0; k < 300; ++k) {
      const double s = own * (k + 0.5) / 300.0;
      for (const Vec2& d : corners) {
        EXPECT_GT(plane.inside(sampled.eventOf(d, s)), -1e-9);
      }
    }
  }
  EXPECT_GT(contacts, 200);
  EXPECT_GT(atCorners, contacts * 3 / 4);
}

TEST(CornerContact, ManyCornersMeetACushionAsADiscDoes) {
  const Outline many(regular(256, 0.03));
  const CushionPlane plane{0, 1.0, 0.5};
  const MovingShape body = flight({0.0, 0.0}, {0.8, 0.3}, many);
  for (const TurnConvention convention :
       {TurnConvention::signalAtCentre, TurnConvention::simultaneousWithContact}) {
    const auto disc = findContact({body.start, body.u, 0.0, 0.0}, 0.03, plane, convention);
    const auto found = findCornerContact(body, 0.0, plane, convention);
    ASSERT_TRUE(disc && found);
    EXPECT_WITHIN(found->contact.turn.x.t, disc->turn.x.t, 1e-4);
    EXPECT_WITHIN(found->contact.event.y, disc->event.y, 2e-3);
  }
}

}  // namespace
}  // namespace carom
