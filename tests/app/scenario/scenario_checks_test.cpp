// Checks of a scenario that involve several of its values.
#include "app/scenario/scenario_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>
#include <string>

#include "app/scenario/scenario_text.h"
#include "app/toml/input_file.h"

namespace carom {
namespace {

using test::Fault;
using test::kHead;
using test::kOther;
using test::kPuck;
using test::puckText;
using test::read;
using test::ScenarioFaults;

// Reference for overlapping ellipses: does a point of one's rim or its centre lie inside the other?
struct Ellipse {
  Vec2 centre_m, beta;
  double radius_m;
  double levelAt(Vec2 p_m) const {  // 1 on the rim
    const Vec2 d_m = p_m - centre_m;
    const double gamma2 = 1.0 / (1.0 - glm::dot(beta, beta));
    return std::sqrt(glm::dot(d_m, d_m) + gamma2 * glm::dot(d_m, beta) * glm::dot(d_m, beta)) / radius_m;
  }
  Vec2 rim(double angle) const {
    const Vec2 n(std::cos(angle), std::sin(angle));
    return centre_m + n / levelAt(centre_m + n);
  }
};

/// The least level of `b` on or inside `a`, below 1 where they overlap.
double leastLevel(const Ellipse& a, const Ellipse& b) {
  constexpr int kRimPoints = 20000;
  double least = a.levelAt(b.centre_m) < 1.0 ? 0.0 : b.levelAt(a.centre_m);
  for (int i = 0; i < kRimPoints; ++i) {
    least = std::min(least, b.levelAt(a.rim(2.0 * std::numbers::pi * i / kRimPoints)));
  }
  return least;
}

TEST(Scenario, RefusesExactlyThePucksThatOverlap) {
  std::mt19937_64 random(20240611);
  const auto in = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  int apart = 0, overlapping = 0;
  for (int i = 0; i < 300; ++i) {
    const auto beta = [&] {
      const double speed = 1.0 - std::pow(10.0, in(-4.0, 0.0)), angle = in(0.0, 2.0 * std::numbers::pi);
      return Vec2(speed * std::cos(angle), speed * std::sin(angle));
    };
    const Ellipse a{{in(-1, 1), in(-1, 1)}, beta(), in(0.2, 1.5)},
        b{{in(-1, 1), in(-1, 1)}, beta(), in(0.2, 1.5)};
    const double level = leastLevel(a, b);
    constexpr double kSampling = 0.01;  // the reference's own error: too near to call
    if (std::abs(level - 1.0) < kSampling) continue;
    const std::string text = "light_speed_m_s = 1\n" + puckText("a", a.radius_m, a.centre_m, a.beta) +
                             puckText("b", b.radius_m, b.centre_m, b.beta);
    if (level > 1.0) {
      EXPECT_NO_THROW(read(text)) << text;
      ++apart;
    } else {
      EXPECT_THROW(read(text), InputErrors) << text;
      ++overlapping;
    }
  }
  EXPECT_GT(apart, 50);
  EXPECT_GT(overlapping, 50);
}

TEST(Scenario, PucksAndCushionsMayTouch) {
  EXPECT_NO_THROW(read("light_speed_m_s = 1\n[board]\nlength_m = 2\nwidth_m = 2\n" +
                       puckText("a", 0.3, {-0.3, 0.7}, {0, 0}) + puckText("b", 0.3, {0.3, 0.7}, {0, 0})));
  // Contracted to 60 % along its motion a puck fits where it would not at rest.
  EXPECT_NO_THROW(read("light_speed_m_s = 1\n[board]\nlength_m = 2\nwidth_m = 2\n" +
                       puckText("a", 0.5, {0.7, 0}, {0.8, 0})));
  EXPECT_THROW(read("light_speed_m_s = 1\n[board]\nlength_m = 2\nwidth_m = 2\n" +
                    puckText("a", 0.5, {0.71, 0}, {0.8, 0})),
               InputErrors);
}

INSTANTIATE_TEST_SUITE_P(
    Checks, ScenarioFaults,
    ::testing::Values(
        Fault{"friction", kHead + "[physics]\nfriction_m_s2 = 5\n" + kPuck, 3, 17, "expected below 5"},
        Fault{"same name",
              kHead + kPuck +
                  "[[body]]\nname = 'a'\nat = { t_s = 0, r_m = [0, 0, 0] }\n[[body.leg]]\nbeta = [0, 0, 0]\n",
              9, 8, "taken in line 3"},
        Fault{"overlap",
              kHead + kPuck +
                  "[[puck]]\nname = 'b'\nradius_m = 0.1\nmass_kg = 1\nposition_m = [0.1, 0]\nbeta = [0, 0]\n",
              12, 14, "overlaps puck 'a'"},
        Fault{"off the table", kHead + "[board]\nlength_m = 1\nwidth_m = 1\n" + kOther, 9, 14,
              "over the y cushion"},
        Fault{"flash of a puck's name", kHead + kPuck + "[[flash]]\nname = 'a'\nat_s = 1\nr_m = [0, 0, 0]\n",
              9, 8, "is taken"}),
    test::nameOfFault);

}  // namespace
}  // namespace carom
