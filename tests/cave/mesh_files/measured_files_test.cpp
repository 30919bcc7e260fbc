// Files of calibration programs: what is right is read, what is not is named with its place.
#include "cave/mesh_files/screen_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <zlib.h>
#include <glm/geometric.hpp>

#include "app/temporary_folder.h"
#include "cave/mesh_files/measured_bytes.h"
#include "cave/mesh_files/vwf_file.h"
#include "cave/mesh_files/warp_file.h"
#include "cave/mesh_files/warp_formats.h"
#include "engine/base/outside_file.h"
#include "mutate.h"
#include "places.h"

namespace carom {
namespace {

const std::string kMeshes = CAROM_TESTS_DIR "/data/rooms/meshes/";
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

glm::dvec3 onPlane(const glm::dvec2& inWindow) { return {2.0 * inWindow.x - 1.0, inWindow.y, -2.0}; }

template <class Reader>
std::string complaint(const Reader& read) {
  try {
    read();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing is wrong";
}

void expectSaid(const std::string& heard, const std::string& said) {
  EXPECT_NE(heard.find(said), std::string::npos) << said << "\n" << heard;
}

/// Puts a number into bytes, little-endian.
std::string with(std::string bytes, std::size_t at, std::uint32_t value) {
  std::string raw;
  test::put(raw, value);
  return bytes.replace(at, 4, raw);
}

// One dome channel, measured once, as three programs wrote it.
TEST(WarpFiles, ThreeFormatsOfOneChannelAgree) {
  const Warp csv = readWarp(kMeshes + "channel1_warp_mesh.csv", {2560, 1600}),
             simcad = readWarp(kMeshes + "channel1_warp.simcad", {2560, 1600}),
             sgc = readWarp(kMeshes + "channel1_warp_u2.sgc", {2560, 1600});
  ASSERT_EQ(csv.left.points.size(), 33U * 33U);
  double worst = 0.0;
  for (const Warp* other : {&simcad, &sgc}) {
    ASSERT_EQ(other->left.points.size(), csv.left.points.size());
    EXPECT_EQ(other->left.triangles, csv.left.triangles);
    for (std::size_t i = 0; i < csv.left.points.size(); ++i) {
      const WarpPoint &a = csv.left.points[i], &b = other->left.points[i];
      worst = std::max<double>(
          {worst, glm::distance(a.inWindow, b.inWindow), glm::distance(a.inPicture, b.inPicture)});
    }
  }
  std::printf("the three files differ by %.2g of the window\n", worst);
  EXPECT_LT(worst, 1e-5);
  // The file's first point, from the upper left.
  EXPECT_LT(glm::distance(csv.left.points[0].inWindow, glm::vec2(0.193988F, 1.0F - 0.031005F)), 1e-6F);
  EXPECT_EQ(csv.left.points[0].inPicture, glm::vec2(0.0F, 1.0F));
}

TEST(WarpFiles, WrongOnesAreRefusedWithTheirPlace) {
  const std::string head = "x;y;u;v;column;row\n0;0;0;0;0;0\n1;0;1;0;1;0\n";
  expectSaid(complaint([] {
               readWarp(kMeshes + "channel1_warp_frustum.csv", {1, 1});
             }),
             "1:1: this is the frustum of a projector, expected a mesh");
  expectSaid(complaint([] { parseCsvWarp(""); }), "1:1: there is no line");
  expectSaid(complaint([&] { parseCsvWarp(head); }), "4:1: there are 2 points in rows of 2");
  expectSaid(complaint([&] { parseCsvWarp(head + "0;nan;0;1;0;1\n"); }), "4:3: 'nan' is wrong");
  expectSaid(complaint([&] { parseCsvWarp(head + "0;1;0;1;1;1\n"); }),
             "4:1: the point is of column 1, row 1, expected column 0, row 1");
  expectSaid(complaint([] { parseSimcadWarp("<GeometryFile/>"); }), "1:1: there is no <X-FlatParameters>");
  expectSaid(complaint([] {
               parseSimcadWarp(
                   "<G>\n<X-FlatParameters range='8'>0 0 0 0</X-FlatParameters>"
                   "<Y-FlatParameters range='8'>0 0 x 0</Y-FlatParameters></G>");
             }),
             "2:55: number 3 of <Y-FlatParameters> is wrong");
  expectSaid(complaint([] {
               parseSimcadWarp(
                   "<G><X-FlatParameters range='8'>0 0 0</X-FlatParameters>"
                   "<Y-FlatParameters range='8'>0 0 0</Y-FlatParameters></G>");
             }),
             "there are 3 numbers for x and 3 for y");
  expectSaid(complaint([] { parseSimcadWarp("<!DOCTYPE a [<!ENTITY b 'c'>]><a/>"); }),
             "declares a document type");
  expectSaid(complaint([] { parseSimcadWarp("<a>"); }), "this is no XML");
  const std::string sgc = contentOf(kMeshes + "channel1_warp_u2.sgc", InputKind::warp);
  expectSaid(complaint([&] { parseSgcWarp("SGD"); }), "1:1: this is no mesh of SCISS");
  expectSaid(complaint([&] { parseSgcWarp(with(sgc, 52, 0x7fffffff)); }), "vertices are told at byte 52");
  expectSaid(complaint([&] { parseSgcWarp(with(sgc, 60, 0x7fc00000)); }), "vertex 0 has nan, at byte 60");
  expectSaid(complaint([&] { parseSgcWarp(with(sgc, 60 + 24 * 33 * 33 + 4, 1089)); }),
             "index 1089 at byte 26200 is none of the 1089 vertices");
  expectSaid(complaint([&] { parseSgcWarp(sgc.substr(0, sgc.size() - 1)); }), "2080 indices are told");
  expectSaid(complaint([&] { parseSgcWarp(sgc.substr(0, 20)); }), "ends early");
  expectSaid(complaint([] {
               parseBourkeWarp("2\n2 2\n-1 -1 0 0 1\n", {1, 1});
             }),
             "4:1: the file ends early, expected 2 × 2 points, of which there are 1");
  expectSaid(complaint([] { parseBourkeWarp("2\n1 2\n", {1, 1}); }), "2:1: '1' is wrong, expected columns");
}

TEST(WarpFiles, BourkesMeshHasTheWindowsAspectAndLight) {
  const std::string text =
      "2\n3 2\n-2 -1 0 0 1\n0 -1 0.5 0 0.5\n2 -1 1 0 1\n-2 1 0 1 1\n0 1 0.5 1 0.5\n2 1 1 1 -1\n";
  const Warp warp = parseBourkeWarp(text, {1600, 800});
  ASSERT_EQ(warp.left.points.size(), 6U);
  EXPECT_EQ(warp.left.points[0].inWindow, glm::vec2(0.0F));
  EXPECT_EQ(warp.left.points[4].inWindow, glm::vec2(0.5F, 1.0F));
  EXPECT_EQ(warp.left.points[1].light, 0.5F);
  EXPECT_EQ(warp.left.triangles.size(), 2U) << "the cell with the point below 0 is not drawn";
}

TEST(ScreenFiles, AnObjHasPlacesOfTheRoomAndOfTheWindow) {
  const ScreenMesh mesh = parseObjScreen(test::objText(3, 2, onPlane));
  ASSERT_EQ(mesh.size(), 12U);
  for (const glm::dvec2& place : {glm::dvec2(0.1, 0.9), glm::dvec2(0.5, 0.5), glm::dvec2(1.0, 0.0)}) {
    const auto at_m = inRoom_m(mesh, place);
    ASSERT_TRUE(at_m);
    EXPECT_LT(glm::distance(*at_m, onPlane(place)), 1e-8);
  }
}

TEST(ScreenFiles, APfmCountsFromItsRowsEdge) {
  const std::string bytes = test::pfmBytes(
      4, 3, [](const glm::dvec2& at) { return at.x < 0.2 && at.y > 0.8 ? glm::dvec3(kNaN) : onPlane(at); });
  const ScreenGrid fromBottom = parsePfmScreen(bytes, GridRows::fromBottom),
                   fromTop = parsePfmScreen(bytes, GridRows::fromTop);
  EXPECT_LT(glm::distance(glm::dvec3(fromBottom.at(1, 0)), onPlane({1.5 / 4, 0.5 / 3})), 1e-6);
  EXPECT_LT(glm::distance(glm::dvec3(fromTop.at(1, 2)), onPlane({1.5 / 4, 0.5 / 3})), 1e-6);
  EXPECT_TRUE(std::isnan(fromBottom.at(0, 2).x));
  EXPECT_TRUE(std::isnan(fromTop.at(0, 0).x));
}

TEST(ScreenFiles, WrongOnesAreRefusedWithTheirPlace) {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n";
  expectSaid(complaint([&] { parseObjScreen(triangle); }), "1:1: the window shows 1 triangle, expected two");
  expectSaid(complaint([] { parseObjScreen("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"); }),
             "4:3: '1' is wrong, expected both v and vt");
  expectSaid(complaint([] { parseObjScreen("v 0 nan 0\n"); }), "1:5: 'nan' is wrong");
  expectSaid(complaint([] { parseObjScreen("vt 0 -0.5\n" + test::objText(1, 1, onPlane)); }),
             "vt 1 is 0 -0.5, outside");
  std::string many;
  for (std::size_t i = 0; i <= kMostMeshPoints; ++i) many += "v 0 0 0\n";
  expectSaid(complaint([&] { parseObjScreen(many); }), "1000001:1: there are more than 1000000 v");
  expectSaid(complaint([] { parsePfmScreen("PF\n1 1\n-1\n" + std::string(12, '\0'), GridRows::fromBottom); }),
             "2:1: '1' is wrong, expected a number of columns from 2");
  expectSaid(complaint([] {
               parsePfmScreen(test::pfmBytes(4, 4, [](const glm::dvec2&) { return glm::dvec3(kNaN); }),
                              GridRows::fromBottom);
             }),
             "no four neighbours of the 4 × 4 points are on a screen");
  expectSaid(complaint([] {
               parsePfmScreen(test::pfmBytes(2, 2, [](const glm::dvec2&) { return glm::dvec3(1e10); }),
                              GridRows::fromBottom);
             }),
             "point (0, 0) has 1e+10, at byte 12");
}

TEST(VwfFiles, AScreenIsReadPackedOrNotAloneOrInAContainer) {
  const auto place = [](const glm::dvec2& at) { return at.x > 0.7 ? glm::dvec3(kNaN) : onPlane(at); };
  const std::string plain = test::vwfBytes(5, 4, place);
  std::string packed(compressBound(5 * 4 * 16), '\0');
  uLongf length = packed.size();
  ASSERT_EQ(compress(reinterpret_cast<Bytef*>(packed.data()), &length,
                     reinterpret_cast<const Bytef*>(plain.data() + 380), plain.size() - 380),
            Z_OK);
  packed.resize(length);
  std::string zipped =
      with(with(plain.substr(0, 380), 8, 0x41), 16, static_cast<std::uint32_t>(length)) + packed;
  std::string container = "vwf1";
  for (const std::uint32_t value : {1U, 16U, 0U}) test::put(container, value);
  for (const std::string& bytes : {plain, zipped, container + plain}) {
    const VwfFile file = parseVwf(bytes);
    EXPECT_TRUE(file.isScreen);
    const ScreenGrid grid = screenGridOf(file);
    ASSERT_EQ(grid.columns, 5);
    EXPECT_LT(glm::distance(glm::dvec3(grid.at(0, 3)), 1e3 * onPlane({0.1, 3.5 / 4})), 1e-3);
    EXPECT_TRUE(std::isnan(grid.at(4, 0).x));
  }
}

TEST(VwfFiles, TheLightFollowsThePlaces) {
  // A BMP of 2 × 1 pixels, blue first, its row filled to four bytes.
  std::string bitmap = "BM";
  for (const std::uint32_t value : {62U, 0U, 54U, 40U, 2U, 1U, 24U << 16U | 1U, 0U, 0U, 0U, 0U, 0U, 0U})
    test::put(bitmap, value);
  bitmap += std::string("\x00\x40\x80\xff\xff\xff\x00\x00", 8);
  const VwfFile file = parseVwf(test::vwfBytes(3, 2, onPlane, 1.0, 0, bitmap));
  EXPECT_EQ(file.blend_px, glm::ivec2(2, 1));
  EXPECT_EQ(file.blend, (std::vector<std::uint16_t>{0x8080, 0x4040, 0, 0xffff, 0xffff, 0xffff}));
  std::string shares;
  for (int i = 0; i < 4 * 2 * 2; ++i) test::put(shares, i < 8 ? 0.5F : 2.0F);
  const VwfFile light = parseVwf(test::vwfBytes(2, 2, onPlane, 1.0, 0x200, shares));
  EXPECT_EQ(light.blend.at(0), 65535) << "the bottom row is the second one, limited to all light";
  EXPECT_EQ(light.blend.at(6), 32768);
}

TEST(VwfFiles, AWarpIsWrittenAndReadAgain) {
  const std::vector<glm::vec2> places{{0.1F, 0.2F}, {0.9F, 0.2F}, {NAN, NAN},
                                      {0.1F, 0.8F}, {0.9F, 0.8F}, {1, 1}};
  const VwfFile file = parseVwf(vwfOf({3, 2}, places));
  EXPECT_FALSE(file.isScreen);
  const Warp warp = warpOf(file);
  EXPECT_EQ(warp.left.triangles.size(), 2U);
  EXPECT_EQ(warp.left.points[0].inPicture, glm::vec2(0.1F, 0.8F));
  EXPECT_EQ(warp.left.points[4].inWindow, glm::vec2(0.5F, 0.25F));
}

TEST(VwfFiles, WrongOnesAreRefusedWithTheirPlace) {
  const std::string whole = test::vwfBytes(3, 2, onPlane);
  expectSaid(complaint([&] { parseVwf("vwf"); }), "there is no vwf0 at byte 0");
  expectSaid(complaint([&] { parseVwf(with(whole, 20, 16000)); }),
             "16000 × 2 points take 512000 bytes at byte 380");
  expectSaid(complaint([&] { parseVwf(with(whole, 20, 0xffffffff)); }), "the grid has 4294967295 × 2 points");
  expectSaid(complaint([&] { parseVwf(with(whole, 24, 1)); }), "the grid has 3 × 1 points");
  expectSaid(complaint([&] { parseVwf(with(whole, 4, 1U << 30U)); }), "the header has 1073741824 bytes");
  expectSaid(complaint([&] { parseVwf(with(with(with(whole, 8, 0x41), 20, 16384), 24, 16384)); }),
             "cannot hold");
  expectSaid(complaint([&] { parseVwf(with(whole, 8, 0x41)); }), "the packed points at byte 380 are broken");
  expectSaid(complaint([&] { warpOf(parseVwf(whole)); }), "the file has a screen");
  std::string several = "vwf1";
  for (const std::uint32_t value : {3U, 16U, 0U}) test::put(several, value);
  expectSaid(complaint([&] { parseVwf(several + whole); }), "the file has 3 displays");
}

// What is taken of spoiled files can be drawn: every index exists, every number is near.
TEST(MeasuredFiles, SpoiledOnesAreRefusedOrSound) {
  constexpr unsigned kSeed = 11;
  std::mt19937_64 random(kSeed);
  const std::string csv = "x;y;u;v;column;row\n0;0;0;0;0;0\n1;0;1;0;1;0\n0;1;0;1;0;1\n1;1;1;1;1;1\n";
  const std::vector<std::string> all{
      csv,
      contentOf(kMeshes + "channel1_warp_u2.sgc", InputKind::warp).substr(0, 400),
      "2\n2 2\n-1 -1 0 0 1\n1 -1 1 0 1\n-1 1 0 1 1\n1 1 1 1 1\n",
      test::vwfBytes(4, 3, onPlane),
      test::pfmBytes(4, 3, onPlane),
      test::objText(2, 2, onPlane),
      "<G><X-FlatParameters range='8'>0 0 0 0</X-FlatParameters>"
      "<Y-FlatParameters range='8'>0 0 0 0</Y-FlatParameters></G>"};
  int refused = 0, read = 0;
  for (int round = 0; round < 7000; ++round) {
    const std::size_t kind = static_cast<std::size_t>(round) % all.size();
    const auto bytes = [](const std::string& text) { return test::Bytes(text.begin(), text.end()); };
    const test::Bytes spoiled = test::mutated(bytes(all[kind]), bytes(all[(kind + 1) % all.size()]), random);
    const std::string content(spoiled.begin(), spoiled.end());
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", round " + std::to_string(round));
    try {
      Warp warp;
      if (kind == 0) warp = parseCsvWarp(content);
      if (kind == 1) warp = parseSgcWarp(content);
      if (kind == 2) warp = parseBourkeWarp(content, {4, 3});
      if (kind == 6) warp = parseSimcadWarp(content);
      if (kind == 3) screenGridOf(parseVwf(content));
      if (kind == 4) parsePfmScreen(content, GridRows::fromTop);
      if (kind == 5) parseObjScreen(content);
      for (const auto& corners : warp.left.triangles) {
        for (const std::uint32_t corner : corners) ASSERT_LT(corner, warp.left.points.size());
      }
      for (const WarpPoint& point : warp.left.points) ASSERT_LE(glm::length(point.inWindow), 60.0F);
      ++read;
    } catch (const std::runtime_error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000);
  EXPECT_GT(read, 500);
}

}  // namespace
}  // namespace carom
