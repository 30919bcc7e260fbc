// Light of sampled points, against the world line through the same places and against bisection.
#include "engine/light/sampled_history.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "engine/light/point_emission.h"
#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::kC_m_s;

struct Flight {
  static constexpr std::size_t kVertices = 3;
  std::vector<double> times_s;
  std::vector<Vec3> places_m;  ///< of all vertices at each time

  Vec3 at_m(double t_s, std::size_t vertex) const {
    std::size_t row = 0;
    while (row + 2 < times_s.size() && times_s[row + 1] <= t_s) ++row;
    const double share = (t_s - times_s[row]) / (times_s[row + 1] - times_s[row]);
    return glm::mix(places_m[row * kVertices + vertex], places_m[(row + 1) * kVertices + vertex], share);
  }
};

Flight randomFlight(test::Random& random, int rows) {
  Flight flight;
  double t_s = random.in(-1.0, 1.0);
  std::vector<Vec3> places_m;
  for (std::size_t k = 0; k < Flight::kVertices; ++k) places_m.push_back(random.inBox(1.0));
  for (int row = 0; row < rows; ++row) {
    flight.times_s.push_back(t_s);
    flight.places_m.insert(flight.places_m.end(), places_m.begin(), places_m.end());
    const double step_s = random.in(0.02, 0.5);
    t_s += step_s;
    for (Vec3& place_m : places_m) place_m += random.direction() * (random.in(0.0, 0.95) * kC_m_s * step_s);
  }
  return flight;
}

double lateBy_m(const Flight& flight, double t_s, std::size_t vertex, const Event& eye) {
  return kC_m_s * (eye.t_s - t_s) - glm::length(eye.r_m - flight.at_m(t_s, vertex));
}

TEST(SampledHistory, LightComesFromWhereBisectionFindsIt) {
  test::Random random(71);
  int seen = 0, unseen = 0;
  for (int i = 0; i < 500; ++i) {
    CASE(random, i);
    const Flight flight = randomFlight(random, 2 + i % 9);
    const SampledHistory history(kC_m_s, flight.times_s, flight.places_m);
    ASSERT_EQ(history.rowCount(), flight.times_s.size());
    ASSERT_EQ(history.vertexCount(), Flight::kVertices);
    const Event eye{flight.times_s.front() + random.in(-0.5, 6.0), random.inBox(3.0)};
    const Lorentz headFromBoard = Lorentz::boost(random.u(0.9), kC_m_s);
    for (std::size_t vertex = 0; vertex < Flight::kVertices; ++vertex) {
      const auto found = history.seenAt(vertex, eye, headFromBoard);
      const double first_s = flight.times_s.front();
      if (lateBy_m(flight, first_s, vertex, eye) < 0.0) {
        EXPECT_FALSE(found);
        ++unseen;
        continue;
      }
      ASSERT_TRUE(found);
      ++seen;
      double before_s = first_s, after_s = eye.t_s;
      for (int step = 0; step < 80; ++step) {
        const double middle_s = 0.5 * (before_s + after_s);
        (lateBy_m(flight, middle_s, vertex, eye) >= 0.0 ? before_s : after_s) = middle_s;
      }
      EXPECT_NEAR(found->event.t_s, before_s, 1e-9);
      EXPECT_NEAR(glm::distance(found->event.r_m, flight.at_m(before_s, vertex)), 0.0, 1e-9);
      // Its own clock: the sum of the intervals.
      double own_s = 0.0, from_s = first_s;
      for (std::size_t row = 1; from_s < found->event.t_s; ++row) {
        const bool isLast = row + 1 >= flight.times_s.size();
        const double to_s = isLast ? found->event.t_s : std::min(found->event.t_s, flight.times_s[row]);
        const double beta = glm::distance(flight.at_m(to_s, vertex), flight.at_m(from_s, vertex)) /
                            (kC_m_s * (to_s - from_s));
        own_s += (to_s - from_s) * std::sqrt(1.0 - beta * beta);
        from_s = to_s;
      }
      EXPECT_NEAR(found->properTime_s, own_s, 1e-7);
      EXPECT_NEAR(glm::distance(found->seen.dr_m, (headFromBoard * (found->event - eye)).dr_m), 0.0, 1e-9);
    }
  }
  EXPECT_GT(seen, 500);
  EXPECT_GT(unseen, 20);
}

// A point that flies straight is that of a world line with one knot; with velocities of its own it shines
// with those, mixed between its rows.
TEST(SampledHistory, ShinesWithTheVelocityThatItHasOrIsTold) {
  test::Random random(72);
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    const Vec3 beta = random.direction() * random.in(0.0, 0.95), from_m = random.inBox(1.0);
    const std::vector<double> times_s{0.0, 0.5, 1.5};
    std::vector<Vec3> places_m;
    for (const double t_s : times_s) places_m.push_back(from_m + t_s * kC_m_s * beta);
    const std::vector<Vec3> told{Vec3(0.5, 0.0, 0.0), Vec3(0.0, 0.5, 0.0), Vec3(0.0, 0.0, 0.5)};
    const SampledHistory history(kC_m_s, times_s, places_m), shining(kC_m_s, times_s, places_m, told);
    const Event eye{random.in(4.0, 9.0), random.inBox(1.0)};
    const Lorentz headFromBoard = Lorentz::boost(random.u(0.9), kC_m_s);
    const auto found = history.seenAt(0, eye, headFromBoard), other = shining.seenAt(0, eye, headFromBoard);
    ASSERT_TRUE(found && other);
    EXPECT_NEAR(glm::distance(found->u, uFromBeta(beta)), 0.0, 1e-9 * (1.0 + glm::length(found->u)));
    EXPECT_NEAR(found->doppler,
                dopplerFactor(found->event - eye, uFromBeta(beta), headFromBoard.inverse().u()),
                1e-9 * found->doppler);
    EXPECT_EQ(found->event.t_s, other->event.t_s);
    const double share = std::min(1.0, std::max(0.0, other->event.t_s - 0.5));
    const Vec3 mixed = other->event.t_s < 0.5 ? glm::mix(told[0], told[1], 2.0 * other->event.t_s)
                                              : glm::mix(told[1], told[2], share);
    EXPECT_NEAR(glm::distance(other->u, uFromBeta(mixed)), 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace carom
