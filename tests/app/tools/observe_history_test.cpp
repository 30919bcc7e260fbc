// `carom observe --vertex`: what an eye sees of told histories, against cases of 50 digits; and histories
// that are refused.

#include <gtest/gtest.h>

#include <cmath>

#include "app/program.h"
#include "exact_cases.h"

namespace carom {
namespace {

using nlohmann::json;
using test::exactCases;
using test::runCarom;
using test::TemporaryFolder;

/// Expects numbers, or arrays of them, to agree.
void expectNear(const json& is, const json& expected, double most, const char* what) {
  if (expected.is_array()) {
    ASSERT_EQ(is.size(), expected.size()) << what;
    for (std::size_t i = 0; i < is.size(); ++i) EXPECT_NEAR(is[i], expected[i], most) << what;
  } else {
    EXPECT_NEAR(is, expected, most) << what;
  }
}

TEST(ObserveHistory, VerticesAreSeenAsTheExactCasesSay) {
  int seen = 0, unseen = 0;
  for (const json& one : exactCases("soft_emission.json")) {
    SCOPED_TRACE(one["id"].get<std::string>());
    const TemporaryFolder folder;
    for (const auto& [name, text] : one["files"].items()) folder.file(name, text.get<std::string>());
    std::vector<std::string> arguments = one["args"];
    for (std::string& argument : arguments)
      if (argument == "scenario.toml") argument = (folder / argument).string();
    arguments.insert(arguments.end(), {"--json", "-"});
    const test::ProgramResult result = runCarom(folder, arguments);
    ASSERT_EQ(result.status, 0) << result.err;
    const json points = json::parse(result.out)["points"], expected = one["expected"]["points"];
    const std::string scenario = one["files"]["scenario.toml"];
    const double c = std::stod(scenario.substr(scenario.find("light_speed_m_s = ") + 18));
    ASSERT_EQ(points.size(), expected.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      EXPECT_EQ(points[k]["vertex"], expected[k]["vertex"]);
      EXPECT_EQ(points[k]["status"], expected[k]["status"]);
      (expected[k]["status"] == "seen" ? seen : unseen)++;
      if (expected[k]["status"] != "seen") continue;
      const double tol = expected[k]["tol"];
      EXPECT_NEAR(points[k]["emission"]["t_s"], expected[k]["emission"]["t_s"], tol / c);
      expectNear(points[k]["emission"]["r_m"], expected[k]["emission"]["r_m"], tol, "r_m");
      expectNear(points[k]["seen_m"], expected[k]["seen_m"], tol, "seen_m");
      expectNear(points[k]["distance_m"], expected[k]["distance_m"], tol, "distance_m");
      expectNear(points[k]["beta_at_emission"], expected[k]["beta_at_emission"], tol, "beta");
      EXPECT_NEAR(points[k]["proper_time_s"], expected[k]["proper_time_s"], tol / c);
      const double doppler = expected[k]["doppler"];
      EXPECT_NEAR(points[k]["doppler"], doppler, expected[k]["tol_relative_doppler"].get<double>() * doppler);
    }
  }
  EXPECT_GT(seen, 10);
  EXPECT_GT(unseen, 0);
}

// A soft puck that flies freely is seen as a rigid one, a bouncing one where its matter is: the event lies on
// the matter and on the past cone.
TEST(ObserveHistory, PlacesOfSoftPucksAreSeenWhereTheirMatterIs) {
  const auto puck = [](const std::string& soft) {
    return "light_speed_m_s = 1.42\n[board]\nlength_m = 0.4\nwidth_m = 0.4\n[[puck]]\nname = "
           "\"disc\"\nradius_m = 0.03\n"
           "mass_kg = 0.2\nposition_m = [0.0, 0.02]\nbeta = [0.5, 0.0]\n" +
           soft;
  };
  const std::string soft = puck("[puck.soft]\ncells = 4\n");
  const TemporaryFolder folder;
  const auto seenAt = [&](const std::string& scenario, const std::string& t_s) {
    return test::answerOf(folder, "observe", scenario,
                          {"--event", t_s, "0.1", "-0.3", "0.2", "--beta", "0.3", "0.2", "0", "--point",
                           "disc", "0.02", "0.01", "0.005"})["points"][0];
  };
  const json rigid = seenAt(puck(""), "0.35"), free = seenAt(soft, "0.35");
  ASSERT_GT(rigid["emission"]["t_s"], 0.0);
  EXPECT_NEAR(free["emission"]["t_s"], rigid["emission"]["t_s"], 1e-13);
  expectNear(free["emission"]["r_m"], rigid["emission"]["r_m"], 1e-13, "r_m");
  expectNear(free["seen_m"], rigid["seen_m"], 1e-12, "seen_m");
  EXPECT_NEAR(free["doppler"], rigid["doppler"], 1e-12);
  EXPECT_NEAR(free["proper_time_s"], rigid["proper_time_s"], 1e-12);
  const json squeezed = seenAt(soft, "0.56");
  const double t_s = squeezed["emission"]["t_s"];
  const json then = test::answerOf(folder, "simulate", soft,
                                   {"--until", test::exact(t_s), "--point", "disc", "0.02", "0.01"});
  ASSERT_EQ(then["collisions"].size(), 1u);
  const json& r_m = squeezed["emission"]["r_m"];
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(r_m[i], then["points"][0]["r_m"][i], 1e-13);
    EXPECT_NEAR(squeezed["beta_at_emission"][i], then["points"][0]["beta"][i], 1e-12);
  }
  const double x = r_m[0].get<double>() - 0.1, y = r_m[1].get<double>() + 0.3, z = r_m[2].get<double>() - 0.2;
  EXPECT_NEAR(1.42 * (0.56 - t_s), std::sqrt(x * x + y * y + z * z), 1e-13);
}

// Table programs write a mark of UTF-8 and lines that end with CR LF. An eye where the vertex is sees it
// there.
TEST(ObserveHistory, ATableOfAnotherProgramIsReadAndAVertexIsMet) {
  const TemporaryFolder folder;
  folder.file("thing.csv", "\xEF\xBB\xBFt_s,x0_m,y0_m,z0_m\r\n0,0,0,0\r\n2,0,0,0\r\n");
  const json seen = test::answerOf(folder, "observe",
                                   "light_speed_m_s = 1.0\n[[body]]\nname = \"thing\"\nhistory = "
                                   "\"thing.csv\"\n",
                                   {"--event", "1", "0", "0", "0", "--vertex", "thing", "0"})["points"][0];
  EXPECT_EQ(seen["emission"]["t_s"], 1.0);
  EXPECT_EQ(seen["distance_m"], 0.0);
  EXPECT_EQ(seen["doppler"], 1.0);
}

/// Returns the words about a history.
std::string saidOf(const std::string& history, const std::string& more = {},
                   const std::vector<std::string>& vertex = {}) {
  const TemporaryFolder folder;
  folder.file("thing.csv", history);
  folder.file("thing.obj", "v 0 0 0\nv 1 0 0\nf 1 2 1\n");
  folder.file("scenario.toml",
              "light_speed_m_s = 1.0\n[[body]]\nname = \"thing\"\nhistory = \"thing.csv\"\n" + more);
  std::vector<std::string> arguments{"check", (folder / "scenario.toml").string()};
  if (!vertex.empty()) {
    arguments = {"observe", (folder / "scenario.toml").string(), "--event", "5", "0", "0", "0"};
    arguments.insert(arguments.end(), vertex.begin(), vertex.end());
  }
  const test::ProgramResult result = runCarom(folder, arguments);
  EXPECT_NE(result.status, 0) << history;
  return result.err;
}

TEST(ObserveHistory, BadHistoriesAreNamedWithTheirPlace) {
  const std::string head = "t_s,x0_m,y0_m,z0_m\n", rows = "0,0,0,0\n1,0.5,0,0\n";
  struct Case {
    std::string history, said;
  };
  for (const Case& one :
       {Case{head + "0,0,0,0\n1,1.5,0,0\n",
             "thing.csv:3:3: vertex 0 moves at 1.5 c from the row before to row 2"},
        Case{head + "0,0,0,0\n1,1,0,0\n", "thing.csv:3:3: vertex 0 moves at 1 c"},
        Case{head + rows + "0.5,0,0,0\n", "thing.csv:4:1: t_s is 0.5 after 1"},
        Case{head + "0,0,0,0\n", "thing.csv:3:1: the history has one row"},
        Case{head + rows + "2,0,0\n", "thing.csv:4:1: the row has 3 numbers, expected 4"},
        Case{head + rows + "2,0,nan,0\n", "thing.csv:4:5: 'nan' is no number"},
        Case{head + rows + "2,0,,0\n", "thing.csv:4:5: '' is no number"},
        Case{"t,x0_m,y0_m,z0_m\n" + rows, "thing.csv:1:2: the first line does not name"},
        Case{"t_s,x0_m,y0_m\n" + rows, "the first line does not name"}, Case{"", "the history has no row"}}) {
    const std::string said = saidOf(one.history);
    EXPECT_NE(said.find(one.said), std::string::npos) << one.said << "\n" << said;
  }
  const std::string ofMesh = saidOf(head + rows, "mesh = \"thing.obj\"\n");
  EXPECT_NE(ofMesh.find("5:8: the mesh has 2 vertices and the history of 'thing' 1"), std::string::npos);
  EXPECT_EQ(ofMesh.find("5:8"), ofMesh.rfind("5:8")) << "once: " << ofMesh;
  EXPECT_NE(saidOf(head + rows, "appears_s = 1.0\n").find("appears_s stands beside history"),
            std::string::npos);
  EXPECT_NE(saidOf(head + rows, {}, {"--vertex", "thing", "1"})
                .find("'thing' has no vertex 1, expected a number from 0 to 0"),
            std::string::npos);
  EXPECT_NE(
      saidOf(head + rows, {}, {"--vertex", "other", "0"}).find("there is no body 'other' with a history"),
      std::string::npos);
}

}  // namespace
}  // namespace carom
