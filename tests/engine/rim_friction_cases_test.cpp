// Kicks with rim friction against exact cases, from an oracle of 50 digits.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/collision/puck_contact.h"
#include "engine/collision/rim_friction.h"

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
  std::ifstream file(std::filesystem::path(CAROM_SHARED_DIR) / "cases" / "spin_collisions.json");
  if (!file) GTEST_SKIP() << "no shared cases here";
  const Json all = Json::parse(file)["cases"];
  ASSERT_FALSE(all.empty());
  for (const Json& one : all) expectCase(one);
}

// Some of them, for where the file is not: a slide limited by Coulomb's law, a superball, and two pucks of
// different size, one nearly at rest and spinning.
TEST(RimFrictionCases, someOfTheOracle) {
  for (const Json& one : Json::parse(R"([
  {"id": "superball",
   "input": {"kind": "cushion", "c": 1.42, "normal": [1.0, 0.0], "puck": {"m": 0.2, "R": 0.0305, "k":
     0.5, "v": [0.71, 1.136], "J": 0.0}, "e_n": 1.0, "e_t": 1.0, "mu": null},
   "expected": {"v": [-0.71, 0.421022176542881], "J": -0.0163563753235305, "omega": -45.0063262868781,
     "mass": 0.490673384086294, "heat": 6.68191177523049e-52},
   "tol": {"v": 1e-12, "J": 1e-12, "omega": 3.2e-12, "mass": 1e-12, "heat": 1e-12}},
  {"id": "limited slide",
   "input": {"kind": "cushion", "c": 1.42, "normal": [1.0, 0.0], "puck": {"m": 0.2, "R": 0.0305, "k":
     0.5, "v": [0.3, 0.9], "J": -0.008662}, "e_n": 0.7, "e_t": 0.5, "mu": 0.2},
   "expected": {"v": [-0.21, 1.002], "J": -0.00683761181890836, "omega": -39.3312275846662, "mass":
     0.286881908821045, "heat": 0.0144962607878775},
   "tol": {"v": 1e-12, "J": 1e-12, "omega": 4e-12, "mass": 1e-12, "heat": 1e-12}},
  {"id": "pair",
   "input": {"kind": "pair", "c": 1.42, "pucks": [{"m": 0.2, "R": 0.0305, "k": 0.5, "v": [-0.00681,
     1.23883], "J": 0.00043564, "r": [0.0, 0.0]}, {"m": 0.2, "R": 0.04, "k": 0.5, "v": [-0.0038, 3e-05],
     "J": -0.00606768, "r": [0.016833065, 0.500042376]}], "e_n": 0.9, "e_t": 0.5, "mu": null},
   "expected": {"v": [[-0.546564624585825, 0.155119636802474], [0.30621895041651, 1.13098294209223]],
     "J": [0.00165185696265327, -0.00422531138007661], "omega": [16.5913304346409, -21.1885072594347],
     "mass": [0.20702655505716, 0.224634528530649], "heat": [0.0130521875937272, 0.0106199837840625]},
   "tol": {"v": 1e-12, "J": 1e-12, "omega": 4.1e-12, "mass": 1e-12, "heat": 1e-12}}])"))
    expectCase(one);
}

}  // namespace
}  // namespace carom
