#pragma once
// Random pairs of bodies with corners, and discs, whose contacts are compared with dense sampling
// (sampled_body.h) in the frame of equal speeds with boosts of its own.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "engine/polygons/corner_contact.h"
#include "engine/sampled_body.h"

// Written so that NaN fails.
#define EXPECT_WITHIN(value, expected, tolerance)            \
  EXPECT_TRUE(std::abs((value) - (expected)) <= (tolerance)) \
      << #value " = " << (value) << ", expected " << (expected)

namespace carom::test {

using Vec2 = glm::dvec2;

inline std::vector<Vec2> regular(int corners, double radius, double angle = 0.0) {
  std::vector<Vec2> all;
  for (int k = 0; k < corners; ++k) {
    const double at = angle + 2.0 * M_PI * k / corners;
    all.push_back({radius * std::cos(at), radius * std::sin(at)});
  }
  return all;
}

inline std::vector<Vec2> rectangle(double length, double width) {
  return {{-0.5 * length, -0.5 * width},
          {0.5 * length, -0.5 * width},
          {0.5 * length, 0.5 * width},
          {-0.5 * length, 0.5 * width}};
}

inline MovingShape flight(const Vec2& place, const Vec2& beta, const Outline& outline, double turning = 0.0) {
  return {{0.0, place.x, place.y}, fourVelocityOf(beta), outline.radius(), &outline, 0.0, turning};
}

struct Pair {
  SampledBody first, second;
  Vec2 frame;  // velocity of the frame of equal speeds
};

inline Vec2 frameOf(const Vec2& beta1, const Vec2& beta2) {
  const Vec21 sum = fourVelocityOf(beta1) + fourVelocityOf(beta2);
  return {sum.x / sum.t, sum.y / sum.t};
}

class RandomPairs {
 public:
  explicit RandomPairs(unsigned seed) : random_(seed) {}

  std::vector<Vec2> outline() {
    const int kind = static_cast<int>(uniform(0.0, 4.0));
    const double size = uniform(0.02, 0.06);
    if (kind == 0) return rectangle(2.0 * size, size * std::pow(10.0, uniform(-3.0, 0.3)));
    if (kind == 1) return regular(3 + static_cast<int>(uniform(0.0, 7.0)), size, uniform(0.0, 6.0));
    std::vector<Vec2> star;  // not convex
    const int corners = 5 + static_cast<int>(uniform(0.0, 6.0));
    for (int k = 0; k < corners; ++k) {
      const double at = 2.0 * M_PI * (k + uniform(0.0, 0.8)) / corners, far = size * uniform(0.4, 1.0);
      star.push_back({far * std::cos(at), far * std::sin(at)});
    }
    return faultOf(star) ? outline() : star;
  }
  Vec2 beta() {
    const double at = uniform(0.0, 2.0 * M_PI), fast = uniform(0.0, 1.0);
    const double speed = fast < 0.2 ? 1.0 - std::pow(10.0, uniform(-3.0, -1.0)) : uniform(0.0, 0.95);
    return {speed * std::cos(at), speed * std::sin(at)};
  }
  // They come near each other, more or less, after about `when`.
  std::pair<Vec2, Vec2> placesFor(const Vec2& beta1, const Vec2& beta2) {
    const double when = uniform(0.15, 0.6);
    const Vec2 beside{uniform(-0.07, 0.07), uniform(-0.07, 0.07)};
    return {-beta1 * when, beside - beta2 * when};
  }
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

