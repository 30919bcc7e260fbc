// `carom observe` against exact emission events, computed elsewhere to 30 digits.

#include "app/tools/observe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/program.h"
#include "exact_cases.h"
#include "places.h"

namespace carom {
namespace {

using nlohmann::json;
using test::answerOf;
using test::exact;
using test::exactCases;
using test::runCarom;
using test::TemporaryFolder;

std::string vectorText(const json& v, double scale) {
  std::string text = "[";
  for (int i = 0; i < 3; ++i) text += (i ? ", " : "") + exact(v[i].get<double>() * scale);
  return text + "]";
}

/// A case's world line as a scripted body. Its first piece may begin: that is when the body appears.
std::string scenarioOf(const json& input) {
  const double c = input["c"];
  const json& pieces = input["worldline"]["pieces"];
  const json& anchor = input["worldline"]["anchor"];
  std::string text = "light_speed_m_s = " + exact(c) +
                     "\n[[body]]\nname = \"it\"\nat = { t_s = " + exact(anchor["t"]) +
                     ", r_m = " + vectorText(anchor["r"], 1.0) + " }\n";
  if (!pieces[0]["t"].is_null()) text += "appears_s = " + exact(pieces[0]["t"]) + "\n";
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    text += "[[body.leg]]\n";
    if (i > 0) text += "from_s = " + exact(pieces[i]["t"]) + "\n";
    const json& v = pieces[i]["v"];
    text += "beta = [" + exact(v[0].get<double>() / c) + ", " + exact(v[1].get<double>() / c) + ", " +
            exact(v[2].get<double>() / c) + "]\n";
  }
  return text;
}

/// What the centre's clock shows at the anchor, counted as the program counts: from the body's appearance,
/// else from board time 0.
double clockAtAnchor_s(const json& input) {
  const json& pieces = input["worldline"]["pieces"];
  const double anchor_s = input["worldline"]["anchor"]["t"], c = input["c"];
  const double zero_s = pieces[0]["t"].is_null() ? 0.0 : pieces[0]["t"].get<double>();
  double clock_s = 0.0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const double from_s = i == 0 ? -1e300 : pieces[i]["t"].get<double>();
    const double to_s = i + 1 < pieces.size() ? pieces[i + 1]["t"].get<double>() : 1e300;
    const double low_s = std::clamp(std::min(zero_s, anchor_s), from_s, to_s);
    const double high_s = std::clamp(std::max(zero_s, anchor_s), from_s, to_s);
    double beta2 = 0.0;
    for (const json& component : pieces[i]["v"])
      beta2 += component.get<double>() * component.get<double>() / (c * c);
    clock_s += (high_s - low_s) * std::sqrt(1.0 - beta2);
  }
  return anchor_s < zero_s ? -clock_s : clock_s;
}

/// Points off the centre of a body that turns follow the news of the turn; the cases let them jump.
bool isTold(const json& testCase) {
  const json& xi = testCase["input"]["xi"];
  const bool centre = xi == json::array({0.0, 0.0, 0.0});
  return centre || testCase["input"]["worldline"]["pieces"].size() == 1;
}

void checkSeen(const json& testCase, const json& point) {
  const json& expected = testCase["expected"]["roots"][0];
  const json& tolerance = testCase["tol"];
  const double c = testCase["input"]["c"];
  const auto vectorNear = [&](const json& found, const json& wanted, double scale, double within) {
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(found[i].get<double>(), wanted[i].get<double>() * scale, within) << found;
  };
  EXPECT_NEAR(point["emission"]["t_s"].get<double>(), expected["t_e"].get<double>(),
              tolerance["t_e"].get<double>());
  vectorNear(point["emission"]["r_m"], expected["r_e"], 1.0, tolerance["r_e"]);
  vectorNear(point["seen_m"], expected["apparent_position_observer"], 1.0,
             tolerance["apparent_position_observer"]);
  vectorNear(point["seen_m"], expected["look_observer"], point["distance_m"].get<double>(),
             tolerance["look_observer"].get<double>() * std::max(1.0, point["distance_m"].get<double>()));
  EXPECT_NEAR(point["distance_m"].get<double>(), expected["distance_observer"].get<double>(),
              tolerance["distance_observer"].get<double>());
  EXPECT_NEAR(point["doppler"].get<double>(), expected["doppler"].get<double>(),
              tolerance["doppler"].get<double>());
  EXPECT_NEAR(point["proper_time_s"].get<double>() - clockAtAnchor_s(testCase["input"]),
              expected["proper_time_since_anchor"].get<double>(),
              tolerance["proper_time_since_anchor"].get<double>());
  constexpr double kVelocityRounding = 1e-12;
  vectorNear(point["beta_at_emission"], expected["velocity_at_emission"], 1.0 / c, kVelocityRounding);
}

