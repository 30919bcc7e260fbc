#include "engine/linked/seats.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "engine/random_world.h"

namespace carom {
namespace {

using test::Random;

TEST(Seats, StandRoundTheBoardAndFaceIt) {
  const ObserverStart scenario;  // 1.6 m on the −y side, facing +y
  const ObserverStart first = seat(scenario, 0, 2, 0.0), second = seat(scenario, 1, 2, 1.0);
  EXPECT_EQ(first.position_m, scenario.position_m);
  EXPECT_NEAR(second.position_m.x, 0.0, 1e-15);
  EXPECT_NEAR(second.position_m.y, 2.1, 1e-15);
  EXPECT_EQ(second.position_m.z, scenario.position_m.z);
  EXPECT_NEAR(second.facing_rad, 1.5 * std::numbers::pi, 1e-15);
  const ObserverStart third = seat(scenario, 1, 4, 0.0);
  EXPECT_NEAR(third.position_m.x, 1.6, 1e-15);
  EXPECT_NEAR(std::cos(third.facing_rad), -1.0, 1e-15);
}

TEST(Seats, MovePlatformsAlongTheirOwnWay) {
  ObserverStart scenario;
  scenario.beta = {0.0, 0.3, 0.0};
  EXPECT_NEAR(seat(scenario, 1, 2, 0.0).beta.y, -0.3, 1e-15);
}

TEST(Seats, AtTheCentreAreMovedBackwards) {
  ObserverStart scenario;
  scenario.position_m = {0.0, 0.0, -0.75};
  EXPECT_NEAR(seat(scenario, 0, 2, 2.0).position_m.y, -1.0, 1e-15);
  EXPECT_NEAR(seat(scenario, 1, 2, 2.0).position_m.y, 1.0, 1e-15);
}

/// The least distance between points of two floors, by trying points of their edges.
double byPoints_m(const ObserverStart& a, const Floor& of_a, const ObserverStart& b, const Floor& of_b) {
  const auto points = [](const ObserverStart& start, const Floor& floor) {
    const glm::dvec2 forward(std::cos(start.facing_rad), std::sin(start.facing_rad));
    const glm::dvec2 right(forward.y, -forward.x), at(start.position_m);
    std::vector<glm::dvec2> found;
    for (int i = 0; i <= 200; ++i) {
      const glm::dvec2 way = floor.most_m - floor.least_m;
      const double s = i / 200.0;
      for (const glm::dvec2 p :
           {floor.least_m + glm::dvec2(s * way.x, 0.0), floor.least_m + glm::dvec2(s * way.x, way.y),
            floor.least_m + glm::dvec2(0.0, s * way.y), floor.least_m + glm::dvec2(way.x, s * way.y)})
        found.push_back(at + p.x * right + p.y * forward);
    }
    return found;
  };
  double least_m = 1e9;
  for (const glm::dvec2& p : points(a, of_a)) {
    for (const glm::dvec2& q : points(b, of_b)) least_m = std::min(least_m, glm::distance(p, q));
  }
  return least_m;
}

TEST(Seats, KnowHowFarFloorsAreApart) {
  Random random(5);
  int apart = 0, overlap = 0;
  for (int i = 0; i < 60; ++i) {
    CASE(random, i);
    const auto draw = [&](ObserverStart& start, Floor& floor) {
      start.position_m = {random.in(-3.0, 3.0), random.in(-3.0, 3.0), 0.0};
      start.facing_rad = random.in(-3.0, 3.0);
      floor.least_m = {random.in(-2.0, -0.5), random.in(-2.0, -0.5)};
      floor.most_m = {random.in(0.5, 2.0), random.in(0.5, 2.0)};
    };
    ObserverStart a, b;
    Floor of_a, of_b;
    draw(a, of_a);
    draw(b, of_b);
    const double distance_m = floorsApart_m(a, of_a, b, of_b);
    EXPECT_EQ(distance_m, floorsApart_m(b, of_b, a, of_a));
    if (distance_m > 0.0) {
      EXPECT_NEAR(distance_m, byPoints_m(a, of_a, b, of_b), 0.02);
      EXPECT_LE(distance_m, byPoints_m(a, of_a, b, of_b) + 1e-12);
    }
    ++(distance_m > 0.0 ? apart : overlap);
  }
  EXPECT_GT(apart, 10);
  EXPECT_GT(overlap, 5);
}

// Floors of 2 m × 2 m whose middles are 3.2 m apart leave 1.2 m between them.
TEST(Seats, AreMovedApartAsFarAsTheLineNeeds) {
  const ObserverStart scenario;
  const std::array<Floor, 2> floors{};
  EXPECT_EQ(apartFor_m(scenario, floors, 1.2 - 1e-9), 0.0);
  EXPECT_NEAR(apartFor_m(scenario, floors, 3.0), 1.8, 0.051);
  EXPECT_GE(apartFor_m(scenario, floors, 3.0), 1.8 - 1e-9);
  EXPECT_EQ(apartFor_m(scenario, floors, 100.0), kMostApart_m);
  EXPECT_NEAR(distanceFor_m(0.3, 1.42), 0.71, 1e-12);
}

}  // namespace
}  // namespace carom
