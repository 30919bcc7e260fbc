#include "app/room_import/sgct_file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>
#include <variant>

#include "app/import_faults.h"
#include "app/room_import/room_check.h"
#include "app/temporary_folder.h"
#include "cave/screen/curved_screen.h"
#include "cave/screen/screen_facts.h"
#include "places.h"

namespace carom {
namespace {

using test::TemporaryFolder;
using Fault = test::ImportFault;

Room read(const std::string& text) {
  const TemporaryFolder folder;
  return readSgct(folder.file("room.json", text));
}

const std::string kGood = R"({
  "version": 1, "masteraddress": "localhost",
  "nodes": [{ "address": "localhost", "port": 20400, "windows": [{
    "pos": { "x": 50, "y": 60 }, "size": { "x": 1280, "y": 720 },
    "viewports": [{
      "projection": {
        "type": "ProjectionPlane",
        "lowerleft": { "x": -1.6, "y": -0.9, "z": 0.0 },
        "upperleft": { "x": -1.6, "y": 0.9, "z": 0.0 },
        "upperright": { "x": 1.6, "y": 0.9, "z": 0.0 }
      }
    }]
  }] }],
  "users": [{ "eyeseparation": 0.06, "pos": { "x": 0, "y": 0, "z": 4.0 } }]
}
)";

