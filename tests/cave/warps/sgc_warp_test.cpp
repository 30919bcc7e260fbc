// Meshes of projectors as SCISS writes them.
#include "cave/warps/warp_formats.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "cave/mesh_files/measured_faults.h"
#include "engine/text/outside_file.h"

namespace carom {
namespace {

using test::complaint;
using test::expectSaid;
using test::kMeshes;
using test::with;

TEST(WarpFiles, WrongOnesOfScissAreRefusedWithTheirPlace) {
  const std::string sgc = contentOf(kMeshes + "channel1_warp_u2.sgc", InputKind::warp);
  expectSaid(complaint([&] { parseSgcWarp("SGD"); }), "1:1: this is no mesh of SCISS");
  expectSaid(complaint([&] { parseSgcWarp(with(sgc, 52, 0x7fffffff)); }), "vertices are told at byte 52");
  expectSaid(complaint([&] { parseSgcWarp(with(sgc, 60, 0x7fc00000)); }), "vertex 0 has nan, at byte 60");
  expectSaid(complaint([&] { parseSgcWarp(with(sgc, 60 + 24 * 33 * 33 + 4, 1089)); }),
             "index 1089 at byte 26200 is none of the 1089 vertices");
  expectSaid(complaint([&] { parseSgcWarp(sgc.substr(0, sgc.size() - 1)); }), "2080 indices are told");
  expectSaid(complaint([&] { parseSgcWarp(sgc.substr(0, 20)); }), "ends early");
}

/// The bytes of a mesh of this version: points at x, y of the window and u, v of the picture, then indices.
std::string sgcOf(char version, const std::array<std::uint32_t, 2>& size,
                  const std::vector<std::array<float, 4>>& points,
                  const std::vector<std::uint32_t>& indices) {
  std::string bytes = std::string("SGC") + version;
  for (int i = 0; i < 12; ++i) test::put(bytes, 0U);  // its type, and angles
  for (const std::uint32_t count : size) test::put(bytes, count);
  for (const auto& [x, y, u, v] : points)
    for (const float value : {x, y, 0.0F, u, v, 0.0F}) test::put(bytes, value);
  test::put(bytes, static_cast<std::uint32_t>(indices.size()));
  for (const std::uint32_t index : indices) test::put(bytes, index);
  return bytes;
}

// A grid, a list and a strip; windows are told from the upper left, pictures from the lower left. A strip's
// triangles without an area join its parts and are left out.
TEST(WarpFiles, AMeshOfScissIsAGridAListOrAStrip) {
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;
  const std::vector<std::array<float, 4>> four{
      {0.25F, 0.125F, 0.0F, 1.0F}, {1.0F, 0.0F, 1.0F, 1.0F}, {0.0F, 1.0F, 0.0F, 0.0F}, {1, 1, 1, 0}};
  const Warp grid = parseSgcWarp(sgcOf(1, {2, 2}, four, {})),
             list = parseSgcWarp(sgcOf(2, {0, 4}, four, {0, 2, 1, 1, 2, 3})),
             strip = parseSgcWarp(sgcOf(2, {0, 4}, four, {0, 2, 1, 3, 3}));
  EXPECT_EQ(grid.left.points.at(0).inWindow, glm::vec2(0.25F, 0.875F));
  EXPECT_EQ(grid.left.points.at(0).inPicture, glm::vec2(0.0F, 1.0F));
  EXPECT_EQ(grid.left.triangles.size(), 2U);
  EXPECT_EQ(list.left.triangles, (Triangles{{0, 2, 1}, {1, 2, 3}}));
  EXPECT_EQ(strip.left.triangles, (Triangles{{0, 2, 1}, {2, 1, 3}}));
}

}  // namespace
}  // namespace carom
