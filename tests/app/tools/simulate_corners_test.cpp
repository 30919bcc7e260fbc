// `carom simulate`, `observe`, `events` and `check` with pucks that have corners, against exact contacts.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

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

std::string outlineText(const json& corners) {
  std::string text;
  for (const json& corner : corners)
    text += (text.empty() ? "[" : ", [") + exact(corner[0]) + ", " + exact(corner[1]) + "]";
  return "outline_m = [" + text + "]\n";
}

std::string caseText(const json& input) {
  const double c = input["c"];
  std::string text = "light_speed_m_s = " + exact(c) + "\n";
  for (int i = 0; i < 2; ++i) {
    const json& body = input["bodies"][i];
    text += "[[puck]]\nname = \"" + std::string(i == 0 ? "first" : "second") + "\"\n" +
            outlineText(body["corners"]) + "mass_kg = " + exact(body["m"]) +
            "\ninertia = " + exact(body["k"]) + "\nposition_m = [" + exact(body["r"][0]) + ", " +
            exact(body["r"][1]) + "]\nbeta = [" + exact(body["v"][0].get<double>() / c) + ", " +
            exact(body["v"][1].get<double>() / c) + "]\nspin_rad_s = " + exact(body["omega"]) + "\n";
  }
  return text;
}

double gammaOf(const json& v, double c) {
  return 1.0 / std::sqrt(1.0 - std::pow(v[0].get<double>() / c, 2) - std::pow(v[1].get<double>() / c, 2));
}

/// The time of an event in the frame of equal and opposite speeds, to within a factor.
double orderOf(const json& input, double t, double x, double y) {
  const double c = input["c"];
  double order = 0.0;
  for (const json& body : input["bodies"]) {
    const json& v = body["v"];
    order += gammaOf(v, c) * (t - (v[0].get<double>() * x + v[1].get<double>() * y) / (c * c));
  }
  return order;
}

void checkKick(const json& collision, const json& kick, const json& tolerance, double c) {
  for (std::size_t i = 0; i < 2; ++i) {
    const json& turn = collision["turns"][i];
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_NEAR(turn["beta_after"][k].get<double>() * c, kick["v"][i][k].get<double>(),
                  tolerance["v"].get<double>());
    EXPECT_NEAR(turn["spin_after_kg_m2_s"].get<double>(), kick["J"][i].get<double>(),
                tolerance["J"].get<double>());
  }
}

// A game takes the contact that is the first in the frame of equal speeds. Where the case asks for that of
// another frame, the game's is the same or earlier in its own.
TEST(SimulateCorners, BodiesMeetAsExactCasesSay) {
  const json cases = exactCases("polygon_contacts.json");
  const TemporaryFolder folder;
  int same = 0;
  for (const json& testCase : cases) {
    SCOPED_TRACE(testCase["id"].get<std::string>() + " " + testCase["input"]["group"].get<std::string>());
    const json &input = testCase["input"], &expected = testCase["expected"], &tolerance = testCase["tol"];
    const json found = answerOf(folder, "simulate", caseText(input), {"--until", exact(input["until"])});
    if (expected["status"] == "none") {
      EXPECT_EQ(found["collisions"].size(), 0u);
      continue;
    }
    ASSERT_GE(found["collisions"].size(), 1u);
    const json &collision = found["collisions"][0], &contact = expected["contact"];
    const double t = collision["contact"]["t_s"], x = collision["contact"]["r_m"][0],
                 y = collision["contact"]["r_m"][1];
    const double most = tolerance["contact"];
    const double order = orderOf(input, t, x, y), other = orderOf(input, contact[0], contact[1], contact[2]);
    EXPECT_LE(order, other + 2.0 * most);
    if (input["first_in"] != "cov" && order < other - 2.0 * most) continue;
    EXPECT_NEAR(t, contact[0].get<double>(), most);
    EXPECT_NEAR(x, contact[1].get<double>(), most);
    EXPECT_NEAR(y, contact[2].get<double>(), most);
    if (expected.contains("kick")) checkKick(collision, expected["kick"], tolerance, input["c"]);
    ++same;
  }
  EXPECT_GE(same, 5);
}

/// A bar of 8 cm; its tables and keys begin in line 2.
std::string bar(const std::string& name, const std::string& place, const std::string& more) {
  return "[[puck]]\nname = \"" + name +
         "\"\noutline_m = [[-0.04, -0.01], [0.04, -0.01], [0.04, 0.01], [-0.04, 0.01]]\nmass_kg = 0.2\n"
         "position_m = [" +
         place + "]\n" + more;
}