std::string changed(const std::string& from, const std::string& to) {
  std::string text = kGood;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(SgctFile, ReadsAWall) {
  const Room room = read(kGood);
  EXPECT_TRUE(room.findings.empty()) << room.findings[0].text;
  EXPECT_TRUE(judgeRoom(room).empty()) << judgeRoom(room)[0].text;
  ASSERT_EQ(room.walls.size(), 1u);
  const Wall& wall = room.walls[0].wall;
  EXPECT_EQ(wall.name, "front") << "named for where it is: SGCT has no names";
  EXPECT_EQ(wall.lowerRight_m, glm::dvec3(1.6, -0.9, 0.0));
  EXPECT_EQ(wall.pixels, glm::ivec2(1280, 720));
  EXPECT_EQ(wall.window.position_px, glm::ivec2(50, 60));
  EXPECT_EQ(wall.stereo, StereoMode::mono);
  EXPECT_EQ(room.eyeSeparation_m, 0.06);
  EXPECT_EQ(room.viewers.front().eyes_m, glm::dvec3(0, 0, 4));
  EXPECT_FALSE(room.oneWindow);
}

TEST(SgctFile, ViewportsShareTheirWindow) {
  // Two halves, the lower for the left eye; SGCT counts from the lower left.
  std::string text = changed(R"("viewports": [{)", R"("viewports": [{ "pos": { "x": 0, "y": 0.5 },
      "size": { "x": 1, "y": 0.5 }, "eye": "right",)");
  const std::size_t begin = text.find("{ \"pos\": { \"x\": 0, \"y\": 0.5"), end = text.find("}]\n  }] }]");
  std::string second = text.substr(begin, end + 1 - begin);
  second.replace(second.find("0.5"), 3, "0.0").replace(second.find("right"), 5, "left");
  text.insert(end + 1, ", " + second);
  const Room room = read(text);
  EXPECT_TRUE(room.findings.empty()) << room.findings[0].text;
  ASSERT_EQ(room.walls.size(), 2u);
  ASSERT_TRUE(room.oneWindow);
  EXPECT_EQ(room.oneWindow->position_px, glm::ivec2(50, 60));
  EXPECT_EQ(room.walls[0].wall.window.position_px, glm::ivec2(0, 0));
  EXPECT_EQ(room.walls[0].wall.stereo, StereoMode::right);
  EXPECT_EQ(room.walls[1].wall.window.position_px, glm::ivec2(0, 360));
  EXPECT_EQ(room.walls[1].wall.window.size_px, glm::ivec2(1280, 360));
  EXPECT_EQ(room.walls[1].wall.stereo, StereoMode::left);
  EXPECT_EQ(room.walls[1].wall.name, "front-2");
}

class SgctFaults : public ::testing::TestWithParam<Fault> {};

TEST_P(SgctFaults, ArePlacedAndExplained) { test::expectFound(GetParam(), read(GetParam().text)); }

INSTANTIATE_TEST_SUITE_P(
    All, SgctFaults,
    ::testing::Values(
        Fault{"a number in quotes",
              changed("\"z\": 0.0 },\n        \"upperleft", "\"z\": \"0/05\" },\n        \"upperleft"),
              8,
              51,
              {"z is the text '0/05'", "expected a number"}},
        Fault{"a coordinate missing",
              changed(", \"z\": 0.0 },\n        \"upperleft", " },\n        \"upperleft"),
              8,
              22,
              {"z is missing in lowerleft"}},
        Fault{"a corner missing",
              changed("\"upperleft\": { \"x\": -1.6, \"y\": 0.9, \"z\": 0.0 },", ""),
              6,
              21,
              {"upperleft is missing"}},
        Fault{"askew",
              changed("1.6, \"y\": 0.9, \"z\": 0.0 }\n", "1.6, \"y\": 0.95, \"z\": 0.0 }\n"),
              10,
              23,
              {"upperright of wall", "right angle at upperleft by 50.0 mm"}},
        Fault{"half a pixel",
              changed("1280", "1280.5"),
              4,
              49,
              {"x is 1280.5, expected a whole number from 1"}},
        Fault{"no size", changed(", \"size\": { \"x\": 1280, \"y\": 720 }", ""), 3, 66, {"size is missing"}},
        Fault{"too far", changed("\"z\": 4.0", "\"z\": 4e10"), 14, 68, {"expected a number from"}},
        Fault{"eyes below zero", changed("0.06", "-0.06"), 14, 32, {"eyeseparation is -0.06"}},
        Fault{"no wall", R"({ "version": 1 })", 1, 1, {"no viewport here shows a wall"}},
        Fault{"no object", "[1]", 1, 1, {"an array"}},
        Fault{"unknown key", changed("\"version\"", "\"versoin\""), 2, 3, {"'versoin'", "'version'?"}, false},
        Fault{"key given twice",
              changed("\"version\": 1,", "\"version\": 1, \"version\": 2,"),
              2,
              3,
              {"given twice"},
              false},
        Fault{"stereo",
              changed("\"pos\": { \"x\": 50", "\"stereo\": \"LineInterlaced\", \"pos\": { \"x\": 50"),
              4,
              15,
              {"'LineInterlaced'", "'side_by_side'"},
              false},
        Fault{"no such user",
              changed("\"projection\": {", "\"user\": \"me\", \"projection\": {"),
              6,
              15,
              {"no user 'me'"},
              false},
        Fault{"two users",
              changed("\"users\": [", "\"users\": [{ \"pos\": { \"x\": 0, \"y\": 0, \"z\": 4 } }, "),
              14,
              84,
              {"2 users"},
              false},
        Fault{"blend",
              changed("\"projection\": {", "\"blendmask\": \"a.png\", \"projection\": {"),
              6,
              20,
              {"blendmask"},
              false}),
    [](const auto& tested) {
      std::string name = tested.param.what;
      std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
      return name;
    });

/// kGood with another projection.
std::string projected(const std::string& projection) {
  const std::size_t begin = kGood.find("\"type\""), end = kGood.find("      }\n    }]");
  std::string text = kGood;
  return text.replace(begin, end - begin, projection + " ");
}

TEST(SgctFile, SaysWhichProjectionsItCannotUse) {
  const Room room = read(projected(R"("type": "CubemapProjection", "quality": "1k")"));
  ASSERT_EQ(room.findings.size(), 2u);
  EXPECT_EQ(room.findings[0].at.line, 7);
  EXPECT_NE(room.findings[0].text.find("'CubemapProjection' shows no wall"), std::string::npos);
  EXPECT_TRUE(room.hasErrors()) << "no wall is left";
}

void expectVector(const glm::dvec3& found, const glm::dvec3& expected) {
  EXPECT_LT(glm::distance(found, expected), 1e-12) << found.x << ' ' << found.y << ' ' << found.z;
}

/// Returns the sky of a room's only wall.
Sky skyIn(const Room& room) {
  for (const Finding& finding : room.findings) EXPECT_NE(finding.kind, Finding::Kind::error) << finding.text;
  if (room.walls.size() != 1 || !room.walls[0].wall.screen) throw std::runtime_error("no picture");
  EXPECT_EQ(room.walls[0].wall.name, "sky");
  return std::get<Sky>(room.walls[0].wall.screen->shape);
}

// "A value of 90 would result in the forward facing direction being at the center" (SGCT's own schema).
TEST(SgctFile, AFisheyeBecomesASky) {
  const Room room = read(projected(R"("type": "FisheyeProjection", "fov": 165, "tilt": 30, "crop": {})"));
  const Sky sky = skyIn(room);
  EXPECT_EQ(sky.kind, SkyKind::fisheye);
  EXPECT_NEAR(sky.fov_rad, 165.0 / 180.0 * std::numbers::pi, 1e-12);
  const double leaning = std::sqrt(3.0) / 2.0;
  expectVector(sky.axis, {0.0, leaning, -0.5});
  expectVector(sky.front, {0.0, -0.5, -leaning});
  ASSERT_EQ(room.findings.size(), 1u);
  EXPECT_NE(room.findings[0].text.find("crop"), std::string::npos) << room.findings[0].text;
  EXPECT_EQ(room.walls[0].wall.sky->from_m, glm::dvec3(0, 0, 4)) << "the user's place, who is not tracked";
}

TEST(SgctFile, AnEquirectangularPictureIsSeenByAHeadThatIsTracked) {
  std::string text = projected(R"("type": "EquirectangularProjection")");
  const std::size_t at = text.find("\"projection\"");
  const Room room = read(text.insert(at, R"("tracked": true, )"));
  EXPECT_EQ(skyIn(room).kind, SkyKind::equirectangular);
  EXPECT_FALSE(room.walls[0].wall.sky->from_m);
}

// SGCT's window goes once round, the front at its left edge; its heights are in radii above the user.
TEST(SgctFile, ACylinderStandsRoundTheUser) {
  const Room room = read(
      projected(R"("type": "CylindricalProjection", "rotation": 90, "heightoffset": -0.5, "radius": 3)"));
  ASSERT_EQ(room.walls.size(), 1u);
  const auto& screen = std::get<CylinderScreen>(room.walls[0].wall.screen->shape);
  expectVector(screen.foot_m, {0, 0, 4});
  expectVector(screen.ahead, {0, 0, -1});
  EXPECT_EQ(screen.radius_m, 3.0);
  EXPECT_EQ(screen.bottom_m, -1.5);
  EXPECT_EQ(screen.top_m, 1.5);
  EXPECT_NEAR(screen.from_rad, -std::numbers::pi / 2.0, 1e-12);
  EXPECT_NEAR(screen.to_rad, 1.5 * std::numbers::pi, 1e-12);
  const Wall& wall = room.walls[0].wall;
  EXPECT_NEAR(factsOf(*wall.screen, wall.pixels, screen.foot_m).turns_rad, 2.0 * std::numbers::pi, 1e-12)
      << "as carom check says";
}

TEST(SgctFile, AMirrorsMeshesAreNamed) {
  const Room room = read(projected(
      R"("type": "SphericalMirrorProjection", "geometry": { "bottom": "b.obj", "left": "l.obj" })"));
  EXPECT_EQ(skyIn(room).kind, SkyKind::fisheye);
  ASSERT_EQ(room.findings.size(), 1u);
  EXPECT_NE(room.findings[0].text.find("bottom 'b.obj', left 'l.obj'"), std::string::npos)
      << room.findings[0].text;
}

TEST(SgctFile, PicturesOfWrongNumbersAreRefused) {
  for (const char* projection :
       {R"("type": "FisheyeProjection", "fov": 360)", R"("type": "FisheyeProjection", "tilt": "steep")",
        R"("type": "CylindricalProjection", "radius": 0)"}) {
    SCOPED_TRACE(projection);
    const Room room = read(projected(projection));
    EXPECT_TRUE(room.walls.empty());
    EXPECT_TRUE(room.hasErrors());
  }
}

// A screen by angles lies where SGCT draws it: 10 m along -z unless told, turned, then moved.
TEST(SgctFile, TakesPlanarProjectionsAsSgctDrawsThem) {
  const Room room = read(projected(R"("type": "PlanarProjection", "fov": { "hfov": 90, "vfov": 60 })"));
  ASSERT_EQ(room.walls.size(), 1u);
  const double half_m = 10.0 / std::sqrt(3.0);  // tan 30°
  const auto expectNear = [](const glm::dvec3& found_m, const glm::dvec3& expected_m) {
    EXPECT_LT(glm::distance(found_m, expected_m), 1e-9) << found_m.x << ' ' << found_m.y << ' ' << found_m.z;
  };
  expectNear(room.walls[0].wall.lowerLeft_m, {-10, -half_m, -10});
  expectNear(room.walls[0].wall.lowerRight_m, {10, -half_m, -10});
  expectNear(room.walls[0].wall.upperLeft_m, {-10, half_m, -10});
  ASSERT_EQ(room.findings.size(), 1u);
  EXPECT_EQ(room.findings[0].kind, Finding::Kind::warning);
  EXPECT_NE(room.findings[0].text.find("20.00 × 11.55 m, 10 m from the origin"), std::string::npos)
      << room.findings[0].text;
  // Yaw turns to the right, pitch up, roll clockwise; the offset comes last.
  const Room turned = read(projected(
      R"("type": "PlanarProjection", "distance": 2, "offset": { "x": 0, "y": 1, "z": 0 },
      "orientation": { "yaw": 90, "pitch": 0, "roll": 0 },
      "fov": { "left": 45, "right": 0, "down": 0, "up": 45 })"));
  ASSERT_EQ(turned.walls.size(), 1u);
  expectNear(turned.walls[0].wall.lowerLeft_m, {2, 1, -2});
  expectNear(turned.walls[0].wall.lowerRight_m, {2, 1, 0});
  expectNear(turned.walls[0].wall.upperLeft_m, {2, 3, -2});
  const Room up =
      read(projected(R"("type": "PlanarProjection", "orientation": { "yaw": 0, "pitch": 90, "roll": 0 },
      "fov": { "hfov": 90, "vfov": 90, "distance": 3 })"));
  expectNear(up.walls.at(0).wall.lowerLeft_m, {-3, 3, -3});
  expectNear(up.walls.at(0).wall.upperLeft_m, {-3, 3, 3});
  const Room quaternion = read(projected(R"("type": "PlanarProjection",
      "orientation": { "x": 0, "y": -0.70710678, "z": 0, "w": 0.70710678 },
      "fov": { "hfov": 90, "vfov": 90, "distance": 1 })"));
  EXPECT_LT(glm::distance(quaternion.walls.at(0).wall.lowerLeft_m, glm::dvec3(1, -1, -1)), 1e-7);
}

TEST(SgctFile, NamesWhatIsWrongInAPlanarProjection) {
  const auto says = [](const std::string& rest, const std::string& words) {
    const Room room = read(projected(R"("type": "PlanarProjection", )" + rest));
    ASSERT_FALSE(room.findings.empty()) << rest;
    EXPECT_TRUE(room.hasErrors()) << rest;
    EXPECT_NE(room.findings[0].text.find(words), std::string::npos) << room.findings[0].text;
  };
  says(R"("distance": 1)", "fov is missing");
  says(R"("fov": 80)", "expected an object");
  says(R"("fov": { "hfov": 80 })", "vfov, or down and up, is missing in fov");
  says(R"("fov": { "hfov": 80, "down": 3 })", "vfov, or down and up, is missing in fov");
  says(R"("fov": { "hfov": 180, "vfov": 60 })", "hfov is 180, expected");
  says(R"("fov": { "hfov": 80, "left": 10, "right": -10, "vfov": 60 })", "together are 0 degrees");
  says(R"("fov": { "hfov": 80, "vfov": 60 }, "distance": 0)", "distance is 0, expected");
  says(R"("fov": { "hfov": 80, "vfov": 60 }, "orientation": { "yaw": 1, "pitch": 2 })", "roll is missing");
  says(R"("fov": { "hfov": 80, "vfov": 60 }, "orientation": { "x": 0, "y": 0, "z": 0, "w": 0 })", "length 0");
  says(R"("fov": { "hfov": 80, "vfov": 60 }, "offset": { "x": 0, "y": 0 })", "z is missing in offset");
}

// Parts of a window that meet there meet in pixels, too, whatever its size, and none reaches out.
TEST(SgctFile, SplitWindowsOfOddSizesFit) {
  const auto viewport = [](double x, double y, double width, double height) {
    std::string text = kGood.substr(kGood.find("{\n      \"projection\""));
    text = text.substr(0, text.find("}]\n  }] }]") + 1);
    return text.insert(1, fmt::format(R"("pos": {{ "x": {}, "y": {} }}, "size": {{ "x": {}, "y": {} }},)", x,
                                      y, width, height));
  };
  const std::size_t begin = kGood.find("{\n      \"projection\""), end = kGood.find("}]\n  }] }]") + 1;
  for (const int height : {1, 2, 3, 525, 1079, 1080, 1081}) {
    for (const int parts : {2, 3, 7}) {
      if (height < parts) continue;
      std::string viewports;
      for (int i = 0; i < parts; ++i) {
        const double low = std::round(1e6 * i / parts) / 1e6, high = std::round(1e6 * (i + 1) / parts) / 1e6;
        viewports += (i == 0 ? "" : ", ") + viewport(0, low, 1, high - low);
      }
      std::string text = kGood;
      text.replace(begin, end - begin, viewports);
      text.replace(text.find("\"y\": 720"), 8, fmt::format("\"y\": {}", height));
      const Room room = read(text);
      ASSERT_FALSE(room.hasErrors()) << height << ", " << parts << ": " << room.findings[0].text;
      ASSERT_EQ(room.walls.size(), static_cast<std::size_t>(parts));
      int edge = height;  // from the bottom up
      for (const RoomWall& wall : room.walls) {
        const WindowPlacement& place = wall.wall.window;
        EXPECT_EQ(place.position_px.y + place.size_px.y, edge) << height << " in " << parts;
        EXPECT_EQ(wall.wall.pixels.y, place.size_px.y);
        edge = place.position_px.y;
      }
      EXPECT_EQ(edge, 0) << height << " in " << parts;
    }
  }
  std::string text = kGood;
  text.replace(begin, end - begin, viewport(0, 0.6, 1, 0.5));
  const Room room = read(text);
  ASSERT_TRUE(room.hasErrors());
  EXPECT_NE(room.findings[0].text.find("reaches to (1, 1.1) of its window"), std::string::npos)
      << room.findings[0].text;
}

TEST(SgctFile, RefusesWhatIsNoJson) {
  const std::vector<std::tuple<std::string, int, int>> files{{changed("0.0 },\n", "0/05 },\n"), 8, 52},
                                                             {changed("1280", "1e999"), 4, 49},
                                                             {"{\n  \"a\": [1, 2\n", 3, 1},
                                                             {"", 1, 1},
                                                             {"{} x", 1, 4}};
  for (const auto& [text, line, column] : files) {
    try {
      read(text);
      ADD_FAILURE() << "was taken: " << text;
    } catch (const InputErrors& error) {
      EXPECT_EQ(error.line(), line) << text << ": " << error.what();
      EXPECT_EQ(error.column(), column) << text << ": " << error.what();
    }
  }
  EXPECT_THROW(read(std::string(100000, '[')), InputErrors);
}

TEST(SgctFile, ShippedExamplesOfSgctAreRight) {
  const std::filesystem::path rooms = CAROM_TESTS_DIR "/data/rooms";
  for (const char* name : {"sgct-docs__projectionplane.json", "sgct__config__3DTV.json"}) {
    const Room room = readSgct(rooms / name);
    EXPECT_TRUE(room.findings.empty()) << name << ": " << room.findings[0].text;
    EXPECT_TRUE(judgeRoom(room).empty()) << name << ": " << judgeRoom(room)[0].text;
  }
}

}  // namespace
}  // namespace carom