 private:
  std::mt19937_64 random_;
};

struct Tally {
  int contacts = 0, none = 0, grazing = 0;
};

inline double distanceOfCentres(const Pair& pair, const Matrix& frame, double time) {
  const Vec21 apart =
      pair.first.eventAt({0.0, 0.0}, frame, time) - pair.second.eventAt({0.0, 0.0}, frame, time);
  return std::sqrt(std::max(0.0, -dot(apart, apart)));
}

// The contact found lies on both outlines and they go into each other after it. No sample before it, or at
// all where none is found, has a corner inside: a sample a millimetre of light, wherever the bodies can
// touch.
inline void expectAgreement(const Pair& pair, const std::optional<CornerContact>& found, Tally& tally) {
  const Matrix frame = boost(pair.frame);
  const double start = std::max((frame * pair.first.start).t, (frame * pair.second.start).t);
  const double reach = pair.first.radius + pair.second.radius;
  double until = start + 1.5;
  if (found) {
    const Vec21& C = found->contact.event;
    EXPECT_WITHIN(pair.first.depthOf(C), 0.0, 1e-10);
    EXPECT_WITHIN(pair.second.depthOf(C), 0.0, 1e-10);
    EXPECT_GT(C.t, 0.0);
    until = (frame * C).t;
    double deepest = -1.0;
    for (const double after : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2})
      deepest = std::max(deepest, depthAt(pair.first, pair.second, frame, until + after * reach));
    ++(deepest > 1e-12 ? tally.contacts : tally.grazing);
  } else {
    ++tally.none;
  }
  constexpr double kStep = 1e-3;
  for (double time = start + 0.5 * kStep; time < until; time += kStep) {
    const double apart = distanceOfCentres(pair, frame, time);
    if (apart > reach) {
      time += std::max(0.0, 0.5 * (apart - reach) - kStep);
      continue;
    }
    // The rim is sampled at 64 points; what lies inside only between them is found by the engine alone.
    const double depth = depthAt(pair.first, pair.second, frame, time);
    if (depth > 1e-7 && time < until - 1e-9) {
      ADD_FAILURE() << "a corner is " << depth << " m inside at " << time << " of " << until;
      return;
    }
  }
}

inline void expectRandomPairs(unsigned seed, int count, bool withDisc, double spinning) {
  RandomPairs random(seed);
  Tally tally;
  const auto tested = [&] { return tally.contacts + tally.none + tally.grazing; };
  for (int n = 0; tested() < count && !testing::Test::HasFailure(); ++n) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", pair " + std::to_string(n));
    const auto corners1 = random.outline();
    const auto corners2 = withDisc ? std::vector<Vec2>{} : random.outline();
    const Vec2 beta1 = random.beta(), beta2 = random.beta();
    const auto [place1, place2] = random.placesFor(beta1, beta2);
    const Outline outline1(corners1);
    const std::optional<Outline> outline2 = withDisc ? std::nullopt : std::optional<Outline>(corners2);
    const double radius2 = withDisc ? random.uniform(0.02, 0.05) : outline2->radius();
    const bool spins = random.uniform(0.0, 1.0) < spinning;
    const double turning1 = spins ? random.uniform(-0.99, 0.99) / outline1.radius() : 0.0;
    const double turning2 = spins && !withDisc ? random.uniform(-0.99, 0.99) / radius2 : 0.0;
    MovingShape first = flight(place1, beta1, outline1, turning1);
    MovingShape second{{0.0, place2.x, place2.y},
                       fourVelocityOf(beta2),
                       radius2,
                       withDisc ? nullptr : &*outline2,
                       0.0,
                       turning2};
    const Pair pair{{corners1, first.start, beta1, turning1, outline1.radius()},
                    {corners2, second.start, beta2, turning2, radius2},
                    frameOf(beta1, beta2)};
    const Matrix frame = boost(pair.frame);
    const double apart = (frame * Vec21{0.0, place1.x - place2.x, place1.y - place2.y}).t;
    // Only pairs that are apart as the later flight begins, whatever the frame.
    const double reach = outline1.radius() + radius2;
    if (glm::length(place1 - place2) < 2.0 * reach + std::abs(apart)) continue;
    expectAgreement(pair, findCornerContact(first, second), tally);
  }
  EXPECT_GT(tally.contacts, count / 10);
  EXPECT_GT(tally.none, count / 20);
  EXPECT_LT(tally.grazing, count / 200);
}

}  // namespace carom::test
