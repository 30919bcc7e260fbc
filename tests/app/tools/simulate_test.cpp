// `carom simulate` against exact collisions, computed elsewhere to 30 digits by brute force.

#include "app/tools/simulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/program.h"
#include "app/scenario/scenario.h"
#include "exact_cases.h"

namespace carom {
namespace {

using nlohmann::json;
using test::answerOf;
using test::exact;
using test::exactCases;
using test::kThreePucks;
using test::runCarom;
using test::TemporaryFolder;

std::string vectorText(double x, double y) { return "[" + exact(x) + ", " + exact(y) + "]"; }

std::string puckText(const std::string& name, double radius, double mass, const std::string& place,
                     const std::string& beta) {
  return "[[puck]]\nname = \"" + name + "\"\nradius_m = " + exact(radius) + "\nmass_kg = " + exact(mass) +
         "\nposition_m = " + place + "\nbeta = " + beta + "\n";
}

json simulate(const TemporaryFolder& folder, const std::string& scenario, double until_s,
              const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"--until", exact(until_s)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return answerOf(folder, "simulate", scenario, arguments);
}

void expectNear(const json& vector, double x, double y, double tolerance) {
  EXPECT_NEAR(vector.at(0).get<double>(), x, tolerance);
  EXPECT_NEAR(vector.at(1).get<double>(), y, tolerance);
}

/// The scenario of a two-puck case.
std::string pairScenario(const json& input, double restitution) {
  const double c = input["c"];
  std::string text =
      "light_speed_m_s = " + exact(c) + "\n[physics]\npuck_restitution = " + exact(restitution) + "\n";
  for (int i = 0; i < 2; ++i) {
    const json& puck = input["pucks"][i];
    text +=
        puckText(i == 0 ? "first" : "second", puck["R"], puck["m"], vectorText(puck["r"][0], puck["r"][1]),
                 vectorText(puck["v"][0].get<double>() / c, puck["v"][1].get<double>() / c));
  }
  return text;
}

/// A collision's turns of the pucks named first and second.
json turnOf(const json& collision, const std::string& name) {
  for (const json& turn : collision["turns"]) {
    if (turn["puck"] == name) return turn;
  }
  ADD_FAILURE() << "no turn of " << name << " in " << collision;
  return {};
}

void checkPair(const json& testCase, const json& found, const json& velocitiesAfter) {
  const json& expected = testCase["expected"]["frames"]["cov"];
  const double tolerance = testCase["tol_abs"], c = testCase["input"]["c"];
  ASSERT_GE(found["collisions"].size(), 1u);
  const json& collision = found["collisions"][0];
  EXPECT_EQ(collision["kind"], "puck-puck");
  EXPECT_NEAR(collision["contact"]["t_s"].get<double>(), expected["contact"]["t"].get<double>(), tolerance);
  expectNear(collision["contact"]["r_m"], expected["contact"]["r"][0], expected["contact"]["r"][1],
             tolerance);
  for (int i = 0; i < 2; ++i) {
    const json turn = turnOf(collision, i == 0 ? "first" : "second");
    const json& centre = expected["centre_delayed"][i];
    EXPECT_NEAR(turn["t_s"].get<double>(), centre["t"].get<double>(), tolerance);
    expectNear(turn["r_m"], centre["r"][0], centre["r"][1], tolerance);
    EXPECT_NEAR(turn["proper_time_s"].get<double>(), expected["tau_delayed"][i].get<double>(), tolerance);
    const json& before = testCase["input"]["pucks"][i]["v"];
    expectNear(turn["beta_before"], before[0].get<double>() / c, before[1].get<double>() / c, tolerance);
    const json& after = velocitiesAfter[i];
    expectNear(turn["beta_after"], after[0].get<double>() / c, after[1].get<double>() / c, tolerance);
  }
}

TEST(Simulate, PucksCollideAsExactCasesSay) {
  const json cases = exactCases("puck_collisions.json");
  const TemporaryFolder folder;
  int hits = 0;
  for (const json& testCase : cases) {
    SCOPED_TRACE(testCase["id"].get<std::string>() + " " + testCase["input"]["group"].get<std::string>());
    const std::string status = testCase["expected"]["status"];
    if (status == "overlap_at_t0") {
      const auto result =
          runCarom(folder, {"check", folder.file("scenario.toml", pairScenario(testCase["input"], 1.0))});
      EXPECT_EQ(result.status, 1);
      continue;
    }
    if (status != "hit") {
      constexpr double kLong_s = 1e3;
      EXPECT_TRUE(simulate(folder, pairScenario(testCase["input"], 1.0), kLong_s)["collisions"].empty());
      continue;
    }
    ++hits;
    const json& expected = testCase["expected"]["frames"]["cov"];
    const double contact_s = expected["contact"]["t"].get<double>();
    const double until_s = std::max(contact_s, 0.0) + 1e-6 * (1.0 + std::abs(contact_s));
    checkPair(testCase, simulate(folder, pairScenario(testCase["input"], 1.0), until_s), expected["v_after"]);
    for (const json& damped : testCase["expected"]["restitution_cov"]) {
      SCOPED_TRACE("restitution " + damped["e"].dump());
      checkPair(testCase, simulate(folder, pairScenario(testCase["input"], damped["e"]), until_s),
                damped["impulse"]["v_after"]);
    }
  }
  EXPECT_GT(hits, 5);
}

/// A puck before one of its table's cushions, the others far away. The case's table reaches from (0, 0); ours
/// is centred, with `origin` of the case's frame at our coordinates.
struct CushionSetup {
  std::string scenario;
  std::string cushion;
  Vec2 origin;
};

CushionSetup beforeCushion(const json& input, const std::string& wall, double restitution) {
  const double c = input["c"];
  const Vec2 table(input["table"][0], input["table"][1]), r(input["r"][0], input["r"][1]);
  const Vec2 beta = Vec2(input["v"][0], input["v"][1]) / c;
  const bool alongX = wall == "right" || wall == "left";
  constexpr double kFar_m = 100.0;
  const Vec2 size = alongX ? Vec2(table.x, kFar_m) : Vec2(kFar_m, table.y);
  const Vec2 origin = alongX ? Vec2(-0.5 * table.x, -r.y) : Vec2(-r.x, -0.5 * table.y);
  const Vec2 place = r + origin;
  const std::string text =
      "light_speed_m_s = " + exact(c) + "\n[board]\nlength_m = " + exact(size.x) +
      "\nwidth_m = " + exact(size.y) + "\n[physics]\ncushion_restitution = " + exact(restitution) + "\n" +
      puckText("puck", input["R"], 1.0, vectorText(place.x, place.y), vectorText(beta.x, beta.y));
  const std::string cushion = wall == "right" ? "+x" : wall == "left" ? "-x" : wall == "top" ? "+y" : "-y";
  return {text, cushion, origin};
}

TEST(Simulate, CushionsThrowBackAsExactCasesSay) {
  const json cases = exactCases("puck_cushion.json");
  const TemporaryFolder folder;
  for (const json& testCase : cases) {
    const json& input = testCase["input"];
    const double tolerance = testCase["tol_abs"], c = input["c"];
    for (const auto& [wall, expected] : testCase["expected"]["walls"].items()) {
      for (const json& after : expected["v_after"]) {
        SCOPED_TRACE(testCase["id"].get<std::string>() + " " + wall + " restitution " + after["e"].dump());
        const CushionSetup setup = beforeCushion(input, wall, after["e"]);
        const json& centre = expected["puck"]["centre_delayed"];
        const json found = simulate(folder, setup.scenario, centre["t"].get<double>() + 1e-9);
        ASSERT_EQ(found["collisions"].size(), 1u);
        const json& collision = found["collisions"][0];
        EXPECT_EQ(collision["kind"], "puck-cushion");
        EXPECT_EQ(collision["cushion"], setup.cushion);
        const json& contact = expected["puck"]["contact"];
        EXPECT_NEAR(collision["contact"]["t_s"].get<double>(), contact["t"].get<double>(), tolerance);
        expectNear(collision["contact"]["r_m"], contact["r"][0].get<double>() + setup.origin.x,
                   contact["r"][1].get<double>() + setup.origin.y, tolerance);
        const json turn = turnOf(collision, "puck");
        // The cushion takes momentum and no energy: with E = γ m c² kept, m' = m γ/γ'.
        const auto gamma = [](const json& beta) {
          return 1.0 /
                 std::sqrt(1.0 - std::pow(beta[0].get<double>(), 2) - std::pow(beta[1].get<double>(), 2));
        };
        constexpr double kMass_kg = 1.0, kHeatRounding_j = 1e-11;
        EXPECT_NEAR(collision["heat_j"].get<double>(),
                    (gamma(turn["beta_before"]) / gamma(turn["beta_after"]) - 1.0) * kMass_kg * c * c,
                    kHeatRounding_j);
        EXPECT_NEAR(turn["t_s"].get<double>(), centre["t"].get<double>(), tolerance);
        expectNear(turn["r_m"], centre["r"][0].get<double>() + setup.origin.x,
                   centre["r"][1].get<double>() + setup.origin.y, tolerance);
        EXPECT_NEAR(turn["proper_time_s"].get<double>(), centre["tau"].get<double>(), tolerance);
        expectNear(turn["beta_after"], after["impulse"]["v"][0].get<double>() / c,
                   after["impulse"]["v"][1].get<double>() / c, tolerance);
      }
    }
  }
}

TEST(Simulate, GivesTheBitsOfTheEngine) {
  const TemporaryFolder folder;
  const auto result =
      runCarom(folder, {"simulate", kThreePucks, "--until", "10", "--every", "0.5", "--json", "-"});
  ASSERT_EQ(result.status, 0) << result.err;
  const json found = json::parse(result.out);
  const Scenario scenario = readScenario(kThreePucks);
  Billiard billiard(scenario.billiard);
  billiard.advanceTo(10.0);

  EXPECT_EQ(found["light_speed_m_s"].get<double>(), 1.42);
  ASSERT_FALSE(found["collisions"].empty());
  ASSERT_LE(found["collisions"].size(), billiard.events().size());
  for (std::size_t i = found["collisions"].size(); i < billiard.events().size(); ++i) {
    EXPECT_GT(billiard.events()[i].at.t_s, 10.0) << "the engine may look a little further ahead";
  }
  for (std::size_t i = 0; i < found["collisions"].size(); ++i) {
    const GameEvent& collision = billiard.events()[i];
    EXPECT_EQ(found["collisions"][i]["contact"]["t_s"].get<double>(), collision.at.t_s);
    EXPECT_EQ(found["collisions"][i]["turns"].size(), collision.turns.size());
    for (const Turn& turn : collision.turns) {
      const json told = turnOf(found["collisions"][i], scenario.billiard.pucks[turn.puck].name);
      EXPECT_EQ(told["beta_after"][0].get<double>(), turn.betaAfter.x);
      EXPECT_EQ(told["t_s"].get<double>(), turn.event.t_s);
    }
  }
  ASSERT_EQ(found["states"].size(), 21u);
  for (int i = 0; i <= 20; ++i) {
    const json& state = found["states"][i];
    EXPECT_EQ(state["t_s"].get<double>(), 0.5 * i);
    for (std::size_t puck = 0; puck < 3; ++puck) {
      const Motion motion = billiard.worldLines()[puck].at(0.5 * i);
      EXPECT_EQ(state["r_m"][puck][0].get<double>(), motion.event.r_m.x);
      EXPECT_EQ(state["r_m"][puck][1].get<double>(), motion.event.r_m.y);
      EXPECT_EQ(state["beta"][puck][0].get<double>(), betaFromU(motion.u).x);
    }
  }
  for (std::size_t puck = 0; puck < 3; ++puck) {
    EXPECT_EQ(found["pucks"][puck]["name"], scenario.billiard.pucks[puck].name);
    EXPECT_EQ(found["pucks"][puck]["r_m"], found["states"][20]["r_m"][puck]);
    EXPECT_EQ(found["pucks"][puck]["t_s"].get<double>(), 10.0);
    EXPECT_EQ(found["pucks"][puck]["proper_time_s"].get<double>(),
              billiard.worldLines()[puck].at(10.0).properTime_s);
  }
}

TEST(Simulate, StatesStandAtWholeSteps) {
  const TemporaryFolder folder;
  const std::string scenario = "light_speed_m_s = 2\n" + puckText("a", 1.0, 1.0, "[1, 0]", "[0.5, 0]");
  const json found = simulate(folder, scenario, 0.7, {"--every", "0.1"});
  ASSERT_EQ(found["states"].size(), 8u);
  EXPECT_LE(found["states"][7]["t_s"].get<double>(), 0.7);
  EXPECT_EQ(simulate(folder, scenario, 0.0, {"--every", "0.1"})["states"].size(), 1u);
  EXPECT_FALSE(simulate(folder, scenario, 1.0).contains("states"));
  EXPECT_EQ(simulate(folder, scenario, 1.0)["pucks"][0]["r_m"][0].get<double>(), 2.0);
}

TEST(Simulate, WritesAFileAsWellAsATable) {
  const TemporaryFolder folder;
  const auto written =
      runCarom(folder, {"simulate", kThreePucks, "--until", "5", "--json", folder / "game.json"});
  EXPECT_EQ(written.status, 0);
  EXPECT_EQ(written.out, "");
  EXPECT_TRUE(json::accept(test::contentOf(folder / "game.json")));
  EXPECT_EQ(folder.entries(), 1);
  const auto table = runCarom(folder, {"simulate", kThreePucks, "--until", "5"});
  EXPECT_EQ(table.status, 0);
  EXPECT_NE(table.out.find("collisions up to t = 5 s"), std::string::npos) << table.out;
}

/// A puck at `beta` strikes an equal one at rest, off its centre by `offset` radii; c = 1 m/s, radius 1 m.
json scattered(const TemporaryFolder& folder, double beta, double offset, bool contact) {
  const std::string rules = contact ? "[physics]\ncollision_event = \"contact\"\n" : "";
  const json found =
      simulate(folder,
               "light_speed_m_s = 1.0\n" + rules +
                   puckText("moving", 1.0, 1.0, vectorText(-5.0, offset), vectorText(beta, 0.0)) +
                   puckText("resting", 1.0, 1.0, "[0.0, 0.0]", "[0.0, 0.0]"),
               20.0 / beta);
  EXPECT_EQ(found["collisions"].size(), 1u);
  return found;
}

double angleOf(const json& beta) { return std::atan2(beta[1].get<double>(), beta[0].get<double>()); }

TEST(Simulate, ScattersAsKnown) {
  const json cases = exactCases("known_results.json");
  const TemporaryFolder folder;
  int count = 0;
  for (const json& testCase : cases) {
    if (testCase["kind"] != "scatter") continue;
    SCOPED_TRACE(testCase["id"].get<std::string>());
    const json& expected = testCase["expected"];
    const double tolerance = testCase["tol"];
    const json found =
        scattered(folder, testCase["input"]["beta"], testCase["input"]["b_over_R"].get<double>(), false);
    const json first = turnOf(found["collisions"][0], "moving")["beta_after"];
    const json second = turnOf(found["collisions"][0], "resting")["beta_after"];
    expectNear(first, expected["v1_after"][0], expected["v1_after"][1], tolerance);
    expectNear(second, expected["v2_after"][0], expected["v2_after"][1], tolerance);
    EXPECT_NEAR(std::abs(angleOf(first)), expected["theta1"].get<double>(), tolerance);
    EXPECT_NEAR(std::abs(angleOf(second)), expected["theta2"].get<double>(), tolerance);
    ++count;
  }
  EXPECT_GT(count, 0);
}

// tan θ1 tan θ2 = 2/(γ+1) for a target at rest, in both conventions. Rounding of β near 1 enters γ by γ²
// ulps.
TEST(Simulate, AnglesAfterACollision) {
  const TemporaryFolder folder;
  for (const double gamma : {1.25, 2.0, 7.0, 70.0}) {
    for (const bool contact : {false, true}) {
      SCOPED_TRACE(testing::Message() << "gamma " << gamma << (contact ? " contact" : " centre"));
      const json found = scattered(folder, std::sqrt(1.0 - 1.0 / (gamma * gamma)), 0.7, contact);
      const json& collision = found["collisions"][0];
      const double first = angleOf(turnOf(collision, "moving")["beta_after"]),
                   second = angleOf(turnOf(collision, "resting")["beta_after"]);
      EXPECT_NEAR(-std::tan(first) * std::tan(second), 2.0 / (gamma + 1.0), 1e-14 * gamma * gamma);
    }
  }
}

// A cushion that returns nothing stops a fast puck where a slow one would long have been in contact: struck,
// that one is kicked without delay, and says so.
TEST(Simulate, SaysWhichKicksDidNotWait) {
  const TemporaryFolder folder;
  for (const std::string convention : {"centre", "contact"}) {
    SCOPED_TRACE(convention);
    const json found =
        simulate(folder,
                 "light_speed_m_s = 1.0\n[board]\nlength_m = 2.0\nwidth_m = 2.0\n[physics]\n"
                 "cushion_restitution = 0.0\ncollision_event = \"" +
                     convention + "\"\n" + puckText("one", 0.125, 1.0, "[0.0, 0.0]", "[0.6, 0.0]") +
                     "[[stroke]]\nat_s = 3.0\npuck = \"one\"\nmomentum_kg_m_s = [0.1, 0.0]\n",
                 5.0);
    ASSERT_EQ(found["collisions"].size(), 2u);
    EXPECT_FALSE(found["collisions"][0].contains("without_delay"));
    EXPECT_EQ(found["collisions"][1]["without_delay"], json(true));
    EXPECT_EQ(found["collisions"][1]["turns"][0]["t_s"], json(3.0));
  }
}

// What cannot be played is named, with its place in the file, and nothing is written.
TEST(Simulate, RefusesWhatCannotBePlayed) {
  struct Fault {
    std::string scenario, says;
  };
  const std::string head = "light_speed_m_s = 1.0\n[board]\nlength_m = 2.0\nwidth_m = 1.0\n";
  const auto one = [&](const std::string& radius, const std::string& mass, const std::string& place,
                       const std::string& beta) {
    return head + "[[puck]]\nname = \"odd\"\nradius_m = " + radius + "\nheight_m = 0.02\nmass_kg = " + mass +
           "\nposition_m = " + place + "\nbeta = " + beta + "\n";
  };
  const std::string still = "[0.0, 0.0]";
  const std::vector<Fault> faults{
      {head + puckText("a", 0.05, 1.0, still, still) + puckText("b", 0.05, 1.0, "[0.09, 0.0]", still),
       "overlap"},
      {one("0.05", "1.0", "[0.97, 0.0]", still), "cushion"},
      {one("0.05", "1.0", "[0.0, 3.0]", still), "cushion"},
      {one("0.05", "1.0", still, "[1.0, 0.0]"), "beta"},
      {one("0.05", "1.0", still, "[0.8, 0.8]"), "beta"},
      {one("0.05", "0.0", still, still), "mass_kg"},
      {one("0.05", "-1.0", still, still), "mass_kg"},
      {one("0.0", "1.0", still, still), "radius_m"},
      {one("-0.05", "1.0", still, still), "radius_m"},
      {one("nan", "1.0", still, still), "radius_m"},
      {one("0.05", "inf", still, still), "mass_kg"},
      {one("0.05", "1.0", "[nan, 0.0]", still), "position_m"},
      {one("0.05", "1.0", still, "[0.0, nan]"), "beta"}};
  const TemporaryFolder folder;
  for (const Fault& fault : faults) {
    SCOPED_TRACE(fault.scenario);
    const std::string file = folder.file("odd.toml", fault.scenario);
    const auto result = runCarom(folder, {"simulate", file, "--until", "1", "--json", folder / "out.json"});
    EXPECT_EQ(result.status, 1);
    const std::string place = "error: " + file + ":";
    EXPECT_EQ(result.err.substr(0, place.size()), place) << result.err;
    int line = 0, column = 0;
    EXPECT_EQ(std::sscanf(result.err.c_str() + place.size(), "%d:%d:", &line, &column), 2) << result.err;
    EXPECT_GT(line, 5);
    EXPECT_NE(result.err.find(fault.says), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "out.json"));
  }
}

/// All centres stay on the table of 2 m by 1 m (1e-12 m: rounding), at every state.
void expectOnTable(const json& found, std::size_t pucks) {
  ASSERT_EQ(found["pucks"].size(), pucks);
  for (const json& state : found["states"]) {
    ASSERT_EQ(state["r_m"].size(), pucks);
    for (const json& r : state["r_m"]) {
      EXPECT_TRUE(std::abs(r[0].get<double>()) <= 1.0 + 1e-12 && std::abs(r[1].get<double>()) <= 0.5 + 1e-12)
          << state;
    }
  }
}

// Two pucks driven into a corner; a puck between two others; one at β = (0.6, 0.6) into a corner, so that it
// meets the second cushion within the news of the first. In both conventions, elastic and not: it ends,
// nobody is lost, nobody leaves, and the pucks listed in another order do the same to the last bit.
TEST(Simulate, LabelsComeOutOfCorners) {
  const auto scenario = [](bool contact, double restitution, std::vector<std::string> pucks) {
    std::string text = "light_speed_m_s = 1.0\n[board]\nlength_m = 2.0\nwidth_m = 1.0\n[physics]\n";
    if (contact) text += "collision_event = \"contact\"\n";
    text +=
        "puck_restitution = " + exact(restitution) + "\ncushion_restitution = " + exact(restitution) + "\n";
    for (const std::string& puck : pucks) text += puck;
    return text;
  };
  const std::vector<std::vector<std::string>> crowds{{puckText("a", 0.05, 1.0, "[0.8, 0.3]", "[0.6, 0.6]")},
                                                     {puckText("a", 0.05, 1.0, "[0.8, 0.3]", "[0.6, 0.6]"),
                                                      puckText("b", 0.05, 1.0, "[0.6, 0.1]", "[0.65, 0.65]")},
                                                     {puckText("a", 0.05, 1.0, "[-0.5, 0.0]", "[0.8, 0.0]"),
                                                      puckText("b", 0.05, 0.1, "[0.0, 0.0]", "[0.0, 0.0]"),
                                                      puckText("c", 0.05, 1.0, "[0.5, 0.0]", "[-0.8, 0.0]")}};
  const TemporaryFolder folder;
  for (std::vector<std::string> pucks : crowds) {
    for (const bool contact : {false, true}) {
      for (const double restitution : {1.0, 0.5, 0.0}) {
        SCOPED_TRACE(scenario(contact, restitution, pucks));
        const json found = simulate(folder, scenario(contact, restitution, pucks), 5.0, {"--every", "0.05"});
        expectOnTable(found, pucks.size());
        std::vector<std::string> turned(pucks.rbegin(), pucks.rend());
        json other = simulate(folder, scenario(contact, restitution, turned), 5.0, {"--every", "0.05"});
        std::reverse(other["pucks"].begin(), other["pucks"].end());
        EXPECT_EQ(found["pucks"], other["pucks"]);
        EXPECT_EQ(found["collisions"].size(), other["collisions"].size());
      }
    }
  }
}

// A row of ten that touch, run into by one, nothing elastic: it ends, and the pucks of one jam are one
// collision.
TEST(Simulate, AJamIsOneCollisionOfAllItsPucks) {
  const TemporaryFolder folder;
  constexpr double kRadius_m = 0.0305;
  std::string text = "light_speed_m_s = 1.42\n[physics]\npuck_restitution = 0.0\n";
  for (int i = 0; i < 10; ++i) {
    text += puckText("p" + std::to_string(i), kRadius_m, 0.2, "[" + exact(2.002 * kRadius_m * i) + ", 0.0]",
                     "[0.0, 0.0]");
  }
  text += puckText("z", kRadius_m, 0.2, "[-0.6, 0.003]", "[0.7, 0.0]");
  const json found = simulate(folder, text, 4.0);
  std::size_t jams = 0;
  for (const json& collision : found["collisions"]) {
    EXPECT_GE(collision["heat_j"].get<double>(), 0.0);
    ASSERT_EQ(collision["pucks"].size(), collision["turns"].size());
    if (collision["kind"] != "jam") continue;
    ++jams;
    EXPECT_EQ(collision["without_delay"], true);
    EXPECT_GE(collision["pucks"].size(), 2u);
    for (std::size_t i = 1; i < collision["pucks"].size(); ++i) {
      EXPECT_LT(collision["pucks"][i - 1], collision["pucks"][i]) << "in the order of the file";
    }
  }
  EXPECT_GT(jams, 0u);
  EXPECT_LT(found["collisions"].size(), 10000u);
}

// What would fill the memory ends with a reason; what a person waits for says how far it is.
TEST(Simulate, EndsWhereItWouldKeepTooMuch) {
  const TemporaryFolder folder;
  const auto result =
      runCarom(folder, {"simulate", kThreePucks, "--until", "1e9", "--json", folder / "game.json"});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("collisions, by board time"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("expected an earlier --until"), std::string::npos) << result.err;
  EXPECT_EQ(folder.entries(), 0);
}

// What friction leaves, in closed form: from u0 = γβ, a glide of c² (γ0 − 1)/a in c u0/a, then rest.
TEST(Simulate, FrictionStopsAPuck) {
  const TemporaryFolder folder;
  const double c = 1.42, a = 0.3, beta = 0.8, u0 = beta / std::sqrt(1.0 - beta * beta),
               gamma0 = std::sqrt(1.0 + u0 * u0);
  const json found = simulate(folder,
                              "light_speed_m_s = 1.42\n[physics]\nfriction_m_s2 = 0.3\n" +
                                  puckText("one", 0.05, 1.0, "[-1.0, 0.0]", vectorText(beta, 0.0)),
                              10.0, {"--every", "1.0"});
  const double stop_s = c * u0 / a;
  for (const json& state : found["states"]) {
    const double t_s = std::min(state["t_s"].get<double>(), stop_s), u = u0 - a * t_s / c;
    const double gamma = std::sqrt(1.0 + u * u);
    EXPECT_NEAR(state["r_m"][0][0].get<double>(), -1.0 + c * c / a * (gamma0 - gamma), 1e-13);
    EXPECT_NEAR(state["beta"][0][0].get<double>(), u / gamma, 1e-14);
  }
  const double rest_s = 10.0 - stop_s;
  EXPECT_NEAR(found["pucks"][0]["proper_time_s"].get<double>(), c / a * std::asinh(u0) + rest_s, 1e-13);
}

}  // namespace
}  // namespace carom