TEST(SimulateCorners, SideOnSideIsSaid) {
  const TemporaryFolder folder;
  const std::string scenario = "light_speed_m_s = 1.42\n" + bar("left", "-0.3, 0", "beta = [0.6, 0]\n") +
                               bar("right", "0.3, 0", "beta = [-0.6, 0]\n");
  const json found = answerOf(folder, "simulate", scenario, {"--until", "2"});
  ASSERT_EQ(found["collisions"].size(), 1u);
  EXPECT_EQ(found["collisions"][0]["side_on_side"], true);
  EXPECT_NEAR(found["collisions"][0]["contact"]["r_m"][0].get<double>(), 0.0, 1e-15);
  EXPECT_EQ(found["pucks"][0]["spin_kg_m2_s"], 0.0);
  const auto events =
      runCarom(folder, {"events", folder.file("scenario.toml", scenario), "--until", "2", "--csv", "-"});
  EXPECT_NE(events.out.find(",side_on_side\n"), std::string::npos) << events.out;
  EXPECT_NE(events.out.find(",1\n"), std::string::npos) << events.out;
  const auto table = runCarom(folder, {"events", folder.file("scenario.toml", scenario), "--until", "2"});
  EXPECT_NE(table.out.find("puck-puck="), std::string::npos) << table.out;
}

// The corner of a spinning bar, and that of a told body that moves and turns like it.
TEST(SimulateCorners, CornersAreSeenAsPointsOfToldBodies) {
  const TemporaryFolder folder;
  const std::string scenario =
      "light_speed_m_s = 1.42\n" +
      bar("bar", "-0.3, 0.1", "height_m = 0.02\nbeta = [0.6, 0.2]\nspin_rad_s = 20\n") +
      "[[body]]\nname = \"told\"\nat = { t_s = 0, r_m = [-0.3, 0.1, 0.01] }\n"
      "spin_rad_s = 20\n[[body.leg]]\nbeta = [0.6, 0.2, 0]\n";
  const json found = answerOf(folder, "observe", scenario,
                              {"--event", "2", "0.2", "-0.4", "0.3", "--beta", "0.3", "0.1", "0", "--point",
                               "bar", "0.04", "0.01", "0.01", "--point", "told", "0.04", "0.01", "0.01"});
  const json &puck = found["points"][0], &told = found["points"][1];
  for (const char* key : {"distance_m", "doppler", "proper_time_s"})
    EXPECT_NEAR(puck[key].get<double>(), told[key].get<double>(), 1e-11) << key;
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(puck["seen_m"][i].get<double>(), told["seen_m"][i].get<double>(), 1e-12);
}

struct Wrong {
  std::string keys;  ///< of a puck after its name, from line 4
  std::string place, words;
};

/// Checks a scenario and expects one error, at that place and with these words.
void expectOneError(const TemporaryFolder& folder, const std::string& scenario, const std::string& place,
                    const std::string& words) {
  SCOPED_TRACE(scenario);
  const auto result = runCarom(folder, {"check", folder.file("wrong.toml", scenario)});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("wrong.toml" + place), std::string::npos) << result.err;
  EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
  EXPECT_EQ(result.err.find("error:"), result.err.rfind("error:")) << "one fault is one error\n"
                                                                   << result.err;
}

const std::string kBarHead =
    "light_speed_m_s = 1.42\n[[puck]]\nname = \"bar\"\nmass_kg = 0.2\nposition_m = [0, 0]\nbeta = [0, 0]\n";