TEST(Observe, SeesWhatExactCasesSay) {
  const json cases = exactCases("emission.json");
  const TemporaryFolder folder;
  int seen = 0, unseen = 0;
  for (const json& testCase : cases) {
    if (!isTold(testCase)) continue;
    SCOPED_TRACE(testCase["id"].get<std::string>() + " " + testCase["input"]["group"].get<std::string>());
    const json& input = testCase["input"];
    const double c = input["c"];
    const auto number = [](const json& value, double scale = 1.0) {
      return exact(value.get<double>() / scale);
    };
    const json &r = input["observer"]["r"], &v = input["observer"]["v"], &xi = input["xi"];
    const json found = answerOf(folder, "observe", scenarioOf(input),
                                {"--event", number(input["observer"]["t"]), number(r[0]), number(r[1]),
                                 number(r[2]), "--beta", number(v[0], c), number(v[1], c), number(v[2], c),
                                 "--point", "it", number(xi[0]), number(xi[1]), number(xi[2])});
    ASSERT_EQ(found["points"].size(), 1u);
    const json& point = found["points"][0];
    EXPECT_EQ(point["name"], "it");
    EXPECT_EQ(point["offset_m"], xi);
    if (testCase["expected"]["status"] == "not_yet_visible") {
      ++unseen;
      EXPECT_EQ(point["status"], "unseen");
      EXPECT_EQ(point.size(), 3u) << "nothing else is known of it: " << point;
    } else {
      ++seen;
      ASSERT_EQ(point["status"], "seen");
      checkSeen(testCase, point);
    }
  }
  EXPECT_GT(seen, 10);
}

/// A case of a spinning disc as a scripted body.
std::string spinningScenarioOf(const json& input) {
  const double c = input["c"];
  const json& centre = input["centre"];
  return "light_speed_m_s = " + exact(c) + "\n[[body]]\nname = \"it\"\nat = { t_s = " + exact(centre["t"]) +
         ", r_m = " + vectorText(centre["r"], 1.0) + " }\nspin_rad_s = " + exact(input["omega"]) +
         "\n[[body.leg]]\nbeta = " + vectorText(centre["v"], 1.0 / c) + "\n";
}

// The event of emission, the place, the velocity and the Doppler factor are the point's own.
TEST(Observe, SeesPointsOfSpinningBodiesWhereExactCasesSay) {
  const json cases = exactCases("spin_emission.json");
  const TemporaryFolder folder;
  for (const json& testCase : cases) {
    SCOPED_TRACE(testCase["id"].get<std::string>());
    const json &input = testCase["input"], &expected = testCase["expected"], &tolerance = testCase["tol"];
    const json &eye = input["observer"], &xi = input["xi"];
    const double c = input["c"];
    std::vector<std::string> arguments{"--event", exact(eye["t"])};
    for (const json& r : eye["r"]) arguments.push_back(exact(r));
    arguments.push_back("--beta");
    for (const json& v : eye["v"]) arguments.push_back(exact(v.get<double>() / c));
    arguments.insert(arguments.end(), {"--point", "it", exact(xi[0]), exact(xi[1]), exact(xi[2])});
    const json point = answerOf(folder, "observe", spinningScenarioOf(input), arguments)["points"][0];
    ASSERT_EQ(point["status"], "seen");
    const auto near = [&](const json& found, const char* key, double scale = 1.0) {
      EXPECT_NEAR(found.get<double>(), expected[key].get<double>() * scale, tolerance[key].get<double>())
          << key;
    };
    const auto vectorNear = [&](const json& found, const char* key, double scale = 1.0) {
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(found[i].get<double>(), expected[key][i].get<double>() * scale, tolerance[key]) << key;
    };
    near(point["emission"]["t_s"], "t_e");
    vectorNear(point["emission"]["r_m"], "r_e");
    vectorNear(point["seen_m"], "apparent_position_observer");
    near(point["distance_m"], "distance_observer");
    near(point["doppler"], "doppler");
    vectorNear(point["beta_at_emission"], "velocity_at_emission", 1.0 / c);
  }
}

