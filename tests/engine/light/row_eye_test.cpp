// The solve of an eye on rows against bisection in long steps, for every kind of moment; and as the eye moves
// on.

#include "engine/light/row_eye.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/random_world.h"

namespace carom {
namespace {

using test::Random;

constexpr double kC = 1.42;

/// Points that go anywhere below light speed, in rows of uneven lengths.
struct WanderingPoints {
  std::vector<double> times_m;
  std::vector<std::vector<Vec3>> places_m;  // of each row
  Vec3 eye_m{0.0};
  double now_m = 0.0;

  WanderingPoints(Random& random, std::size_t rows, std::size_t points) {
    std::vector<Vec3> place(points);
    for (Vec3& at : place) at = random.direction() * 0.1;
    double time = 0.0;
    for (std::size_t k = 0; k < rows; ++k) {
      times_m.push_back(time);
      places_m.push_back(place);
      const double step = random.in(0.0005, 0.02);
      for (Vec3& at : place) at += random.direction() * (random.in(0.0, 0.98) * step);
      time += step;
    }
  }

  std::size_t count() const { return times_m.size(); }
  double time_m(std::size_t k) const { return times_m[k] - now_m; }
  Vec3 fromEye_m(std::size_t k, std::size_t point) const { return places_m[k][point] - eye_m; }
  Vec3 velocityBefore(std::size_t) const { return {0.3, 0.0, 0.0}; }
  Vec3 velocityAfter(std::size_t) const { return {-0.2, 0.1, 0.0}; }

  /// Where a point is, from the eye, at a time from the observation.
  Vec3 at(double time, std::size_t point) const {
    if (time < time_m(0)) return fromEye_m(0, point) + (time - time_m(0)) * velocityBefore(point);
    std::size_t k = count() - 1;
    while (time_m(k) > time) --k;
    const Vec3 from = fromEye_m(k, point);
    if (k + 1 == count()) return from + (time - time_m(k)) * velocityAfter(point);
    return from + (time - time_m(k)) / (time_m(k + 1) - time_m(k)) * (fromEye_m(k + 1, point) - from);
  }
};

template <typename F>
double bisected(double least, double most, const F& isBefore) {
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (least + most);
    (isBefore(middle) ? least : most) = middle;
  }
  return least;
}

TEST(RowEye, FindsTheOneEventOfEachMoment) {
  Random random(34);
  for (int run = 0; run < 60; ++run) {
    CASE(random, run);
    WanderingPoints points(random, 80, 20);
    const Vec3 beta = random.direction() * random.in(0.0, 0.9);
    const Lorentz headFromBoard = Lorentz::boost(uFromBeta(-beta), kC);
    points.now_m = random.in(-0.2, 1.6);
    points.eye_m = random.direction() * random.in(0.2, 0.8);
    const Event observation{points.now_m / kC, points.eye_m};
    for (const ViewTime moment : {ViewTime::seen, ViewTime::boardNow, ViewTime::myNow}) {
      const RowEye eye(observation, headFromBoard, {}, moment);
      for (std::size_t i = 0; i < 20; ++i) {
        const RowSpot spot = eye.find(points, i, static_cast<std::size_t>(random.in(0.0, 79.0)));
        const double expected = bisected(-10.0, 10.0, [&](double t) {
          const Vec3 at = points.at(t, i);
          if (moment == ViewTime::boardNow) return t < 0.0;
          if (moment == ViewTime::myNow) return t < glm::dot(beta, at);
          return t < -glm::length(at);
        });
        ASSERT_NEAR(spot.boardTime_m, expected, 1e-11);
        ASSERT_NEAR(glm::length(spot.fromEye_m - points.at(expected, i)), 0.0, 1e-11);
        EXPECT_EQ(spot.isBeforeAll, expected < points.time_m(0));
        // Drawn along the straight ray from it, in the head's frame.
        const Displacement way{spot.boardTime_m / kC, spot.fromEye_m};
        if (moment == ViewTime::boardNow) continue;
        const Vec3 drawn = eye.drawn(spot.boardTime_m, spot.fromEye_m);
        EXPECT_NEAR(glm::length(drawn - (headFromBoard * way).dr_m), 0.0, 1e-12);
      }
    }
  }
}

// The seen event of a point moves on as the eye's does, and never back; its place by less than 1/(1 − β).
TEST(RowEye, ASweptEyeSeesEveryPointMoveOn) {
  Random random(5);
  WanderingPoints points(random, 200, 10);
  std::vector<RowSpot> before(10);
  constexpr double kStep_m = 0.0007;
  for (int frame = 0; frame < 4000; ++frame) {
    points.now_m = -0.3 + kStep_m * frame;
    const RowEye eye({points.now_m / kC, points.eye_m}, Lorentz(kC), {});
    for (std::size_t i = 0; i < 10; ++i) {
      const RowSpot spot = eye.find(points, i, before[i].row);
      const double time = spot.boardTime_m + points.now_m;
      if (frame > 0) {
        const double earlier = before[i].boardTime_m + points.now_m - kStep_m;
        ASSERT_GT(time, earlier);
        ASSERT_LE(glm::length(spot.fromEye_m - before[i].fromEye_m), 0.98 / (1.0 - 0.98) * kStep_m);
      }
      before[i] = spot;
    }
  }
}

}  // namespace
}  // namespace carom
