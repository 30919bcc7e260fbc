// `carom simulate` and `carom check` with soft pucks: closed forms of waves, references of bounces, and what
// is refused.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

#include "app/program.h"
#include "exact_cases.h"

namespace carom {
namespace {

using nlohmann::json;
using test::exact;
using test::exactCases;
using test::runCarom;
using test::TemporaryFolder;

/// Returns the answer of `carom simulate` to a scenario.
json simulated(const std::string& scenario, std::vector<std::string> arguments) {
  const TemporaryFolder folder;
  folder.file("scenario.toml", scenario);
  arguments.insert(arguments.begin(), {"simulate", (folder / "scenario.toml").string()});
  arguments.insert(arguments.end(), {"--json", "-"});
  const test::ProgramResult result = runCarom(folder, arguments);
  EXPECT_EQ(result.status, 0) << result.err;
  return json::parse(result.out);
}

bool isThorough() { return std::getenv("CAROM_SOFT") != nullptr; }

/// Whether a case is run: those of many cells take long, so all of them where the whole proof is asked for.
bool isRun(const json& one, const std::vector<std::string>& quick) {
  return isThorough() || std::find(quick.begin(), quick.end(), one["id"]) != quick.end();
}

/// Returns the time at which a point's speed along x has done half of its change from the first state to the
/// last; what it overshoots in between rings away.
double turnsAt_s(const json& states, std::size_t point) {
  const auto speed = [&](const json& state) { return state["points"][point]["beta"][0].get<double>(); };
  const double first = speed(states.front()), change = speed(states.back()) - first;
  for (std::size_t k = 1; k < states.size(); ++k) {
    const double before = (speed(states[k - 1]) - first) / change,
                 after = (speed(states[k]) - first) / change;
    if (after < 0.5) continue;
    const double share = (0.5 - before) / (after - before), t_s = states[k - 1]["t_s"];
    return t_s + share * (states[k]["t_s"].get<double>() - t_s);
  }
  return 0.0;
}

TEST(SimulateSoft, WavesAreThoseOfTheClosedForms) {
  for (const json& one : exactCases("soft_waves.json")) {
    if (!isRun(one, {"soft-push-04"})) continue;
    SCOPED_TRACE(one["id"].get<std::string>());
    const std::string scenario = one["files"]["scenario.toml"];
    const std::string name = one["kind"] == "cushion" ? "block" : one["kind"] == "push" ? "rod" : "string";
    double until_s = 0.0;
    std::vector<std::string> asked;
    std::vector<json> points = one["expected"]["points"];
    for (const json& point : points) until_s = std::max(until_s, point["t_s"].get<double>());
    for (const json& point : points)
      asked.insert(asked.end(), {"--point", name, exact(point["offset_m"][0]), exact(point["offset_m"][1])});
    std::map<double, json> answers;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double t_s = points[k]["t_s"];
      if (!answers.contains(t_s)) {
        std::vector<std::string> arguments{"--until", exact(t_s)};
        arguments.insert(arguments.end(), asked.begin(), asked.end());
        if (t_s == until_s && isThorough()) arguments.insert(arguments.end(), {"--every", "0.0002"});
        answers[t_s] = simulated(scenario, arguments);
      }
      const json& point = answers[t_s]["points"][k];
      EXPECT_NEAR(point["r_m"][0], points[k]["x_m"], points[k]["tol_x_m"]) << points[k];
      for (int i = 0; i < 2; ++i)
        EXPECT_NEAR(point["beta"][i], points[k]["beta"][i], points[k]["tol_beta"]) << points[k];
    }
    const json &end = answers[until_s], &expected = one["expected"];
    if (expected.contains("contact_t_s")) {
      EXPECT_NEAR(end["collisions"][0]["contact"]["t_s"], expected["contact_t_s"], expected["tol_t_s"]);
      EXPECT_EQ(end["collisions"][0]["kind"], "soft-cushion");
      if (isThorough()) {
        EXPECT_NEAR(turnsAt_s(end["states"], 0), expected["far_side_turns_t_s"], expected["tol_t_s"]);
      }
    }
    if (isThorough() && expected.contains("far_end_moves_t_s")) {
      EXPECT_NEAR(turnsAt_s(end["states"], 0), expected["far_end_moves_t_s"], expected["tol_t_s"]);
    }
  }
}

struct Momentum {
  double e = 0.0, x = 0.0, y = 0.0;
};

/// Returns the four-momentum of a puck over c, seen from a frame that moves with v along y.
Momentum momentumOf(const json& puck, double v) {
  const double bx = puck["beta"][0], by = puck["beta"][1];
  const double gamma = 1.0 / std::sqrt(1.0 - bx * bx - by * by), mass = puck["rest_mass_kg"];
  const double frame = 1.0 / std::sqrt(1.0 - v * v), e = mass * gamma, y = e * by;
  return {frame * (e - v * y), e * bx, frame * (y - v * e)};
}

TEST(SimulateSoft, BouncesAreThoseOfTheReferences) {
  for (const json& one : exactCases("soft_bounces.json")) {
    if (!isRun(one, {"soft-pair-41", "soft-stroke-48"})) continue;
    SCOPED_TRACE(one["id"].get<std::string>());
    const std::string scenario = one["files"]["scenario.toml"];
    const json end = simulated(scenario, {"--until", exact(one["until_s"])});
    const json start = simulated(scenario, {"--until", "0"});
    const json& expected = one["expected"];
    const json &puck = end["pucks"][0], &was = start["pucks"][0];
    const Momentum after = momentumOf(puck, 0.0), before = momentumOf(was, 0.0);
    if (expected.contains("normal_momentum_ratio")) {
      EXPECT_NEAR(after.x / before.x, expected["normal_momentum_ratio"], expected["tol_normal"]);
    }
    if (expected.contains("tol_mass")) {
      EXPECT_NEAR(puck["rest_mass_kg"].get<double>() / 0.2, expected["rest_mass_ratio"],
                  expected["tol_mass"]);
    }
    if (expected.contains("tol_tangential") && before.y != 0.0) {
      EXPECT_NEAR(after.y / before.y, expected["tangential_momentum_ratio"], expected["tol_tangential"]);
    }
    if (expected.contains("momentum_over_mc")) {
      EXPECT_NEAR(after.x / 0.2, expected["momentum_over_mc"], expected["tol_momentum"]);
      EXPECT_NEAR(puck["beta"][0], expected["beta"], expected["tol_beta"]);
    }
    if (expected.contains("cm_momentum_after_over_before")) {
      EXPECT_EQ(end["collisions"][0]["kind"], "soft-soft");
      const Momentum other = momentumOf(end["pucks"][1], 0.0), otherWas = momentumOf(start["pucks"][1], 0.0);
      EXPECT_NEAR(after.e + other.e, before.e + otherWas.e, 1e-12 * (before.e + otherWas.e));
      EXPECT_NEAR(after.x + other.x, before.x + otherWas.x, 1e-12 * (before.e + otherWas.e));
      EXPECT_NEAR(after.y + other.y, before.y + otherWas.y, 1e-12 * (before.e + otherWas.e));
    }
  }
}

constexpr const char* kBlock =
    "light_speed_m_s = 1.42\n[[puck]]\nname = \"block\"\noutline_m = [[-0.04, -0.02], [0.04, -0.02], "
    "[0.04, 0.02], [-0.04, 0.02]]\nmass_kg = 0.2\nposition_m = [0.0, 0.0]\nbeta = [0.1, 0.0]\n";
constexpr const char* kDisc =
    "light_speed_m_s = 1.42\n[[puck]]\nname = \"disc\"\nradius_m = 0.03\nmass_kg = 0.2\nposition_m = [0.0, "
    "0.0]\nbeta = [0.1, 0.0]\n";

TEST(SimulateSoft, TellsTheStateOfWhatIsSoft) {
  const std::string text =
      "light_speed_m_s = 1.42\n[board]\nlength_m = 0.4\nwidth_m = 0.4\n[[puck]]\nname = \"jelly\"\n"
      "radius_m = 0.03\nmass_kg = 0.2\nposition_m = [-0.1, 0.0]\nbeta = [0.5, 0.0]\n[puck.soft]\ncells = "
      "5\n[[puck]]\nname = \"ball\"\nradius_m = 0.03\nmass_kg = 0.2\nposition_m = [0.1, 0.01]\nbeta = "
      "[0.0, 0.0]\n";
  const json end = simulated(text, {"--until", "0.4", "--every", "0.1", "--point", "ball", "0.01", "0"});
  const json &jelly = end["pucks"][0], &ball = end["pucks"][1];
  for (const char* key :
       {"r_m", "beta", "rest_mass_kg", "heat_j", "elastic_j", "spin_kg_m2_s", "proper_time_s", "awake"})
    EXPECT_TRUE(jelly.contains(key)) << key;
  EXPECT_FALSE(jelly.contains("became_soft_s"));
  EXPECT_GT(ball["became_soft_s"], 0.05);
  EXPECT_GT(ball["rest_mass_kg"], 0.2);
  const json& first = end["collisions"][0];
  EXPECT_EQ(first["kind"], "soft-soft");
  EXPECT_EQ(first["pucks"], json({"jelly", "ball"}));
  EXPECT_LT(first["impulse_kg_m_s"][0], 0.0);
  EXPECT_GT(first["heat_j"], 0.0);
  EXPECT_TRUE(first["parted"].is_object());
  EXPECT_GT(first["parted"]["t_s"], first["contact"]["t_s"]);
  EXPECT_TRUE(first["turns"].empty());
  EXPECT_EQ(end["states"].size(), 5u);
  EXPECT_EQ(end["states"][0]["rest_mass_kg"][1], 0.2);
  EXPECT_EQ(end["states"][0]["points"][0]["r_m"][0], 0.11);
  EXPECT_EQ(end["points"][0]["puck"], "ball");
}

/// Returns the words about a scenario that is refused, or the warnings about one that is not.
std::string saidOf(const std::string& scenario, int status) {
  const TemporaryFolder folder;
  folder.file("scenario.toml", scenario);
  const test::ProgramResult result = runCarom(folder, {"check", (folder / "scenario.toml").string()});
  EXPECT_EQ(result.status, status) << scenario << result.out << result.err;
  return result.err;
}

TEST(SimulateSoft, BadInputIsNamedWithItsPlace) {
  const std::string disc = kDisc, block = kBlock;
  struct Case {
    std::string scenario, said;
  };
  const std::string ram =
      "[[body]]\nname = \"ram\"\nat = { t_s = 0.0, r_m = [0.0, 0.0, 0.01] }\n[[body.leg]]\nbeta = [0.2, "
      "0.0, 0.0]\n";
  const std::string rigid =
      "[[puck]]\nname = \"rigid\"\nmass_kg = 0.2\nposition_m = [0.5, 0.0]\nbeta = [0.0, 0.0]\n";
  for (const Case& one :
       {Case{disc + "[puck.soft]\nsound_speed = 0\n", "9:15: sound_speed is 0"},
        Case{disc + "[puck.soft]\nsound_speed = 0.8\n", "9:15: sound_speed is 0.8"},
        Case{disc + "[puck.soft]\ncells = 3\n", "9:9: cells is 3"},
        Case{disc + "[puck.soft]\ncells = 41\n", "9:9: cells is 41"},
        Case{disc + "[puck.soft]\nviscosity = 0\n", "9:13: viscosity is 0"},
        Case{disc + "inertia = 0.4\n[puck.soft]\n", "8:11: inertia stands beside soft"},
        Case{disc + "spin_rad_s = 1.0\n[puck.soft]\n", "8:14: spin_rad_s stands beside soft"},
        Case{disc + "spin_kg_m2_s = 0.001\n[puck.soft]\n", "8:16: spin_kg_m2_s stands beside soft"},
        Case{disc + "[puck.soft]\n[physics]\npuck_friction = 0.1\n",
             "10:17: puck_friction is 0.1, expected 0"},
        Case{disc + "[puck.soft]\n[physics]\nstiff_sound_speed = 0.8\n", "10:21: stiff_sound_speed is 0.8"},
        Case{disc + "[puck.soft]\nviscosity = 1.1\n", "9:13: viscosity is 1.1"},
        Case{disc + "[puck.soft]\n[physics]\nfriction_m_s2 = 0.1\n",
             "10:17: friction_m_s2 is 0.1, expected 0"},
        Case{disc + "[puck.soft]\n[physics]\ncushion_friction = 0.1\n",
             "10:20: cushion_friction is 0.1, expected 0"},
        Case{disc + "[puck.soft]\n[physics]\nstiff_sound_speed = 0.01\n", "10:21: stiff_sound_speed is 0.01"},
        Case{disc + "[puck.soft]\nheld = [{ side = \"-x\", by = \"ram\" }]\n" + ram,
             "is a disc and has no sides"},
        Case{block + "[puck.soft]\nheld = [{ side = \"-x\", by = \"nobody\" }]\n" + ram,
             "there is no body 'nobody'"},
        Case{block + "[puck.soft]\nheld = [{ side = \"-x\", by = \"ram\" }]\n" + ram,
             "body 'ram' moves with (0.2, 0, 0) c"},
        Case{block +
                 "[puck.soft]\nheld = [{ side = \"-x\", by = \"ram\" }, { side = \"-x\", by = \"ram\" "
                 "}]\n" +
                 "[[body]]\nname = \"ram\"\nat = { t_s = 0.0, r_m = [0.0, 0.0, 0.01] }\n[[body.leg]]\nbeta = "
                 "[0.1, 0.0, 0.0]\n",
             "side '-x' of puck 'block' is held twice"},
        Case{block + "[puck.soft]\nheld = [{ side = \"-x\" }]\n" + ram, "9:9: by is missing here"},
        Case{disc + "[puck.soft]\n" + rigid + "radius_m = 0.03\nspin_rad_s = 2.0\n",
             "puck 'rigid' spins beside soft"},
        Case{disc + "[puck.soft]\n" + rigid +
                 "outline_m = [[-0.04, -0.02], [0.04, -0.02], [0.04, 0.02], [-0.04, 0.02]]\n",
             "puck 'rigid' has corners and is rigid"},
        Case{"light_speed_m_s = 1.42\n[[puck]]\nname = \"p\"\noutline_m = [[-0.04, -0.02], [0.04, -0.02], "
             "[0.0, 0.04]]\nmass_kg "
             "= 0.2\nposition_m = [0.0, 0.0]\nbeta = [0.0, 0.0]\n[puck.soft]\n",
             "4:13: puck 'p' is soft and neither a disc nor a rectangle"}}) {
    EXPECT_NE(saidOf(one.scenario, 1).find(one.said), std::string::npos) << one.said << "\n"
                                                                         << saidOf(one.scenario, 1);
  }
}

TEST(SimulateSoft, WarnsOfWhatMayBeUncomputable) {
  const std::string slender =
      "light_speed_m_s = 1.42\n[[puck]]\nname = \"rod\"\noutline_m = [[-0.05, -0.01], [0.05, -0.01], [0.05, "
      "0.01], [-0.05, 0.01]]\nmass_kg = 0.2\nposition_m = [0.0, 0.0]\nbeta = [0.0, 0.0]\n[puck.soft]\n";
  EXPECT_NE(saidOf(slender, 0).find("puck 'rod' is 5 times as long as wide: it buckles"), std::string::npos);
  const std::string fast =
      "light_speed_m_s = 1.42\n[board]\nlength_m = 1\nwidth_m = 1\n[[puck]]\nname = \"fast\"\nradius_m = "
      "0.03\nmass_kg = "
      "0.2\nposition_m = [0.0, 0.0]\nbeta = [0.95, 0.0]\n[puck.soft]\n";
  EXPECT_NE(saidOf(fast, 0).find("puck 'fast' can close at 0.95 c"), std::string::npos);
  EXPECT_EQ(saidOf(std::string(kDisc) + "[puck.soft]\n", 0), "");
}

TEST(SimulateSoft, SaysWhatWasCrushedMoreThanCanBeComputed) {
  const TemporaryFolder folder;
  folder.file("fast.toml",
              "light_speed_m_s = 1.42\n[board]\nlength_m = 0.5\nwidth_m = 0.5\n[[puck]]\nname = \"fast\"\n"
              "radius_m = 0.03\nmass_kg = 0.2\nposition_m = [0.0, 0.0]\nbeta = [0.998, 0.0]\n[puck.soft]\n"
              "sound_speed = 0.7\ncells = 4\nviscosity = 0.05\n");
  const std::string file = (folder / "fast.toml").string();
  const test::ProgramResult result = runCarom(folder, {"simulate", file, "--until", "0.4", "--json", "-"});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.err.find(file + ": puck 'fast' was crushed more than can be computed at t = 0.1"),
            std::string::npos)
      << result.err;
}

