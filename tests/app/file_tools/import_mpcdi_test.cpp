// MPCDI files as rigs with the files that these need, and those that are refused.
#include "app/file_tools/import.h"

#include <gtest/gtest.h>
#include <minizip/zip.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>
#include <vector>

#include "app/program.h"
#include "app/rig/rig.h"
#include "cave/mesh_files/measured_bytes.h"
#include "cave/screen/curved_screen.h"
#include "cave/warps/warp_file.h"
#include "places.h"

namespace carom {
namespace {

using test::contentOf;
using test::runCarom;
using test::TemporaryFolder;

const std::string kRooms = CAROM_TESTS_DIR "/data/rooms/";

/// Makes a zip archive of files with these names; returns its bytes.
std::string zipped(const TemporaryFolder& folder,
                   const std::vector<std::pair<std::string, std::string>>& files) {
  const std::string path = folder / "made.mpcdi";
  zipFile zip = zipOpen64(path.c_str(), APPEND_STATUS_CREATE);
  for (const auto& [name, content] : files) {
    zipOpenNewFileInZip(zip, name.c_str(), nullptr, nullptr, 0, nullptr, 0, nullptr, Z_DEFLATED, 6);
    zipWriteInFileInZip(zip, content.data(), static_cast<unsigned>(content.size()));
    zipCloseFileInZip(zip);
  }
  zipClose(zip, nullptr);
  std::string bytes = contentOf(path);
  std::filesystem::remove(path);
  return bytes;
}

std::string description(const std::string& profile, const std::string& fileset,
                        const std::string& region = "") {
  return "<MPCDI profile=\"" + profile +
         "\" version=\"1.0\">\n<display><buffer id=\"a\" xResolution=\"800\" yResolution=\"400\">"
         "<region id=\"one\" xResolution=\"400\" yResolution=\"400\" x=\"0\" y=\"0\" xsize=\"0.5\" "
         "ysize=\"1\">" +
         region + "</region></buffer></display>\n<files><fileset region=\"one\">" + fileset +
         "</fileset></files></MPCDI>";
}

std::string warp(const std::string& path) {
  return "<geometryWarpFile><path>" + path +
         "</path><geometricUnit>m</geometricUnit><originof3DData>floorCenter</originof3DData></"
         "geometryWarpFile>";
}

const std::string kFrustum =
    "<frustum><yaw>90</yaw><pitch>0</pitch><roll>0</roll><rightAngle>45</rightAngle><leftAngle>-45</"
    "leftAngle>"
    "<upAngle>30</upAngle><downAngle>-20</downAngle></frustum>";

TEST(ImportMpcdi, AMeasuredCylinderBecomesAScreen) {
  const TemporaryFolder folder;
  const std::string rig = folder / "arc.toml";
  const auto made = runCarom(folder, {"import", kRooms + "cylinder_a3.mpcdi", "-o", rig});
  ASSERT_EQ(made.status, 0) << made.err;
  const Rig read = readRig(rig);
  ASSERT_EQ(read.walls.size(), 1U);
  const Wall& wall = read.walls[0];
  ASSERT_TRUE(wall.screen);
  EXPECT_EQ(wall.pixels, glm::ivec2(1940, 660));
  EXPECT_EQ(wall.blend.extension(), ".png");
  for (const glm::dvec2& at : {glm::dvec2(0.0, 0.0), {0.5, 0.5}, {1.0, 1.0}, {0.31, 0.77}}) {
    const double angle = (at.x - 0.5) * 2.0 / 3.0 * std::numbers::pi;
    const auto place_m = inRoom_m(wall.screen->mesh, at);
    ASSERT_TRUE(place_m) << at.x << " " << at.y;
    EXPECT_LT(glm::distance(*place_m, {3.0 * std::sin(angle), 2.4 * at.y, -3.0 * std::cos(angle)}), 5e-4);
  }
  EXPECT_FALSE(inRoom_m(wall.screen->mesh, {0.02, 0.95})) << "there is no screen";
  const auto checked = runCarom(folder, {"check", rig});
  EXPECT_EQ(checked.status, 0) << checked.err;
  EXPECT_EQ(checked.err, "");
  // Nothing is written over what is there.
  const auto entries = folder.entries();
  std::filesystem::remove(rig);
  const auto again = runCarom(folder, {"import", kRooms + "cylinder_a3.mpcdi", "-o", rig});
  EXPECT_EQ(again.status, 1);
  EXPECT_NE(again.err.find("is there already"), std::string::npos) << again.err;
  EXPECT_EQ(folder.entries(), entries - 1);
}

TEST(ImportMpcdi, FlatPicturesAreRightFromOnePlace) {
  const TemporaryFolder folder;
  // The picture's lower half, from its lower left.
  const std::string half =
      test::pfmBytes(20, 20, [](const glm::dvec2& at) { return glm::dvec3(at.x, 0.5 * at.y, 0.0); });
  folder.file("half.pfm", half);
  for (const std::string profile : {"2d", "3d"}) {
    const std::string rig = folder / (profile + ".toml");
    const auto made = runCarom(
        folder, {"import",
                 folder.file(profile + ".mpcdi.xml",
                             description(profile, warp("half.pfm"), profile == "3d" ? kFrustum : "")),
                 "-o", rig});
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_NE(made.err.find("is right from one place only"), std::string::npos) << made.err;
    const Rig read = readRig(rig);
    const Wall& wall = read.walls.at(0);
    const Warp mesh = readWarp(wall.warp, wall.pixels);
    for (const WarpPoint& point : mesh.left.points)
      EXPECT_LT(glm::distance(point.inPicture, point.inWindow * glm::vec2(1.0F, 0.5F)), 1e-6F);
    const glm::dvec3 across = wall.lowerRight_m - wall.lowerLeft_m, up = wall.upperLeft_m - wall.lowerLeft_m;
    if (profile == "3d") {  // 3 m to the right, seen from the point of the frustum at the eyes
      EXPECT_NEAR(wall.lowerLeft_m.x, 3.0, 1e-5);
      EXPECT_NEAR(across.z, 6.0, 1e-5);
      EXPECT_NEAR(up.y, 3.0 * (std::tan(std::numbers::pi / 6.0) + std::tan(std::numbers::pi / 9.0)), 1e-5);
    } else {
      EXPECT_NEAR(across.x, 2.0, 1e-5);
      EXPECT_NEAR(up.y, 2.0, 1e-5);
    }
  }
}

struct Bad {
  const char* what;
  std::string bytes;
  std::string said;
};

TEST(ImportMpcdi, WhatIsWrongIsNamedAndNothingIsWritten) {
  const TemporaryFolder folder;
  const std::string a3 = description("a3", warp("../secret.pfm"));
  const std::string good = description("a3", warp("arc.pfm"));
  const std::string arc = test::pfmBytes(16, 8, [](const glm::dvec2& at) {
    return glm::dvec3(3.0 * std::sin(at.x), 2.0 * at.y, -3.0 * std::cos(at.x));
  });
  std::string bomb = zipped(folder, {{"mpcdi.xml", good}, {"arc.pfm", arc}});
  const std::size_t central = bomb.find("PK\x01\x02", bomb.find("PK\x01\x02") + 4);
  std::string huge;
  test::put(huge, 0x7fffffffU);
  bomb.replace(central + 24, 4, huge);
  std::string png("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\1\x86\xa0\0\1\x86\xa0\x08\0\0\0\0\0\0\0\0", 33);
  const std::string alpha = "<alphaMap><path>a.png</path><gammaEmbedded>1</gammaEmbedded></alphaMap>";
  const std::vector<Bad> all{
      {"poses alone", description("sl", ""), "no surface to draw on"},
      {"no profile", description("x9", ""), "the profile is 'x9'"},
      {"a name that leads out", a3, "the name '../secret.pfm' leads out of the folder"},
      {"an absolute name", description("a3", warp("/etc/passwd")),
       "the name '/etc/passwd' leads out of the folder"},
      {"no file", good, "there is no such file"},
      {"no zip", "PK\x03\x04 nothing", "this is no zip archive"},
      {"a zip that leads out", zipped(folder, {{"mpcdi.xml", good}, {"../arc.pfm", arc}}),
       "the archive holds '../arc.pfm', which leads out of it"},
      {"a zip from the root", zipped(folder, {{"mpcdi.xml", good}, {"/tmp/arc.pfm", arc}}),
       "the archive holds '/tmp/arc.pfm', which leads out of it"},
      {"a zip without a description", zipped(folder, {{"arc.pfm", arc}}), "the archive has no mpcdi.xml"},
      {"a bomb", bomb, "the archive unpacks to more than 256 MiB, with 'arc.pfm'"},
      {"a large picture",
       zipped(folder,
              {{"mpcdi.xml", description("a3", warp("arc.pfm") + alpha)}, {"arc.pfm", arc}, {"a.png", png}}),
       "'a.png': the picture has 100000 × 100000 pixels"},
      {"no picture",
       zipped(folder,
              {{"mpcdi.xml", description("a3", warp("arc.pfm") + alpha)}, {"arc.pfm", arc}, {"a.png", arc}}),
       "the picture is no PNG"},
      {"a short grid", zipped(folder, {{"mpcdi.xml", good}, {"arc.pfm", arc.substr(0, 100)}}),
       "16 × 8 points take"},
  };
  for (const Bad& bad : all) {
    const std::string file = folder.file("bad.mpcdi", bad.bytes);
    const auto made = runCarom(folder, {"import", file, "-o", folder / "rig.toml"});
    EXPECT_EQ(made.status, 1) << bad.what;
    EXPECT_NE(made.err.find(bad.said), std::string::npos) << bad.what << ": " << made.err;
    EXPECT_NE(made.err.find("bad.mpcdi:"), std::string::npos) << bad.what << ": " << made.err;
    EXPECT_EQ(folder.entries(), 1) << bad.what;
  }
}

}  // namespace
}  // namespace carom
