// Screens and warps in files of VIOSO.
#include "cave/mesh_files/vwf_file.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "cave/mesh_files/measured_bytes.h"
#include "cave/mesh_files/measured_faults.h"

namespace carom {
namespace {

using test::complaint;
using test::expectSaid;
using test::kNaN;
using test::onPlane;
using test::with;

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

}  // namespace
}  // namespace carom
