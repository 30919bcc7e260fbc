// Events of the board in the room: a boost keeps the present event and all intervals, and the order of two
// events by their heights is that of the frame.
#include "engine/sculpture/sculpture_place.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/light_speed.h"
#include "engine/random_world.h"
#include "engine/sculpture/sculpture_reach.h"

namespace carom {
namespace {

using test::kC_m_s;

SculpturePlace placeOf(test::Random& random) {
  SculpturePlace place;
  place.roomFromFoot = {random.inBox(3.0),
                        glm::angleAxis(random.in(-3.0, 3.0), glm::normalize(random.inBox(1.0)))};
  place.scale = random.in(0.05, 1.0);
  place.past_s = random.in(0.0, 8.0);
  const double beta = random.in(0.0, kMostSculptureBeta), angle = random.in(0.0, 6.3);
  place.beta = {beta * std::cos(angle), beta * std::sin(angle), 0.0};
  return place;
}

/// Returns the square of the interval between two places of the model, time upwards.
double square_m2(const Vec3& d) { return d.z * d.z - d.x * d.x - d.y * d.y; }

TEST(SculpturePlace, ABoostKeepsThePresentEventAndAllIntervals) {
  test::Random random(3620);
  for (int i = 0; i < 2000; ++i) {
    CASE(random, i);
    const SculpturePlace place = placeOf(random);
    SculpturePlace atRest = place;
    atRest.beta = Vec3(0.0);
    const Event present{random.in(0.0, 3600.0), random.inBox(2.0)};
    const SculptureMap map(place, present, kC_m_s), still(atRest, present, kC_m_s);
    EXPECT_LT(glm::distance(map.room_m(present), still.room_m(present)), 1e-9);
    const Event a{present.t_s + random.in(-5.0, 5.0), {random.in(-2.0, 2.0), random.in(-2.0, 2.0), 0.04}};
    const Event b{present.t_s + random.in(-5.0, 5.0), {random.in(-2.0, 2.0), random.in(-2.0, 2.0), 0.04}};
    const Vec3 ofA = map.model_m(a), ofB = map.model_m(b);
    ASSERT_NEAR(square_m2(ofB - ofA), interval_m2(b - a, kC_m_s), 1e-8);
    ASSERT_NEAR(glm::distance(map.room_m(a), map.room_m(b)), place.scale * glm::length(ofB - ofA), 1e-9);
    // A frame that moves with β has first what is first by t − β·r/c.
    const double later_s = b.t_s - a.t_s - glm::dot(place.beta, b.r_m - a.r_m) / kC_m_s;
    if (std::abs(later_s) > 1e-9) {
      ASSERT_EQ(ofB.z > ofA.z, later_s > 0.0);
    }
    const Event again = map.eventAt(ofA, a.r_m.z);
    ASSERT_NEAR(again.t_s, a.t_s, 1e-8);
    ASSERT_LT(glm::distance(again.r_m, a.r_m), 1e-8);
  }
}

// Whatever is shown between foot and top, within a distance of the present on the board, happens between the
// times that are told for it, and no frame shows what is older than the reach.
TEST(SculpturePlace, TellsTheTimesThatItShows) {
  test::Random random(3621);
  int shown = 0, nearBorder = 0;
  for (int i = 0; i < 20000; ++i) {
    CASE(random, i);
    const SculpturePlace place = placeOf(random);
    const Event present{random.in(0.0, 3600.0), random.inBox(2.0)};
    const SculptureMap map(place, present, kC_m_s);
    const double away_m = random.in(0.1, 4.0), angle = random.in(0.0, 6.3);
    const Vec3 aside = away_m * random.in(0.0, 1.0) * Vec3(std::cos(angle), std::sin(angle), 0.0);
    const Span span = map.shownWithin(away_m);
    const Event event{random.in(span.from_s - 0.5, span.until_s + 0.5), present.r_m + aside};
    const double height_m = map.model_m(event).z;
    if (height_m < 0.0 || height_m > map.top_m()) continue;
    ++shown;
    ASSERT_GE(event.t_s, span.from_s - 1e-9);
    ASSERT_LE(event.t_s, span.until_s + 1e-9);
    ASSERT_GE(event.t_s, present.t_s - reachWithin_s(place, kC_m_s, away_m) - 1e-9);
    nearBorder += std::min(event.t_s - span.from_s, span.until_s - event.t_s) < 0.3 ? 1 : 0;
  }
  EXPECT_GT(shown, 3000);
  EXPECT_GT(nearBorder, 100) << "the times are not much wider than what is shown";
}

}  // namespace
}  // namespace carom
