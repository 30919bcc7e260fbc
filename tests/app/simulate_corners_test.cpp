// `carom simulate`, `observe`, `events` and `check` with pucks that have corners, against exact contacts.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "app/program.h"

namespace carom {
namespace {

using nlohmann::json;
using test::answerOf;
using test::exact;
using test::runCarom;
using test::sharedCases;
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

// A game takes the contact that is the first in the frame of equal speeds. Where the case asks for that of another
// frame, the game's is the same or earlier in its own.
TEST(SimulateCorners, BodiesMeetAsExactCasesSay) {
  const json cases = sharedCases("polygon_contacts.json");
  if (cases.is_null()) GTEST_SKIP() << "the exact cases are not beside this checkout";
  const TemporaryFolder folder;
  int same = 0;
  for (const json& testCase : cases["cases"]) {
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

TEST(SimulateCorners, CheckSaysWhereAnOutlineIsWrong) {
  const TemporaryFolder folder;
  const Wrong wrongs[]{
      {"outline_m = [[-1, -1], [1, 1], [1, -1], [-1, 2]]\n", ":4:", "cross"},
      {"outline_m = [[-1, -1], [-1, 1], [1, 1], [1, -1]]\n", ":4:", "clockwise"},
      {"outline_m = [[-1, -1], [1, 1]]\n", ":4:", "corners"},
      {"outline_m = []\n", ":4:", "corners"},
      {"outline_m = [[-1, 0], [0, 0], [1, 0]]\n", ":4:", "area"},
      {"outline_m = [[-1, -1],\n[1, -1],\n[1, -1],\n[0, 1]]\n", ":6:", "corner"},
      {"outline_m = [[-1, -1],\n[nan, -1],\n[0, 1]]\n", ":5:", "expected a number"},
      {"outline_m = [[-1, -1],\n[1, -1, 3],\n[0, 1]]\n", ":5:", "expected a place [x, y]"},
      {"outline_m = 3\n", ":4:", "expected an array of places"},
      {"radius_m = 1\noutline_m = [[-1, -1], [1, -1], [0, 1]]\n", ":4:", "radius_m stands beside outline_m"},
      {"outline_m = [[-1, -0.5], [1, -0.5], [0, 1]]\nspin_rad_s = 1.4\n",
       ":5:", "corner 1 at (-1, -0.5) m would move at 1.10"},
      {"outline_m = [[-1, -0.5], [1, -0.5], [0, 1]]\nspin_kg_m2_s = 1e9\n", ":5:", "corner 1 at"},
      {"outline_m = [[-1, -0.5], [1, -0.5], [0, 1]]\n[physics]\nfriction_m_s2 = 0.1\n", ":9:", "has corners"},
      {"outline_m = [[-3, -0.5], [1, -0.5], [0, 1]]\n[board]\nlength_m = 3\nwidth_m = 3\n",
       ":5:", "reaches over"},
  };
  for (const Wrong& wrong : wrongs) {
    SCOPED_TRACE(wrong.keys);
    std::string keys = wrong.keys;
    const std::size_t end = std::min(keys.find("[physics]"), keys.find("[board]"));
    keys.insert(std::min(end, keys.size()), "position_m = [0, 0]\nmass_kg = 0.2\nbeta = [0, 0]\n");
    const auto result = runCarom(
        folder,
        {"check", folder.file("wrong.toml", "light_speed_m_s = 1.42\n[[puck]]\nname = \"bar\"\n" + keys)});
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.err.find("wrong.toml" + wrong.place), std::string::npos) << result.err;
    EXPECT_NE(result.err.find(wrong.words), std::string::npos) << result.err;
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

// A mesh that lies elsewhere and is of another size than the puck: its footprint against the same corners by hand, a bar
// of 12 by 4 and an angle.
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
  folder.file("two.obj", prismText({{0, 0}, {1, 0}, {0, 1}}) + "v 5 5 0\nv 6 5 0\nv 5 6 0\nf 7 8 9\n");
  const std::string head =
      "light_speed_m_s = 1.42\n[[puck]]\nname = \"bar\"\nmass_kg = 0.2\nposition_m = [0, 0]\nbeta = [0, 0]\n";
  const auto check = [&](const std::string& keys) {
    return runCarom(folder, {"check", folder.file("mesh.toml", head + keys)});
  };
  const Wrong wrongs[]{
      {"radius_m = 1\nmesh = \"plate.obj\"\noutline = \"mesh\"\n",
       ":8:8:", "is a line or a point, expected an area"},
      {"radius_m = 1\noutline = \"mesh\"\n", ":8:11:", "has no mesh, expected mesh = a file"},
      {"radius_m = 1\nmesh = \"plate.obj\"\noutline = \"hull\"\n", ":9:11:", "expected 'mesh'"},
      {"outline_m = [[0, 0], [1, 0], [0, 1]]\nmesh = \"two.obj\"\noutline = \"mesh\"\n",
       ":9:11:", "beside outline_m"},
      {"mesh = \"two.obj\"\noutline = \"mesh\"\n", ":2:1:", "radius_m"},
      {"radius_m = 1\nmesh = \"none.obj\"\noutline = \"mesh\"\n", ":8:8:", "none.obj"},
  };
  for (const Wrong& wrong : wrongs) {
    SCOPED_TRACE(wrong.keys);
    const auto result = check(wrong.keys);
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.err.find("mesh.toml" + wrong.place), std::string::npos) << result.err;
    EXPECT_NE(result.err.find(wrong.words), std::string::npos) << result.err;
  }
  const auto pieces = check("radius_m = 0.1\nmesh = \"two.obj\"\noutline = \"mesh\"\n");
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
