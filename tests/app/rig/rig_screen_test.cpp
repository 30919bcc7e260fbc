// Curved screens in rig files: where their formulas put the window, what is refused, and the board for words.
#include "app/rig/rig_screen.h"

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <variant>

#include "app/fault_names.h"
#include "app/input_faults.h"
#include "app/temporary_folder.h"
#include "cave/mesh_files/measured_bytes.h"
#include "cave/screen/curved_screen.h"

namespace carom {
namespace {

using test::Fault;
using test::TemporaryFolder;

const std::string kArc =
    "unit = 'cm'\n"
    "axes = 'x-right y-forward z-up'\n"
    "[head]\n"
    "tracker = 'cap'\n"
    "[[tracker]]\n"
    "name = 'cap'\n"
    "kind = 'simulated'\n"
    "[[wall]]\n"
    "name = 'arc'\n"
    "pixels = [800, 400]\n"
    "screen = { shape = 'cylinder', foot = [10, 20, 0], axis = [0, 0, 2], radius = 300, from_deg = -60, "
    "to_deg = 60, "
    "bottom = 10, top = 260 }\n";

/// A place of a cylinder of 3 m about the height, from -60° to 60°, 0.1 to 2.6 m high, x right, y up, z back.
glm::dvec3 onArc_m(const glm::dvec2& inWindow) {
  const double angle = (inWindow.x - 0.5) * 2.0 * std::numbers::pi / 3.0;
  return {3.0 * std::sin(angle), 0.1 + 2.5 * inWindow.y, -3.0 * std::cos(angle)};
}

Rig rigOf(const std::string& text) {
  const TemporaryFolder folder;
  const auto inMillimetres = [](const glm::dvec2& at) { return 1e3 * onArc_m(at); };
  folder.file("arc.pfm", test::pfmBytes(33, 17, inMillimetres));
  folder.file("arc.vwf", test::vwfBytes(33, 17, onArc_m));
  folder.file("arc.obj", test::objText(40, 8, onArc_m));
  folder.file("coarse.obj", test::objText(4, 4, onArc_m));
  folder.file("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
  folder.file("novt.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder.file("nan.obj", "v 0 nan 0\n");
  folder.file("folded.obj", test::objText(40, 8, [](glm::dvec2 at) {
                at.x = at.x < 0.5 ? at.x : 1.0 - at.x;
                return onArc_m(at);
              }));
  folder.file("none.pfm", test::pfmBytes(8, 8, [](const glm::dvec2&) { return glm::dvec3(std::nan("")); }));
  folder.file("single.pfm", "PF\n1 1\n-1\n" + std::string(12, '\0'));
  folder.file("short.vwf", test::vwfBytes(33, 17, onArc_m).substr(0, 5000));
  folder.file("mirror.obj", "v -1 -1\nv 1 -1\nv 0 1\nvt 0 0\nvt 1 0\nvt 0.5 1\nf 1 2 3\n");
  return readRig(folder.file("given.toml", text));
}

std::string arcWith(const std::string& from, const std::string& to) {
  std::string text = kArc;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

void expectAt(const Wall& wall, const glm::dvec2& inWindow, const glm::dvec3& expected_m) {
  constexpr double kMesh_m = 3e-3;  // a tenth of a pixel: what the mesh may stand off the formula
  const auto place_m = inRoom_m(wall.screen->mesh, inWindow);
  ASSERT_TRUE(place_m);
  EXPECT_LT(glm::distance(*place_m, expected_m), kMesh_m)
      << place_m->x << " " << place_m->y << " " << place_m->z;
}

TEST(RigScreen, ACylinderTurnsToTheRightFromAhead) {
  const Rig rig = rigOf(kArc);
  const Wall& wall = rig.walls.at(0);
  ASSERT_TRUE(wall.screen);
  expectAt(wall, {0.0, 0.0}, {0.1 - 3.0 * std::sin(std::numbers::pi / 3.0), 0.2 + 1.5, 0.1});
  expectAt(wall, {0.5, 1.0}, {0.1, 3.2, 2.6});
  expectAt(wall, {1.0, 0.5}, {0.1 + 3.0 * std::sin(std::numbers::pi / 3.0), 0.2 + 1.5, 1.35});
}

TEST(RigScreen, ADomeHasItsFrontAtTheBottomAndLeansForward) {
  const Rig rig = rigOf(
      kArc.substr(0, kArc.find("screen")) +
      "facet_sagitta = 30\nscreen = { shape = 'dome', centre = [0, 0, 120], radius = 500, fov_deg = 180, "
      "tilt_deg = 20, heading_deg = 90 }\n");
  const Wall& wall = rig.walls.at(0);
  const double tilt = 20.0 * std::numbers::pi / 180.0;  // towards +x, where the heading is
  expectAt(wall, {0.5, 0.5}, {5.0 * std::sin(tilt), 0.0, 1.2 + 5.0 * std::cos(tilt)});
  // Half way down: 45° from the axis, to the front.
  const double below = tilt + std::numbers::pi / 4.0;
  expectAt(wall, {0.5, 0.25}, {5.0 * std::sin(below), 0.0, 1.2 + 5.0 * std::cos(below)});
  // Half way to the left of somebody who faces the front: the circle fits the window's height.
  const double side = 5.0 * std::sqrt(0.5);
  expectAt(wall, {0.375, 0.5}, {side * std::sin(tilt), side, 1.2 + side * std::cos(tilt)});
}

TEST(RigScreen, WordsStandOnAChordAheadWhereNoFlatWallDoes) {
  const Rig rig = rigOf(kArc);
  ASSERT_TRUE(rig.panel);
  const Wall& panel = *rig.panel;
  const double half_m = 3.0 * std::sin(std::numbers::pi / 6.0);
  EXPECT_NEAR(panel.lowerRight_m.x - panel.lowerLeft_m.x, 2.0 * half_m, 0.3);
  EXPECT_LT(glm::length(panel.lowerLeft_m - glm::dvec3(0.1, 0.2, panel.lowerLeft_m.z)), 3.0 + 1e-3)
      << "it stands on the inner side of the screen";
  EXPECT_LT(normalOf(panel).y, -0.99);
  EXPECT_GE(panel.lowerLeft_m.z, 0.1);
  EXPECT_LE(panel.upperLeft_m.z, 2.6);
}

TEST(RigScreen, APanelIsWhereTheRigSays) {
  const Rig rig =
      rigOf(kArc +
            "[panel]\nlower_left = [-100, 250, 50]\nlower_right = [100, 250, 50]\nupper_left = [-100, "
            "250, 150]\n");
  ASSERT_TRUE(rig.panel);
  EXPECT_EQ(rig.panel->lowerLeft_m, glm::dvec3(-1.0, 2.5, 0.5));
}

TEST(RigScreen, PiecesAreTheFlatWallsOfTheRoom) {
  const Rig rig = rigOf(kArc);
  const std::vector<Wall> flat = standingWalls(rig);
  ASSERT_EQ(flat.size(), rig.walls[0].screen->pieces.size());
  for (std::size_t i = 0; i < flat.size(); ++i) {
    EXPECT_EQ(flat[i].name, "arc");
    EXPECT_EQ(flat[i].piece, static_cast<int>(i) + 1);
    EXPECT_FALSE(flat[i].screen);
    EXPECT_GT(glm::dot(normalOf(flat[i]), glm::dvec3(0.1, 0.2, 1.7) - flat[i].lowerLeft_m), 2.0);
  }
}

TEST(RigScreen, APictureByDirectionIsForEyesOfItsOwn) {
  const std::string before = kArc.substr(0, kArc.find("screen"));
  const Rig rig = rigOf(before +
                        "warp = 'mirror.obj'\nsky = { kind = 'fisheye', fov_deg = 240, heading_deg = 90, "
                        "tilt_deg = 30, from = [10, 20, 170] }\n");
  const Wall& wall = rig.walls.at(0);
  ASSERT_TRUE(wall.sky && wall.screen);
  EXPECT_EQ(wall.sky->from_m, glm::dvec3(0.1, 0.2, 1.7));
  // The eyes face the heading, to the right of forward: their right is backward.
  EXPECT_LT(glm::distance(wall.sky->right, glm::dvec3(0, -1, 0)), 1e-12);
  const auto& sky = std::get<Sky>(wall.screen->shape);
  EXPECT_NEAR(sky.fov_rad, 240.0 * std::numbers::pi / 180.0, 1e-12);
  EXPECT_LT(glm::distance(sky.axis, glm::dvec3(0.5, 0, std::sqrt(0.75))), 1e-12);
  EXPECT_EQ(wall.warp.filename(), "mirror.obj");
  EXPECT_TRUE(standingWalls(rig).empty()) << "it stands nowhere in the room";
  ASSERT_TRUE(rig.panel) << "words stand before the eyes";
  const glm::dvec3 middle_m = 0.5 * (rig.panel->lowerRight_m + rig.panel->upperLeft_m);
  EXPECT_NEAR(middle_m.y, 3.0 * std::cos(std::numbers::pi / 6.0), 1e-3);
}

TEST(RigScreen, APictureByDirectionWithoutAPlaceIsTheHeads) {
  const Rig rig = rigOf(kArc.substr(0, kArc.find("screen")) + "sky = { kind = 'cubemap' }\n");
  ASSERT_TRUE(rig.walls.at(0).sky);
  EXPECT_FALSE(rig.walls[0].sky->from_m);
  EXPECT_EQ(rig.walls[0].screen->pieces.size(), 6U);
}

const std::string kWall = kArc.substr(0, kArc.find("screen"));

// The rig is in centimetres with z up; the files have x right, y up, z back.
TEST(RigScreen, AMeasuredScreenStandsWhereItsFileAndTheRigSay) {
  const std::string pose = "room_from_screen = { translation = [10, 20, 0], rotation_deg = [90, 0, 0] } }\n";
  for (const std::string& screen : {"{ shape = 'grid', file = 'arc.pfm', unit = 'mm', " + pose,
                                    "{ shape = 'grid', file = 'arc.vwf', unit = 'mm', " + pose,
                                    "{ shape = 'mesh', file = 'arc.obj', unit = 'm', " + pose}) {
    const Rig rig = rigOf(kWall + "screen = " + screen);
    const Wall& wall = rig.walls.at(0);
    ASSERT_TRUE(wall.screen);
    for (const glm::dvec2& at : {glm::dvec2(0.0, 0.0), {0.5, 1.0}, {1.0, 0.4}, {0.3, 0.7}}) {
      const glm::dvec3 there = onArc_m(at);
      expectAt(wall, at, glm::dvec3(0.1 + there.x, 0.2 - there.z, there.y));
    }
    ASSERT_TRUE(rig.panel) << "words stand on a chord of it";
  }
}

TEST(RigScreen, ARowOfAGridIsAtTheEdgeThatTheRigSays) {
  const std::string screen =
      "screen = { shape = 'grid', file = 'arc.pfm', unit = 'mm', room_from_screen = { "
      "rotation_deg = [90, 0, 0] }, rows = 'top' }\n";
  const Rig rig = rigOf(kWall + screen);
  expectAt(rig.walls.at(0), {0.5, 1.0}, {0.0, 3.0, 0.1});
}

TEST(RigScreen, TheLightInAVwfIsItsBlend) {
  const TemporaryFolder folder;
  std::string shares;
  for (int i = 0; i < 33 * 17 * 4; ++i) test::put(shares, 0.5F);
  folder.file("arc.vwf", test::vwfBytes(33, 17, onArc_m, 1e3, 0x200, shares));
  folder.file("plain.vwf", test::vwfBytes(33, 17, onArc_m));
  const std::string pose = "unit = 'mm', room_from_screen = { rotation_deg = [90, 0, 0] } }\n";
  const Rig with = readRig(
                folder.file("a.toml", kWall + "screen = { shape = 'grid', file = 'arc.vwf', " + pose)),
            without = readRig(
                folder.file("b.toml", kWall + "screen = { shape = 'grid', file = 'plain.vwf', " + pose));
  EXPECT_EQ(with.walls.at(0).blend.filename(), "arc.vwf");
  EXPECT_TRUE(without.walls.at(0).blend.empty());
}

class RigScreenFaults : public ::testing::TestWithParam<Fault> {};

TEST_P(RigScreenFaults, ArePlacedAndExplained) { test::expectExplained(GetParam(), rigOf); }

INSTANTIATE_TEST_SUITE_P(
    All, RigScreenFaults,
    ::testing::Values(
        Fault{"no turn", arcWith("to_deg = 60", "to_deg = -60"), 11, 109, "more than 0 and at most 360"},
        Fault{"over a turn", arcWith("to_deg = 60", "to_deg = 301"), 11, 109, "by 361°"},
        Fault{"no radius", arcWith("radius = 300", "radius = 0"), 11, 79, "a number above 0"},
        Fault{"upside down", arcWith("bottom = 10", "bottom = 270"), 11, 133, "not above the bottom"},
        Fault{"no axis", arcWith("[0, 0, 2]", "[0, 0, 0]"), 11, 59, "has no length"},
        Fault{"a dome of nothing",
              arcWith("screen",
                      "screen = { shape = 'dome', centre = [0, 0, 120], radius = 500, fov_deg = 0 }\n#"),
              11, 74, "a number above 0 up to 359"},
        Fault{"a dome of a whole turn",
              arcWith("screen",
                      "screen = { shape = 'dome', centre = [0, 0, 120], radius = 500, fov_deg = 360 }\n#"),
              11, 74, "a number above 0 up to 359"},
        Fault{"a mesh without vt", kWall + "screen = { shape = 'mesh', file = 'novt.obj' }\n", 11, 35,
              "novt.obj:4:3: '1' is wrong, expected both v and vt"},
        Fault{"a mesh with NaN", kWall + "screen = { shape = 'mesh', file = 'nan.obj' }\n", 11, 35,
              "nan.obj:1:5: 'nan' is wrong"},
        Fault{"no texels", arcWith("screen", "texels_per_pixel = 0\nscreen"), 11, 20, "from 1 to 4"},
        Fault{"corners, too", arcWith("screen", "lower_left = [0, 0, 0]\nscreen"), 11, 14, "beside screen"},
        Fault{"a flat wall's sagitta",
              kArc + "[[wall]]\nname = 'flat'\nlower_left = [0, 300, 0]\nlower_right = [100, "
                     "300, 0]\nupper_left = [0, 300, 100]\npixels = [9, 9]\nfacet_sagitta = 1\n",
              18, 17, "of a wall with a screen"},
        Fault{"a screen and a sky", arcWith("screen", "sky = { kind = 'fisheye' }\nscreen"), 11, 7,
              "without a screen"},
        Fault{"a sky with corners",
              arcWith("screen", "lower_left = [0, 0, 0]\nsky = { kind = 'fisheye' }\n#"), 11, 14,
              "beside screen or sky"},
        Fault{"a sky of no kind", arcWith("screen", "sky = { kind = 'dome' }\n#"), 11, 16, "fisheye"},
        Fault{"a fisheye of 0 degrees", arcWith("screen", "sky = { kind = 'fisheye', fov_deg = 0 }\n#"), 11,
              37, "a number above 0"},
        Fault{"a sky's sagitta", arcWith("screen", "facet_sagitta = 1\nsky = { kind = 'fisheye' }\n#"), 11,
              17, "of a wall with a screen"},
        Fault{"one triangle", kWall + "screen = { shape = 'mesh', file = 'one.obj' }\n", 11, 35,
              "two at least"},
        Fault{"no file", kWall + "screen = { shape = 'mesh', file = 'gone.obj' }\n", 11, 35, "gone.obj"},
        Fault{"a file of another kind", kWall + "screen = { shape = 'grid', file = 'arc.obj' }\n", 11, 35,
              "ending in .pfm or .vwf"},
        Fault{"a mesh with rows",
              kWall + "screen = { shape = 'mesh', file = 'arc.obj', unit = 'm', rows = 'top' }\n", 11, 65,
              "is of a grid"},
        Fault{"a large cell", kWall + "screen = { shape = 'mesh', file = 'coarse.obj', unit = 'm' }\n", 11,
              35, "a cell of the mesh has an edge of"},
        Fault{"a fold", kWall + "screen = { shape = 'mesh', file = 'folded.obj', unit = 'm' }\n", 11, 35,
              "folds over itself in the room"},
        Fault{"a grid of nothing", kWall + "screen = { shape = 'grid', file = 'none.pfm' }\n", 11, 35,
              "no four neighbours of the 8 × 8 points"},
        Fault{"a grid of one", kWall + "screen = { shape = 'grid', file = 'single.pfm' }\n", 11, 35,
              "2:1: '1' is wrong"},
        Fault{"a short vwf", kWall + "screen = { shape = 'grid', file = 'short.vwf' }\n", 11, 35,
              "33 × 17 points take 8976 bytes"},
        Fault{"too deep",
              kWall + "facet_sagitta = 0.0001\nscreen = { shape = 'grid', file = 'arc.pfm', unit = 'mm' }\n",
              11, 17, "flat pieces"},
        Fault{"a panel behind the head",
              kArc + "[panel]\nlower_left = [-100, -250, 50]\nlower_right = [100, -250, 50]\nupper_left = "
                     "[-100, -250, "
                     "150]\n",
              12, 1, "the panel is behind the head"},
        Fault{"a panel that faces away",
              kArc + "[panel]\nlower_left = [100, -250, 50]\nlower_right = [-100, -250, 50]\nupper_left = "
                     "[100, -250, "
                     "150]\n",
              12, 1, "face somebody who looks forward"}),
    test::nameOfFault);

}  // namespace
}  // namespace carom