TEST(SimulateCorners, CheckSaysWhereAnOutlineIsWrong) {
  const TemporaryFolder folder;
  std::string many;
  for (int k = 0; k < 257; ++k)
    many +=
        fmt::format("[{:.9f}, {:.9f}],\n", std::cos(2.0 * M_PI * k / 257), std::sin(2.0 * M_PI * k / 257));
  const Wrong wrongs[]{
      {"outline_m = [[-1, -1], [1, 1], [1, -1], [-1, 2]]\n", ":7:32: outline_m of puck 'bar'", "cross"},
      {"outline_m = [[-1, -1], [-1, 1], [1, 1], [1, -1]]\n", ":7:14:", "clockwise"},
      {"outline_m = [[-1, -1], [1, 1]]\n", ":7:14:", "2 corners: expected 3 to 256"},
      {"outline_m = []\n", ":7:13:", "0 corners: expected 3 to 256"},
      {"outline_m = [\n" + many + "]\n", ":8:1:", "257 corners: expected 3 to 256"},
      {"outline_m = [[-1, 0], [0, 0], [1, 0]]\n", ":7:14:", "area"},
      {"outline_m = [[-1, -1],\n[1, -1],\n[1, -1],\n[0, 1]]\n", ":9:1:", "corner 3 lies on corner 2"},
      {"outline_m = [[-1, -1],\n[1, -1],\n[0, 1],\n[-1, -1]]\n", ":10:1:", "corner 4 lies on corner 1"},
      {"outline_m = [[-1, -1],\n[nan, -1],\n[0, 1]]\n", ":8:2:", "outline_m[1][0] is nan, expected a number"},
      {"outline_m = [[-1, -1],\n[1, -inf],\n[0, 1]]\n",
       ":8:5:", "outline_m[1][1] is -inf, expected a number"},
      {"outline_m = [[-1, -1],\n[1, -1],\n[0, 1e300]]\n", ":9:5:", "is 1e+300, expected a number"},
      {"outline_m = [[-1, -1],\n[1, \"-1\"],\n[0, 1]]\n", ":8:5:", "is a text, expected a number"},
      {"outline_m = [[-1, -1],\n[1, -1, 3],\n[0, 1, 3]]\n",
       ":8:1:", "outline_m[1] has 3 values, expected a place [x, y]"},
      {"outline_m = [-1, -1, 1, -1, 0, 1]\n", ":7:14:", "outline_m[0] is a whole number, expected a place"},
      {"outline_m = [{x = 1, y = 2}, {x = 2, y = 1}]\n",
       ":7:14:", "outline_m[0] is a table, expected a place"},
      {"outline_m = 3\n", ":7:13:", "outline_m is a whole number, expected an array of places [x, y]"},
      {"outline_m = \"mesh\"\n", ":7:13:", "outline_m is a text, expected an array of places [x, y]"},
      {"outline_m = [[-1e-90, 0], [1e-90, 0], [0, 1e-90]]\n", ":7:13:", "too near to each other"},
      {"outline_m = [[1e9, 1e9], [999999999.9, 1e9], [1e9, 999999999.9]]\n", ":7:13:", "too far from [0, 0]"},
      {"radius_m = 1\noutline_m = [[-1, -1], [1, -1], [0, 1]]\n",
       ":7:12:", "radius_m stands beside outline_m"},
      {"radius_m = -1\noutline_m = [[-1, -1], [1, -1], [0, 1]]\n",
       ":7:12:", "radius_m stands beside outline_m"},
      {"outline_m = [[-1, -0.5], [1, -0.5], [0, 1]]\nspin_rad_s = 1.4\n",
       ":8:14:", "corner 1 at (-1, -0.5) m would move at 1.10"},
      {"outline_m = [[-1, -0.5], [1, -0.5], [0, 1]]\nspin_kg_m2_s = 1e9\n", ":8:16:", "corner 1 at"},
      {"outline_m = [[-1, -0.5], [1, -0.5], [1, -0.5]]\nspin_rad_s = 1e8\n",
       ":7:37:", "corner 3 lies on corner 2"},
      {"outline_m = [[-1, -0.5], [1, -0.5], [0, 1]]\n[physics]\nfriction_m_s2 = 0.1\n",
       ":9:17:", "friction_m_s2 slows puck 'bar', which has corners"},
      {"outline_m = [[-1, -0.5], [1, -0.5], [0, 1]]\n[physics]\nspin_deceleration_m_s2 = 0.1\n",
       ":9:26:", "spin_deceleration_m_s2 slows puck 'bar', which has corners"},
      {"outline_m = [[-3, -0.5], [1, -0.5], [0, 1]]\n[board]\nlength_m = 3\nwidth_m = 3\n",
       ":5:14:", "reaches over"},
  };
  for (const Wrong& wrong : wrongs) expectOneError(folder, kBarHead + wrong.keys, wrong.place, wrong.words);
}

