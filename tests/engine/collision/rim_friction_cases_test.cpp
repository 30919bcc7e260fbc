// Kicks with rim friction against exact cases, from an oracle of 50 digits.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/collision/puck_contact.h"
#include "engine/collision/rim_friction.h"
#include "exact_cases.h"

namespace carom {
namespace {

using Json = nlohmann::json;

// Written so that NaN fails.
#define EXPECT_WITHIN(value, expected, tolerance)            \
  EXPECT_TRUE(std::abs((value) - (expected)) <= (tolerance)) \
      << #value " = " << (value) << ", expected " << (expected)

/// A puck and its kick in SI units.
struct Case {
  double c_m_s, radius_m;
  SpinningPuck puck;
};

Case caseOf(const Json& json, double c_m_s) {
  const double mass_kg = json["m"], radius_m = json["R"], rim_kg = mass_kg * json["k"].get<double>();
  const double x = json["v"][0].get<double>() / c_m_s, y = json["v"][1].get<double>() / c_m_s;
  const double gamma = 1.0 / std::sqrt(1.0 - (x * x + y * y));
  const double j = json["J"].get<double>() / (radius_m * c_m_s);
  return {c_m_s, radius_m, {{mass_kg, rim_kg}, j, fourVelocity(gamma * x, gamma * y)}};
}

RimRules rulesOf(const Json& input) {
  const double unlimited = std::numeric_limits<double>::infinity();
  return {input["e_n"], input["mu"].is_null() ? unlimited : input["mu"].get<double>(), input["e_t"]};
}

void expectOutcome(const Case& before, const Vec21& u, double j, double heat, const Json& v, double spin,
                   double omega, double mass, double heat_kg, const Json& tolerance) {
  const auto within = [&](const char* key) { return tolerance[key].get<double>(); };
  EXPECT_WITHIN(u.x / u.t * before.c_m_s, v[0].get<double>(), within("v"));
  EXPECT_WITHIN(u.y / u.t * before.c_m_s, v[1].get<double>(), within("v"));
  EXPECT_WITHIN(j * before.radius_m * before.c_m_s, spin, within("J"));
  EXPECT_WITHIN(rimBeta(before.puck.body, j) * before.c_m_s / before.radius_m, omega, within("omega"));
  EXPECT_WITHIN(restMass(before.puck.body, j), mass, within("mass"));
  EXPECT_WITHIN(heat, heat_kg, within("heat"));
}

void expectCushion(const Json& one) {
  const Json &input = one["input"], &expected = one["expected"];
  const double nx = input["normal"][0], ny = input["normal"][1];
  ASSERT_EQ(std::abs(nx) + std::abs(ny), 1.0) << "cushions stand along x or y";
  const CushionPlane plane{nx != 0.0 ? 0 : 1, nx + ny, 1.0};
  const Case before = caseOf(input["puck"], input["c"]);
  const auto kick = kickSpinningOffCushion(plane, before.puck, rulesOf(input));
  ASSERT_TRUE(kick);
  expectOutcome(before, kick->centre.u, kick->j, kick->centre.heat, expected["v"], expected["J"],
                expected["omega"], expected["mass"], expected["heat"], one["tol"]);
}

void expectPair(const Json& one) {
  const Json &input = one["input"], &expected = one["expected"];
  const double c_m_s = input["c"];
  std::array<Case, 2> before{caseOf(input["pucks"][0], c_m_s), caseOf(input["pucks"][1], c_m_s)};
  std::array<Disc, 2> discs;
  for (int i = 0; i < 2; ++i) {
    const Json& place = input["pucks"][i]["r"];
    discs[i] = {{0.0, place[0], place[1]}, before[i].puck.u, before[i].radius_m};
  }
  const PairContact contact = contactOf(discs[0], discs[1], false);
  const auto kick = kickSpinningPair(contact.U, contact.n, {before[0].puck, before[1].puck}, rulesOf(input));
  ASSERT_TRUE(kick);
  for (int i = 0; i < 2; ++i) {
    SCOPED_TRACE(i);
    expectOutcome(before[i], kick->centres.u[i], kick->j[i], kick->centres.heat[i], expected["v"][i],
                  expected["J"][i], expected["omega"][i], expected["mass"][i], expected["heat"][i],
                  one["tol"]);
  }
}

void expectCase(const Json& one) {
  SCOPED_TRACE(one["id"].get<std::string>());
  if (one["input"]["kind"] == "cushion") {
    expectCushion(one);
  } else {
    expectPair(one);
  }
}

TEST(RimFrictionCases, allOfTheOracle) {
  for (const Json& one : test::exactCases("spin_collisions.json")) expectCase(one);
}

}  // namespace
}  // namespace carom
