// `carom force` on recorded hands: the exact cases, the energies of slow draws and of their strokes, limits,
// the same bits in every run, and its messages.

#include "app/tools/force.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <sstream>

#include "app/program.h"
#include "exact_cases.h"

namespace carom {
namespace {

using test::exact;
using test::ProgramResult;
using test::runCarom;
using test::TemporaryFolder;

std::string rigWith(const std::string& hand) {
  return "unit = \"m\"\naxes = \"x-right y-up z-back\"\n[head]\ntracker = \"person\"\n" + hand +
         "[[tracker]]\nname = \"person\"\nkind = \"simulated\"\n[[wall]]\nname = \"front\"\nlower_left = "
         "[-1, 0, "
         "-1]\nlower_right = [1, 0, -1]\nupper_left = [-1, 2, -1]\npixels = [64, 64]\n";
}

std::string scenarioWith(double mass_kg, double lightSpeed_m_s, const std::string& more = "") {
  return fmt::format(
      "title = \"t\"\nlight_speed_m_s = {:.17g}\n[observer]\nposition_m = [0.0, -1.7, 0.5]\n[[puck]]\nname = "
      "\"white\"\nradius_m = 0.03\nheight_m = 0.02\nmass_kg = {:.17g}\nposition_m = [0.0, 0.0]\nbeta = [0.0, "
      "0.0]\n{}",
      lightSpeed_m_s, mass_kg, more);
}

/// A hand that draws to `draw_m` along -x within `draws_s`, and holds for `holds_s`.
std::string drawTo(double draw_m, double draws_s, double holds_s, int rows = 50) {
  std::string text = "time_s,x_m,y_m,z_m,pressed\n0,0,0,0,1\n";
  for (int i = 1; i <= rows; ++i)
    text += exact(draws_s * i / rows) + ',' + exact(i == rows ? -draw_m : -draw_m * i / rows) + ",0,0,1\n";
  return text + exact(draws_s + holds_s) + ',' + exact(-draw_m) + ",0,0,1\n";
}

using Row = std::map<std::string, double>;

std::vector<Row> rowsIn(const std::string& csv) {
  const auto fieldsOf = [](const std::string& line) {
    std::vector<std::string> fields;
    std::istringstream in(line);
    for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
    return fields;
  };
  std::vector<Row> rows;
  std::istringstream in(csv);
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> names = fieldsOf(line);
  while (std::getline(in, line)) {
    const std::vector<std::string> fields = fieldsOf(line);
    EXPECT_EQ(fields.size(), names.size()) << line;
    Row& row = rows.emplace_back();
    for (std::size_t i = 0; i < fields.size(); ++i) row[names[i]] = std::strtod(fields[i].c_str(), nullptr);
  }
  return rows;
}

ProgramResult force(const TemporaryFolder& folder, const std::string& rig, const std::string& scenario,
                    const std::string& trace, std::vector<std::string> more = {"--positions"}) {
  std::vector<std::string> arguments{"force", folder.file("rig.toml", rig), "--scenario",
                                     folder.file("game.toml", scenario)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  arguments.push_back(folder.file("hand.csv", trace));
  arguments.insert(arguments.end(), {"--csv", "-"});
  return runCarom(folder, arguments);
}

TEST(Force, TheExactCasesOfACue) {
  const TemporaryFolder folder;
  double worst = 0.0;
  for (const auto& item : test::exactCases("force_cue.json")) {
    const auto& in = item["input"];
    const auto& expected = item["expected"];
    SCOPED_TRACE(item["id"].get<std::string>());
    const std::string hand = fmt::format(
        "[hand.force]\nkind = \"simulated\"\nforce_max_n = {:.17g}\nstiffness_max_n_m = {:.17g}\nd0_m = "
        "{:.17g}\n",
        in["force_max_n"].get<double>(), in["stiffness_max_n_m"].get<double>(), in["d0_m"].get<double>());
    const double mass_kg = in["mass_kg"], c_m_s = in["light_speed_m_s"];
    const ProgramResult result =
        force(folder, rigWith(hand), scenarioWith(mass_kg, c_m_s), drawTo(in["draw_m"], 0.5, 0.5));
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "") << "nothing is to be lowered";
    const Row last = rowsIn(result.out).back();
    const double tolerance = item["tol_relative"];
    const auto isNear = [&](const char* what, double got, double wanted) {
      worst = std::max(worst, std::abs(got / wanted - 1.0));
      EXPECT_LE(std::abs(got / wanted - 1.0), tolerance) << what << ' ' << got << ' ' << wanted;
    };
    isNear("scale", last.at("scale"), expected["scale"]);
    isNear("force", last.at("force_x_n"), expected["force_n"]);
    isNear("energy", last.at("energy_j"), expected["energy_j"]);
    isNear("beta", last.at("stroke_beta"), expected["stroke_beta"]);
    EXPECT_EQ(last.at("force_y_n"), 0.0);
    EXPECT_EQ(last.at("force_z_n"), 0.0);
    // The stroke in the game: its kinetic energy is W/s.
    const std::string stroke =
        fmt::format("[[stroke]]\nat_s = 0.0\npuck = \"white\"\nmomentum_kg_m_s = [{:.17g}, 0.0]\n",
                    expected["stroke_momentum_kg_m_s"].get<double>());
    const auto played = test::answerOf(folder, "simulate", scenarioWith(mass_kg, c_m_s, stroke),
                                       {"--until", "0.2", "--every", "0.1"});
    ASSERT_FALSE(played.is_null());
    const double beta = played.at("pucks").at(0).at("beta").at(0);
    const double gamma = 1.0 / std::sqrt((1.0 - beta) * (1.0 + beta));
    const double kinetic_j = mass_kg * c_m_s * c_m_s * gamma * gamma * beta * beta / (gamma + 1.0);
    EXPECT_NEAR(kinetic_j / (last.at("energy_j") / last.at("scale")), 1.0, 1e-12);
  }
  RecordProperty("worst", fmt::format("{:.2g}", worst));
}

const std::string kSimulated = "[hand.force]\nkind = \"simulated\"\n";

TEST(Force, ASlowDrawStoresW) {
  const TemporaryFolder folder;
  const ProgramResult result =
      force(folder, rigWith(kSimulated), scenarioWith(0.2, 1.42), drawTo(0.15, 20.0, 0.1, 2000));
  ASSERT_EQ(result.status, 0) << result.err;
  const std::vector<Row> rows = rowsIn(result.out);
  double sum_j = 0.0;
  for (std::size_t i = 1; i < rows.size(); ++i)
    sum_j -= 0.5 * (rows[i - 1].at("force_x_n") + rows[i].at("force_x_n")) *
             (rows[i].at("x_m") - rows[i - 1].at("x_m"));
  EXPECT_NEAR(sum_j / rows.back().at("energy_j"), 1.0, 1e-6);
  EXPECT_NEAR(rows.back().at("stored_j") / sum_j, 1.0, 1e-9);
}

TEST(Force, TheSameHandGivesTheSameBits) {
  const TemporaryFolder folder;
  for (const char* how : {"--positions", "--pushes"}) {
    const auto run = [&] {
      return force(folder, rigWith(kSimulated), scenarioWith(0.2, 1.42), drawTo(0.15, 1.0, 1.0), {how}).out;
    };
    const std::string first = run();
    EXPECT_EQ(rowsIn(first).size(), 2001u);
    EXPECT_EQ(first, run());
  }
}

TEST(Force, AHeldPuckShowsItsMass) {
  const TemporaryFolder folder;
  std::string trace = "time_s,x_m,y_m,z_m,pressed\n";
  for (int i = 0; i <= 8000; ++i)
    trace += exact(i * 1e-3) + ',' +
             exact(0.004 * std::min(1.0, i / 2000.0) * std::sin(6.283185307179586e-3 * i)) + ",0,0,1\n";
  const ProgramResult result = force(folder, rigWith(kSimulated), scenarioWith(0.2, 1.42), trace,
                                     {"--hold", "white", "--at-speed", "0.8", "--pushes"});
  ASSERT_EQ(result.status, 0) << result.err;
  const std::vector<Row> rows = rowsIn(result.out);
  EXPECT_NEAR(rows.back().at("shown_kg") / (0.2 / 0.216), 1.0, 0.1) << "γ³m at 0.8 c";
  EXPECT_NEAR(rows.front().at("proxy_beta"), 0.8, 1e-9);
  EXPECT_TRUE(std::isnan(rows.front().at("shown_kg"))) << "no second has passed";
  for (const Row& row : rows) ASSERT_GE(row.at("stored_j"), -1e-6);
}

TEST(Force, WrongRigsAreNamed) {
  const TemporaryFolder folder;
  const auto said = [&](const std::string& hand) {
    return force(folder, rigWith(hand), scenarioWith(0.2, 1.42), drawTo(0.1, 0.1, 0.1)).err;
  };
  const auto expectSaid = [&](const std::string& hand, const std::string& words) {
    EXPECT_NE(said(hand).find(words), std::string::npos) << hand << said(hand);
  };
  expectSaid("", "no hand of this rig has a force device, expected [hand.force]");
  expectSaid(kSimulated + "force_max_n = 0.0\n", "expected a number from 0.1 to 50");
  expectSaid(kSimulated + "force_max_n = 60.0\n", "expected a number from 0.1 to 50");
  expectSaid(kSimulated + "d0_m = 0.01\n", "expected a number from 0.02 to 0.5");
  expectSaid(kSimulated + "d0_m = 0.6\n", "expected a number from 0.02 to 0.5");
  expectSaid(kSimulated + "source = \"x\"\n", "has no meaning for a simulated force device");
  expectSaid("[hand.force]\nkind = \"evdev\"\n", "force_max_n is missing");
  expectSaid("[hand.force]\nkind = \"evdev\"\nforce_max_n = 5.0\nsource = \"event7\"\n",
             "expected a node such as");
  expectSaid("[hand.force]\nkind = \"vrpn\"\nforce_max_n = 5.0\n", "source is missing");
  expectSaid("[hand.force]\nkind = \"vrpn\"\nforce_max_n = 5.0\nsource = \"Arm\"\n", "expected one such as");
  expectSaid("[hand.force]\nkind = \"falcon\"\n", "simulated");
  expectSaid(kSimulated + "stiffness_max_n_m = 900.0\n",
             "warning: stiffness_max_n_m is 900, expected at most 600");
}

TEST(Force, WrongHandsAreNamedWithTheirPlace) {
  const TemporaryFolder folder;
  const auto said = [&](const std::string& trace) {
    return force(folder, rigWith(kSimulated), scenarioWith(0.2, 1.42), trace).err;
  };
  const std::string head = "time_s,x_m,y_m,z_m,pressed\n";
  for (const auto& [trace, words] : std::vector<std::pair<std::string, std::string>>{
           {"", "hand.csv:1:1: "},
           {"time_s,x_m\n", "hand.csv:1:1: this is no header, expected 'time_s,x_m,y_m,z_m,pressed'"},
           {head, "there are no rows"},
           {head + "0,0,0,0\n", "hand.csv:2:1: the row has 4 columns, expected 5"},
           {head + "0,0,nan,0,1\n", "hand.csv:2:1: y_m is 'nan'"},
           {head + "0,0,0,0,2\n", "hand.csv:2:1: pressed is neither 0 nor 1"},
           {head + "0,0,0,0,1\n0,0,0,0,1\n", "hand.csv:3:1: time_s does not increase"},
           {head + "0,0,0,0,1\n1e9,0,0,0,1\n",
            "hand.csv:2:1: the trace lasts 1e+09 s, expected at most 4000 s"}}) {
    EXPECT_NE(said(trace).find(words), std::string::npos) << trace << said(trace);
  }
  EXPECT_NE(runCarom(folder, {"force", folder.file("r.toml", rigWith(kSimulated)), "--hold", "nobody",
                              "--seconds", "0.1"})
                .err.find("there is no puck 'nobody'"),
            std::string::npos);
}

TEST(Force, TheLiveDisplayEndsAndSaysWhatLimits) {
  const TemporaryFolder folder;
  const ProgramResult result =
      runCarom(folder, {"force", folder.file("r.toml", rigWith(kSimulated)), "--seconds", "0.5"});
  EXPECT_EQ(result.status, 0) << result.err;
  for (const char* words : {"force device simulated", "place", "force", "rate", "port", "limited by"})
    EXPECT_NE(result.out.find(words), std::string::npos) << result.out;
}

}  // namespace
}  // namespace carom
