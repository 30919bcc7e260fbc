// `carom simulate` and `carom observe` with pucks that spin, against exact collisions and other ways to say
// the same.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/program.h"
#include "exact_cases.h"

namespace carom {
namespace {

using nlohmann::json;
using test::answerOf;
using test::exact;
using test::exactCases;
using test::runCarom;
using test::TemporaryFolder;

std::string puckText(const std::string& name, const json& puck, double c, double x_m, double y_m) {
  return "[[puck]]\nname = \"" + name + "\"\nradius_m = " + exact(puck["R"]) +
         "\nmass_kg = " + exact(puck["m"]) + "\nposition_m = [" + exact(x_m) + ", " + exact(y_m) +
         "]\nbeta = [" + exact(puck["v"][0].get<double>() / c) + ", " +
         exact(puck["v"][1].get<double>() / c) + "]\ninertia = " + exact(puck["k"]) +
         "\nspin_kg_m2_s = " + exact(puck["J"]) + "\n";
}

std::string rulesText(const json& input, const std::string& what) {
  const std::string friction = input["mu"].is_null() ? "inf" : exact(input["mu"]);
  return "[physics]\n" + what + "_friction = " + friction + "\n" + what +
         "_restitution = " + exact(input["e_n"]) + "\ntangential_restitution = " + exact(input["e_t"]) + "\n";
}

constexpr double kFromCushion_m = 0.5;

/// One puck, half a metre from the cushion towards which `normal` points; the others are far.
std::string cushionScenario(const json& input) {
  constexpr double kFar_m = 100.0, kHalf_m = 1.0;
  const double x = input["normal"][0], y = input["normal"][1];
  return "light_speed_m_s = " + exact(input["c"]) +
         "\n[board]\nlength_m = " + exact(2.0 * (x != 0.0 ? kHalf_m : kFar_m)) +
         "\nwidth_m = " + exact(2.0 * (y != 0.0 ? kHalf_m : kFar_m)) + "\n" + rulesText(input, "cushion") +
         puckText("first", input["puck"], input["c"], x * (kHalf_m - kFromCushion_m),
                  y * (kHalf_m - kFromCushion_m));
}

std::string pairScenario(const json& input) {
  std::string text = "light_speed_m_s = " + exact(input["c"]) + "\n" + rulesText(input, "puck");
  for (int i = 0; i < 2; ++i) {
    const json& puck = input["pucks"][i];
    text += puckText(i == 0 ? "first" : "second", puck, input["c"], puck["r"][0], puck["r"][1]);
  }
  return text;
}

void checkTurn(const json& turn, const json& puck, const json& v, const json& J, const json& tolerance,
               double c) {
  for (int i = 0; i < 2; ++i)
    EXPECT_NEAR(turn["beta_after"][i].get<double>() * c, v[i].get<double>(), tolerance["v"].get<double>());
  EXPECT_NEAR(turn["spin_after_kg_m2_s"].get<double>(), J.get<double>(), tolerance["J"].get<double>());
  EXPECT_NEAR(turn["spin_before_kg_m2_s"].get<double>(), puck["J"].get<double>(), 1e-16);
}

TEST(SimulateSpin, RoughRimsKickAsExactCasesSay) {
  const json cases = exactCases("spin_collisions.json");
  const TemporaryFolder folder;
  for (const json& testCase : cases) {
    SCOPED_TRACE(testCase["id"].get<std::string>() + " " + testCase["input"]["group"].get<std::string>());
    const json &input = testCase["input"], &expected = testCase["expected"], &tolerance = testCase["tol"];
    const bool cushion = input["kind"] == "cushion";
    const double c = input["c"];
    double until_s = 4.0;
    if (cushion) {  // soon after the bounce
      const json &n = input["normal"], &v = input["puck"]["v"];
      until_s = 0.3 + kFromCushion_m /
                          (n[0].get<double>() * v[0].get<double>() + n[1].get<double>() * v[1].get<double>());
    }
    const json found = answerOf(folder, "simulate", cushion ? cushionScenario(input) : pairScenario(input),
                                {"--until", exact(until_s)});
    ASSERT_EQ(found["collisions"].size(), 1u);
    const json& collision = found["collisions"][0];
    double heat_kg = 0.0;
    for (std::size_t i = 0; i < (cushion ? 1u : 2u); ++i) {
      const auto of = [&](const char* key) { return cushion ? expected[key] : expected[key][i]; };
      const json& puck = cushion ? input["puck"] : input["pucks"][i];
      checkTurn(collision["turns"][i], puck, of("v"), of("J"), tolerance, c);
      const json& after = found["pucks"][i];
      EXPECT_NEAR(after["rest_mass_kg"].get<double>(), of("mass").get<double>(),
                  tolerance["mass"].get<double>());
      EXPECT_NEAR(after["spin_rad_s"].get<double>(), of("omega").get<double>(),
                  tolerance["omega"].get<double>());
      heat_kg += of("heat").get<double>();
    }
    EXPECT_NEAR(collision["heat_j"].get<double>(), heat_kg * c * c,
                2.0 * c * c * tolerance["heat"].get<double>());
    if (cushion) continue;
    EXPECT_NEAR(collision["contact"]["t_s"].get<double>(), expected["contact"][0].get<double>(), 1e-12);
    for (int i = 0; i < 2; ++i)
      EXPECT_NEAR(collision["contact"]["r_m"][i].get<double>(), expected["contact"][i + 1].get<double>(),
                  1e-12);
  }
}

const std::string kDiscLines =
    "name = \"disc\"\nradius_m = 0.03\nheight_m = 0.02\nmass_kg = 0.2\nposition_m = [-0.3, 0.1]\nbeta = "
    "[0.6, "
    "0.2]\n";

// The key gives the rate or the angular momentum; the angle is 0 at board time 0.
TEST(SimulateSpin, SaysSpinsAnglesAndRestMasses) {
  const TemporaryFolder folder;
  const double c = 1.42, R = 0.03, m = 0.2, omega = -30.0;
  const double f = omega * R / c, j = 0.5 * m * f / std::sqrt(1.0 - f * f);
  const std::string head = "light_speed_m_s = 1.42\n[[puck]]\n" + kDiscLines;
  const json byRate =
      answerOf(folder, "simulate", head + "spin_rad_s = -30\n", {"--until", "2", "--every", "1"});
  const json& puck = byRate["pucks"][0];
  EXPECT_NEAR(puck["spin_kg_m2_s"].get<double>(), j * R * c, 1e-16);
  EXPECT_NEAR(puck["spin_rad_s"].get<double>(), omega, 1e-13);
  EXPECT_NEAR(puck["rest_mass_kg"].get<double>(), 0.1 + std::hypot(0.1, j), 1e-15);
  EXPECT_EQ(puck["mass_kg"], 0.2);
  const double gamma = 1.0 / std::sqrt(1.0 - 0.4);
  for (const int i : {0, 1, 2}) {
    const json& state = byRate["states"][i];
    EXPECT_EQ(state["spin_kg_m2_s"][0], puck["spin_kg_m2_s"]);
    EXPECT_NEAR(
        std::remainder(state["angle_rad"][0].get<double>() - omega * i / gamma, 2.0 * std::numbers::pi), 0.0,
        1e-13);
  }
  const json byMomentum =
      answerOf(folder, "simulate", head + "spin_kg_m2_s = " + exact(j * R * c) + "\n", {"--until", "2"});
  EXPECT_NEAR(byMomentum["pucks"][0]["spin_rad_s"].get<double>(), omega, 1e-13);
}

// A puck on its straight way and a told body that moves and turns like it.
TEST(SimulateSpin, PointsOfPucksAreSeenAsThoseOfToldBodies) {
  const TemporaryFolder folder;
  const std::string scenario =
      "light_speed_m_s = 1.42\n[[puck]]\n" + kDiscLines +
      "spin_rad_s = 42\n[[body]]\nname = \"told\"\nat = { t_s = 0, r_m = [-0.3, 0.1, 0.01] }\nspin_rad_s = "
      "42\n[[body.leg]]\nbeta = [0.6, 0.2, 0]\n";
  const json found = answerOf(folder, "observe", scenario,
                              {"--event", "2", "0.2", "-0.4", "0.3", "--beta", "0.3", "0.1", "0", "--point",
                               "disc", "0.02", "0.01", "0.005", "--point", "told", "0.02", "0.01", "0.005"});
  const json &puck = found["points"][0], &told = found["points"][1];
  for (const char* key : {"distance_m", "doppler", "proper_time_s"})
    EXPECT_NEAR(puck[key].get<double>(), told[key].get<double>(), 1e-11) << key;
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(puck["seen_m"][i].get<double>(), told["seen_m"][i].get<double>(), 1e-12);
    EXPECT_NEAR(puck["beta_at_emission"][i].get<double>(), told["beta_at_emission"][i].get<double>(), 1e-10);
  }
}

struct SeenPoint {
  double t_s;
  double r_m[3], beta[3], clock_s;
};

// Before, in and after bounces, with friction on the cloth, and of a spin that it takes: the point is on the
// past cone, its own clock counts what its velocity says, and its place changes by its velocity.
TEST(SimulateSpin, PointsGoOnThroughBouncesAndGlides) {
  const TemporaryFolder folder;
  const double c = 1.42;
  for (const std::string friction : {"0.0", "0.4"}) {
    const std::string scenario =
        "light_speed_m_s = 1.42\n[board]\nlength_m = 1.0\nwidth_m = 1.0\n[physics]\n"
        "friction_m_s2 = " +
        friction + "\ncushion_friction = 0.3\nspin_deceleration_m_s2 = 0.7\n[[puck]]\n" + kDiscLines +
        "spin_rad_s = 40\n";
    const auto see = [&](double t_s) {
      const json point = answerOf(folder, "observe", scenario,
                                  {"--event", exact(t_s), "0", "0.1", "0.3", "--point", "disc", "0.021",
                                   "-0.018", "0.01"})["points"][0];
      SeenPoint seen{};
      seen.t_s = point["emission"]["t_s"], seen.clock_s = point["proper_time_s"];
      double way_m2 = 0.0;
      for (int i = 0; i < 3; ++i) {
        seen.r_m[i] = point["emission"]["r_m"][i], seen.beta[i] = point["beta_at_emission"][i];
        way_m2 += std::pow(seen.r_m[i] - (i == 0 ? 0.0 : i == 1 ? 0.1 : 0.3), 2);
      }
      EXPECT_NEAR(c * (t_s - seen.t_s), std::sqrt(way_m2), 1e-11);
      return seen;
    };
    for (double t_s = 0.6; t_s < 2.4; t_s += 0.0937) {
      constexpr double kStep_s = 2e-5;
      const SeenPoint before = see(t_s), now = see(t_s + kStep_s), after = see(t_s + 2.0 * kStep_s);
      double speed2 = 0.0, chord2 = 0.0;
      for (int i = 0; i < 3; ++i) {
        speed2 += now.beta[i] * now.beta[i];
        chord2 += std::pow((after.r_m[i] - before.r_m[i]) / (c * (after.t_s - before.t_s)), 2);
      }
      ASSERT_LT(speed2, 1.0);
      EXPECT_NEAR(std::sqrt(chord2), std::sqrt(speed2), 2e-3) << "at " << t_s;
      EXPECT_NEAR((after.clock_s - before.clock_s) / (after.t_s - before.t_s), std::sqrt(1.0 - speed2), 2e-3);
    }
  }
}

TEST(SimulateSpin, CheckSaysWhatIsOdd) {
  const TemporaryFolder folder;
  const std::string file =
      folder.file("odd.toml", "light_speed_m_s = 1.42\n[physics]\ntangential_restitution = 0.5\n[[puck]]\n" +
                                  kDiscLines + "spin_rad_s = 47.1\n");
  const auto result = runCarom(folder, {"check", file});
  EXPECT_EQ(result.status, 0);
  for (const char* words : {":3:26: tangential_restitution does nothing", ":11:14: the rim of puck 'disc'"})
    EXPECT_NE((result.err + result.out).find(words), std::string::npos) << result.err << result.out;
  EXPECT_NE(result.out.find("spins at 47.1 rad/s, its rim at 0.995"), std::string::npos) << result.out;
}

// A value that is no number is one fault.
TEST(SimulateSpin, CheckNamesASpinThatIsNoNumberOnce) {
  const TemporaryFolder folder;
  const auto result =
      runCarom(folder, {"check", folder.file("odd.toml", "light_speed_m_s = 1.42\n[[puck]]\n" + kDiscLines +
                                                             "spin_rad_s = nan\n")});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err.find("error:"), result.err.rfind("error:")) << result.err;
}

}  // namespace
}  // namespace carom