// The angle is 0 at the event `at`, on whichever leg that is, and goes on by the centre's own clock: on the
// second leg, at 0.6 c, it runs slow by 0.8.
TEST(Observe, TurnsABodyByItsOwnClock) {
  const TemporaryFolder folder;
  const std::string scenario =
      "light_speed_m_s = 10\n[[body]]\nname = \"disc\"\nat = { t_s = -2, r_m = [0, 0, 0] }\nspin_rad_s = "
      "0.5\n"
      "[[body.leg]]\nbeta = [0, 0, 0]\n[[body.leg]]\nfrom_s = 1\nbeta = [0, 0, 0.6]\n";
  const auto placeAt = [&](double t_s, double z_m) {
    const double way_s = 5.0 / 10.0;  // from the eye, 5 m above
    const json found = answerOf(
        folder, "observe", scenario,
        {"--event", exact(t_s + way_s), "0", "0", exact(z_m + 5.0), "--point", "disc", "1e-6", "0", "0"});
    return found["points"][0]["emission"]["r_m"];
  };
  const double early_rad = 0.5 * (0.5 + 2.0), late_rad = 0.5 * (3.0 + 0.8 * 4.0);
  EXPECT_NEAR(placeAt(0.5, 0.0)[1].get<double>(), 1e-6 * std::sin(early_rad), 1e-12);
  EXPECT_NEAR(placeAt(5.0, 24.0)[1].get<double>(), 1e-6 * std::sin(late_rad), 1e-12);
}