// In outlines of 5 to 40 corners, a line each, one at a time is doubled, changed with the next one or no
// number.
TEST(SimulateCorners, CheckSaysWhichCornerIsWrong) {
  const TemporaryFolder folder;
  for (const std::size_t count : {5, 12, 40}) {
    for (std::size_t k = 0; k < count; k += 4) {
      std::vector<std::string> corners;
      for (std::size_t i = 0; i < count; ++i) {
        const double angle_rad = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(count);
        corners.push_back(fmt::format("[{:.9f}, {:.9f}]", std::cos(angle_rad), std::sin(angle_rad)));
      }
      const auto expectError = [&](const std::vector<std::string>& wrong, std::size_t corner,
                                   const std::string& words) {
        std::string text = kBarHead + "outline_m = [\n";
        for (const std::string& each : wrong) text += each + ",\n";
        expectOneError(folder, text + "]\n", fmt::format(":{}:", 8 + corner), words);
      };
      auto wrong = corners;
      wrong.insert(wrong.begin() + static_cast<std::ptrdiff_t>(k), corners[(k + 2) % count]);
      const std::size_t other = (k + 2) % count + ((k + 2) % count >= k ? 1 : 0);
      expectError(
          wrong, std::max(k, other),
          fmt::format("corner {} lies on corner {}:", std::max(k, other) + 1, std::min(k, other) + 1));
      wrong = corners;
      std::swap(wrong[k], wrong[(k + 1) % count]);
      // The side into the first of the two crosses the one out of the second.
      const std::size_t before = (k + count - 1) % count, after = (k + 1) % count;
      expectError(wrong, std::max(before, after),
                  fmt::format("the side from corner {} crosses or touches the side from corner {}:",
                              std::max(before, after) + 1, std::min(before, after) + 1));
      wrong = corners;
      wrong[k] = "[0.5, nan]";
      expectError(wrong, k, fmt::format("outline_m[{}][1] is nan", k));
    }
  }
}

/// A prism of an outline as an .obj file.
std::string prismText(const std::vector<std::array<double, 2>>& corners) {
  std::string text, low = "f", high = "f";
  for (std::size_t k = 0; k < corners.size(); ++k) {
    for (const double z : {0.0, 1.0}) text += fmt::format("v {} {} {}\n", corners[k][0], corners[k][1], z);
    low += fmt::format(" {}", 2 * (corners.size() - k) - 1);
    high += fmt::format(" {}", 2 * k + 2);
  }
  return text + low + "\n" + high + "\n";
}

// A mesh that lies elsewhere and is of another size than the puck: its footprint against the same corners by
// hand, a bar of 12 by 4 and an angle.
TEST(SimulateCorners, MeshesCollideByTheirFootprints) {
  const TemporaryFolder folder;
  folder.file("bar.obj", prismText({{5, 1}, {17, 1}, {17, 5}, {5, 5}}));
  folder.file("angle.obj", prismText({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}));
  const auto pucks = [](const std::string& bar, const std::string& angle) {
    return "light_speed_m_s = 1.42\n[[puck]]\nname = \"bar\"\nmass_kg = 0.2\nposition_m = [-0.3, 0.01]\n"
           "beta = [0.5, 0]\nspin_rad_s = 3\n" +
           bar + "[[puck]]\nname = \"angle\"\nmass_kg = 0.3\nposition_m = [0.3, 0]\nbeta = [-0.4, 0]\n" +
           angle;
  };
  // The centre of the angle's area is at 5/6, its farthest corner at (2, 0).
  const double scale = 0.05 / std::hypot(7.0 / 6.0, 5.0 / 6.0);
  json corners;
  for (const auto& [x, y] :
       std::vector<std::pair<double, double>>{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}})
    corners.push_back({scale * (x - 5.0 / 6.0), scale * (y - 5.0 / 6.0)});
  const double side = 0.06 / std::hypot(6.0, 2.0);
  const json bar{{-6 * side, -2 * side}, {6 * side, -2 * side}, {6 * side, 2 * side}, {-6 * side, 2 * side}};
  const json meshes = answerOf(folder, "simulate",
                               pucks("mesh = \"bar.obj\"\noutline = \"mesh\"\nradius_m = 0.06\n",
                                     "mesh = \"angle.obj\"\noutline = \"mesh\"\nradius_m = 0.05\n"),
                               {"--until", "0.9"});
  const json byHand =
      answerOf(folder, "simulate", pucks(outlineText(bar), outlineText(corners)), {"--until", "0.9"});
  ASSERT_GE(meshes["collisions"].size(), 1u);
  for (const char* key : {"beta", "r_m"})
    for (std::size_t puck = 0; puck < 2; ++puck)
      for (std::size_t k = 0; k < 2; ++k)
        EXPECT_NEAR(meshes["pucks"][puck][key][k].get<double>(), byHand["pucks"][puck][key][k].get<double>(),
                    1e-6)
            << key << " of puck " << puck;
}

