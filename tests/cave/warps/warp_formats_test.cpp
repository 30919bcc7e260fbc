// Projectors' meshes as OBJ and PFM: what is right is read, what is not is named with its place.
#include "cave/warps/warp_formats.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "cave/warps/some_keystone.h"
#include "mutate.h"

namespace carom {
namespace {

using test::kObj;

std::string bytesOf(const std::vector<float>& values, bool bigEndian = false) {
  std::string bytes;
  for (const float value : values) {
    std::array<char, 4> raw = std::bit_cast<std::array<char, 4>>(value);
    if (bigEndian) std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
  }
  return bytes;
}

/// Two eyes with 2 × 2 points each; the right eye's are 0.25 higher.
std::vector<float> twoByTwo() {
  return {0.1F, 0.9F, 0, 0.8F, 0.9F, 0, 0.1F, 1.15F, 0, 0.8F, 1.15F, 0,  //
          0.2F, 0.3F, 0, 0.7F, 0.3F, 0, 0.2F, 0.55F, 0, 0.7F, 0.55F, 0};
}
const std::string kHeader = "PF\n4 2\n-1.0\n";

std::string complaint(Warp (*parse)(std::string_view), const std::string& content) {
  try {
    parse(content);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing is wrong";
}

TEST(WarpFormats, PfmHasAGridForEachEyeFromThePicturesTop) {
  for (const bool bigEndian : {false, true}) {
    const Warp warp = parsePfmWarp((bigEndian ? "PF\n4 2\n1.0\n" : kHeader) + bytesOf(twoByTwo(), bigEndian));
    ASSERT_EQ(warp.left.points.size(), 4U);
    ASSERT_EQ(warp.right.points.size(), 4U);
    EXPECT_EQ(warp.left.points[0].inPicture, glm::vec2(0.25F, 0.75F));  // the upper left
    EXPECT_EQ(warp.left.points[0].inWindow, glm::vec2(0.1F, 0.9F));
    EXPECT_EQ(warp.left.points[3].inPicture, glm::vec2(0.75F, 0.25F));
    EXPECT_EQ(warp.left.points[3].inWindow, glm::vec2(0.7F, 0.3F));
    EXPECT_EQ(warp.right.points[3].inPicture, glm::vec2(0.75F, 0.25F));
    EXPECT_EQ(warp.right.points[3].inWindow, glm::vec2(0.7F, 0.55F));
    EXPECT_EQ(warp.left.triangles.size(), 2U);
  }
}

TEST(WarpFormats, ObjPairsPlacesAndCutsPolygons) {
  const Warp warp = parseObjWarp(kObj);
  ASSERT_EQ(warp.left.points.size(), 4U);
  EXPECT_EQ(warp.left.points[2].inWindow, glm::vec2(0.75F, 1.0F));
  EXPECT_EQ(warp.left.points[2].inPicture, glm::vec2(1.0F, 1.0F));
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;
  EXPECT_EQ(warp.left.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(warp.right.triangles, warp.left.triangles);
}

struct Fault {
  std::string content;
  std::string said;
};

TEST(WarpFormats, WrongPfmsAreRefusedWithTheirPlace) {
  std::vector<float> notANumber = twoByTwo(), far = twoByTwo();
  notANumber[13] = std::numeric_limits<float>::quiet_NaN();
  far[3] = 100.0F;
  const std::string grid = bytesOf(twoByTwo());
  for (const auto& [content, said] : {
           Fault{"", "1:1: the header ends early"},
           Fault{"Pf\n4 2\n-1\n" + grid, "1:1: 'Pf' is wrong, expected PF, three floats"},
           Fault{"P6\n4 2\n-1\n" + grid, "1:1: 'P6' is wrong"},
           Fault{"PF\n5 2\n-1\n" + grid, "2:1: '5' is wrong, expected an even number of columns"},
           Fault{"PF\n4 1\n-1\n" + grid, "2:3: '1' is wrong, expected a number of rows from 2"},
           Fault{"PF\n4\n-1\n" + grid, "2:2: something is missing here"},
           Fault{"PF\n4 2 9\n-1\n" + grid, "2:5: '9' is wrong, expected the line's end"},
           Fault{"PF\n4 2\n0\n" + grid, "3:1: '0' is wrong, expected a scale"},
           Fault{"PF\n4 2\nnan\n" + grid, "3:1: 'nan' is wrong"},
           Fault{"PF\n4 2", "3:1: the header ends early"},
           Fault{"PF\n-4 2\n-1\n" + grid, "2:1: '-4' is wrong"},
           Fault{"PF\n4294967296 4294967296\n-1\n" + grid, "2:1: '4294967296' is wrong"},
           Fault{"PF\n1000000 1000000\n-1\n" + grid, "take 12000000000000 bytes behind the header"},
           Fault{kHeader + grid.substr(1), "4 × 2 points take 96 bytes behind the header, but there are 95"},
           Fault{kHeader + grid + "x", "but there are 97"},
           Fault{kHeader + bytesOf(notANumber), "point (0, 1) has nan for its y in the window, at byte 64"},
           Fault{kHeader + bytesOf(far), "point (1, 0) has 100 for its x"},
       }) {
    const std::string heard = complaint(parsePfmWarp, content);
    EXPECT_NE(heard.find(said), std::string::npos) << said << "\n" << heard;
  }
}

TEST(WarpFormats, WrongObjsAreRefusedWithTheirPlace) {
  for (const auto& [content, said] : {
           Fault{"", "there is no f, expected a triangle at least"},
           Fault{"v 0 0\nv 1 0\nv 0 1\nvt 0 0\nvt 1 0\nf 1 2 3\n", "there are 3 v and 2 vt"},
           Fault{"v 0 nan 0\n", "1:5: 'nan' is wrong, expected a number from -16 to 16"},
           Fault{"vt 0 inf\n", "1:6: 'inf' is wrong"},
           Fault{"v 0 1e30\n", "1:5: '1e30' is wrong"},
           Fault{"\nv 0 0.5x 0\n", "2:5: '0.5x' is wrong"},
           Fault{"v 0\n", "1:4: something is missing here, expected a number"},
           Fault{kObj + "f 1 2 5\n", "14:1: corner 5 is none of the 4 points"},
           Fault{kObj + "f 1 2\n", "14:6: something is missing here, expected a corner"},
           Fault{kObj + "f 0 1 2\n", "14:3: '0' is wrong, expected a corner, counted from 1"},
           Fault{kObj + "f -1 -2 -3\n", "14:3: '-1' is wrong"},
           Fault{kObj + "f 99999999999999999999 2 3\n", "14:3: '99999999999999999999' is wrong"},
           Fault{kObj + "f 1/2 2/1 3/3\n", "14:3: '1/2' is wrong, expected the same number for v and vt"},
           Fault{kObj + "\x01\x02 2\n",
                 "14:1: '?"
                 "?' is wrong"},
       }) {
    const std::string heard = complaint(parseObjWarp, content);
    EXPECT_NE(heard.find(said), std::string::npos) << said << "\n" << heard;
  }
}

/// What was read can be drawn: every index exists, every number is near.
void expectSound(const WarpMesh& mesh) {
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) ASSERT_LT(corner, mesh.points.size());
  }
  for (const auto& [inWindow, inPicture, weight, light] : mesh.points) {
    EXPECT_EQ(weight, 1.0F);  // files tell no other
    EXPECT_EQ(light, 1.0F);
    for (const float value : {inWindow.x, inWindow.y, inPicture.x, inPicture.y})
      ASSERT_LE(std::abs(value), 16.0F);
  }
}

TEST(WarpFormats, SpoiledFilesAreRefusedOrSound) {
  constexpr unsigned kSeed = 7;
  std::mt19937_64 random(kSeed);
  const std::string pfm = kHeader + bytesOf(twoByTwo());
  int refused = 0, read = 0;
  for (int i = 0; i < 20000; ++i) {
    const bool isPfm = i % 2 == 0;
    const auto bytes = [](const std::string& text) { return test::Bytes(text.begin(), text.end()); };
    const test::Bytes spoiled = test::mutated(bytes(isPfm ? pfm : kObj), bytes(isPfm ? kObj : pfm), random);
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", round " + std::to_string(i));
    try {
      const std::string content(spoiled.begin(), spoiled.end());
      const Warp warp = isPfm ? parsePfmWarp(content) : parseObjWarp(content);
      expectSound(warp.left);
      expectSound(warp.right);
      ++read;
    } catch (const std::runtime_error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000);
  EXPECT_GT(read, 1000);
}

}  // namespace
}  // namespace carom