TEST(SimulateSoft, APointBesideARectangleIsNamed) {
  const TemporaryFolder folder;
  folder.file("scenario.toml", std::string(kBlock) + "[puck.soft]\n");
  const std::string file = (folder / "scenario.toml").string();
  const auto run = [&](const std::string& y) {
    return runCarom(folder,
                    {"simulate", file, "--until", "0.01", "--point", "block", "-0.04", y, "--json", "-"});
  };
  EXPECT_EQ(run("0.02").status, 0);
  const test::ProgramResult beside = run("0.021");
  EXPECT_EQ(beside.status, 2);
  EXPECT_NE(beside.err.find("--point: (-0.04, 0.021) m is not in puck 'block'"), std::string::npos)
      << beside.err;
}

TEST(SimulateSoft, CheckSaysWhatASoftPuckCosts) {
  const TemporaryFolder folder;
  folder.file("scenario.toml", std::string(kDisc) + "[puck.soft]\n");
  const test::ProgramResult result = runCarom(folder, {"check", (folder / "scenario.toml").string()});
  EXPECT_NE(
      result.out.find(
          "puck disc is soft: sound at 0.5 c, viscosity 0.3, 331 nodes, 600 triangles; while it is awake"),
      std::string::npos)
      << result.out;
}

}  // namespace
}  // namespace carom