TEST(SimulateCorners, CheckSaysWhyAMeshGivesNoOutline) {
  const TemporaryFolder folder;
  folder.file("plate.obj", "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nf 1 2 3 4\n");
  folder.file("nan.obj", "v 0 0 0\nv 1 0 0\nv nan 1 0\nf 1 2 3\n");
  folder.file("two.obj", prismText({{0, 0}, {1, 0}, {0, 1}}) + "v 5 5 0\nv 6 5 0\nv 5 6 0\nf 7 8 9\n");
  const Wrong wrongs[]{
      {"radius_m = 1\nmesh = \"plate.obj\"\noutline = \"mesh\"\n",
       ":8:8:", "is a line or a point, expected an area"},
      {"mesh = \"plate.obj\"\noutline = \"mesh\"\n", ":7:8:", "is a line or a point, expected an area"},
      {"radius_m = 1\noutline = \"mesh\"\n", ":8:11:", "has no mesh, expected mesh = a file"},
      {"outline = \"mesh\"\n", ":7:11:", "has no mesh, expected mesh = a file"},
      {"radius_m = 1\nmesh = \"two.obj\"\noutline = \"hull\"\n",
       ":9:11:", "outline is 'hull', expected 'mesh'"},
      {"outline = [[0, 0], [1, 0], [0, 1]]\n", ":7:11:", "outline is an array, expected 'mesh'"},
      {"outline_m = [[0, 0], [1, 0], [0, 1]]\nmesh = \"two.obj\"\noutline = \"mesh\"\n",
       ":9:11:", "beside outline_m"},
      {"outline_m = [[0, 0], [1, 0], [0, 1]]\noutline = 3\n", ":8:11:", "beside outline_m"},
      {"mesh = \"two.obj\"\noutline = \"mesh\"\nspin_rad_s = 100\n", ":2:1:", "radius_m is missing"},
      {"radius_m = 0\nmesh = \"two.obj\"\noutline = \"mesh\"\n", ":7:12:", "radius_m is 0, expected"},
      {"radius_m = 1e-90\nmesh = \"two.obj\"\noutline = \"mesh\"\n", ":7:12:", "too small to calculate with"},
      {"radius_m = 1\nmesh = \"none.obj\"\noutline = \"mesh\"\n", ":8:8:", "none.obj"},
      {"mesh = \"none.obj\"\noutline = \"mesh\"\n", ":7:8:", "none.obj"},
      {"radius_m = 1\nmesh = \"nan.obj\"\noutline = \"mesh\"\n", ":8:8:", "nan.obj:3:3: 'nan' is wrong"},
      {"radius_m = 1\nmesh = \"two.obj\"\noutline = \"mesh\"\nspin_rad_s = 2\n",
       ":10:14:", "would move at 1.40"},
  };
  for (const Wrong& wrong : wrongs) expectOneError(folder, kBarHead + wrong.keys, wrong.place, wrong.words);
  const auto pieces = runCarom(
      folder, {"check", folder.file("pieces.toml",
                                    kBarHead + "radius_m = 0.1\nmesh = \"two.obj\"\noutline = \"mesh\"\n")});
  EXPECT_EQ(pieces.status, 0) << pieces.err;
  EXPECT_NE(pieces.err.find(":8:8: the mesh of puck 'bar' covers several pieces"), std::string::npos)
      << pieces.err;
}

TEST(SimulateCorners, CheckWarnsOfCornersBesideTheCentreOfMass) {
  const TemporaryFolder folder;
  const auto result = runCarom(
      folder,
      {"check",
       folder.file("odd.toml",
                   "light_speed_m_s = 1.42\n[[puck]]\nname = \"bar\"\nmass_kg = 0.2\n"
                   "position_m = [0, 0]\nbeta = [0, 0]\noutline_m = [[0, 0], [0.1, 0], [0.1, 0.1]]\n")});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE((result.err + result.out).find(":7:"), std::string::npos) << result.err << result.out;
  EXPECT_NE((result.err + result.out).find("centre of mass"), std::string::npos) << result.err << result.out;
  EXPECT_NE(result.out.find("puck bar: 3 corners"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace carom
