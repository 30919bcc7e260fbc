// Spoiled files of calibration programs are refused, or what is taken of them can be drawn.

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "cave/mesh_files/measured_bytes.h"
#include "cave/mesh_files/measured_faults.h"
#include "cave/mesh_files/screen_file.h"
#include "cave/mesh_files/vwf_file.h"
#include "cave/warps/warp_formats.h"
#include "engine/text/outside_file.h"
#include "mutate.h"

namespace carom {
namespace {

using test::kMeshes;
using test::onPlane;

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