TEST(Observe, RefusesAPointThatWouldGoRoundAtTheSpeedOfLight) {
  const TemporaryFolder folder;
  const std::string file =
      folder.file("scenario.toml",
                  "light_speed_m_s = 2\n[[body]]\nname = \"disc\"\nat = { t_s = 0, r_m = "
                  "[0, 0, 0] }\nspin_rad_s = 4\n[[body.leg]]\nbeta = [0, 0, 0]\n");
  const auto result =
      runCarom(folder, {"observe", file, "--event", "1", "0", "0", "1", "--point", "disc", "0", "0.6", "0"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("this point would move at 1.2 c, expected one less than 0.5 m from its axis"),
            std::string::npos)
      << result.err;
}

TEST(Observe, SeesEveryCentreUnlessTold) {
  const TemporaryFolder folder;
  const std::string scenario =
      "light_speed_m_s = 1\n[[puck]]\nname = \"puck\"\nradius_m = 0.1\nheight_m = 0.5\nmass_kg = "
      "1\nposition_m = [-1.5, 3]\n"
      "beta = [0.5, 0]\n[[body]]\nname = \"late\"\nat = { t_s = 0, r_m = [0, 0, 5] }\nappears_s = "
      "2\n[[body.leg]]\n"
      "beta = [0, 0, 0]\n";
  const json found = answerOf(folder, "observe", scenario, {"--event", "6", "0", "0", "0.25"});
  ASSERT_EQ(found["points"].size(), 2u);
  const json& puck = found["points"][0];
  EXPECT_EQ(puck["name"], "puck");
  constexpr double kRounding = 1e-14;
  EXPECT_NEAR(puck["emission"]["t_s"].get<double>(), 3.0, kRounding);
  EXPECT_NEAR(puck["emission"]["r_m"][1].get<double>(), 3.0, kRounding);
  EXPECT_NEAR(puck["emission"]["r_m"][2].get<double>(), 0.25, kRounding) << "half the puck's height";
  EXPECT_NEAR(puck["distance_m"].get<double>(), 3.0, kRounding);
  EXPECT_NEAR(puck["doppler"].get<double>(), std::sqrt(0.75), kRounding);
  EXPECT_NEAR(puck["proper_time_s"].get<double>(), 3.0 * std::sqrt(0.75), kRounding);
  EXPECT_EQ(found["points"][1]["status"], "unseen") << "its first light needs until 6.75 s";
  EXPECT_EQ(answerOf(folder, "observe", scenario, {"--event", "7", "0", "0", "0.25"})["points"][1]["status"],
            "seen");
}

// The light of a puck that has bounced reaches the eye from its new leg; while the news of the bounce
// travels, from the old one.
TEST(Observe, FollowsTheGame) {
  const TemporaryFolder folder;
  const std::string scenario =
      "light_speed_m_s = 1\n[board]\nlength_m = 2\nwidth_m = 2\n[[puck]]\nname = \"puck\"\nradius_m = "
      "0.1\nmass_kg = 1\n"
      "position_m = [0, 0]\nbeta = [0.6, 0]\n";
  const auto result =
      runCarom(folder, {"simulate", folder.file("s.toml", scenario), "--until", "4", "--json", "-"});
  ASSERT_EQ(result.status, 0) << result.err;
  const json turn = json::parse(result.out)["collisions"][0]["turns"][0];
  const double turn_s = turn["t_s"], x_m = turn["r_m"][0];
  const double away_m = 10.0, z_m = 0.01;  // the eye lies on the track, at the height of the puck's centre
  for (const double after_s : {-0.25, 0.25}) {
    const json found =
        answerOf(folder, "observe", scenario,
                 {"--event", exact(turn_s + after_s + away_m - x_m - (after_s < 0 ? 0.6 : -0.6) * after_s),
                  exact(away_m), "0", exact(z_m)});
    const json& point = found["points"][0];
    constexpr double kRounding = 1e-12;
    EXPECT_NEAR(point["emission"]["t_s"].get<double>(), turn_s + after_s, kRounding);
    EXPECT_NEAR(point["beta_at_emission"][0].get<double>(), after_s < 0 ? 0.6 : -0.6, kRounding);
    EXPECT_NEAR(point["doppler"].get<double>(), after_s < 0 ? 2.0 : 0.5, kRounding);
  }
}

TEST(Observe, WithoutVtkRefusesTheSeenScene) {
  const TemporaryFolder folder;
  ObserveOptions options;
  options.scenario = CAROM_CONFIG_DIR "/scenarios/three-pucks.toml";
  options.vtp = folder / "seen.vtp";
  try {
    runObserve(options);
    ADD_FAILURE() << "it went on";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("without VTK"), std::string::npos) << error.what();
  }
  EXPECT_EQ(folder.entries(), 0);
}

TEST(Observe, WritesAFileAsWellAsATable) {
  const TemporaryFolder folder;
  const std::string scenario = CAROM_CONFIG_DIR "/scenarios/parallel-tracks.toml";
  const auto written =
      runCarom(folder, {"observe", scenario, "--event", "1", "0", "0", "1", "--json", folder / "seen.json"});
  EXPECT_EQ(written.status, 0) << written.err;
  EXPECT_EQ(json::parse(test::contentOf(folder / "seen.json"))["points"].size(), 5u);
  const auto table = runCarom(folder, {"observe", scenario, "--event", "1", "0", "0", "1"});
  EXPECT_EQ(table.status, 0);
  EXPECT_NE(table.out.find("fastest"), std::string::npos) << table.out;
}

}  // namespace
}  // namespace carom
