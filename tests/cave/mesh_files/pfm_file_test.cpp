// PFM: a grid with three floats a point.
#include "cave/mesh_files/pfm_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>

#include "cave/mesh_files/measured_faults.h"

namespace carom {
namespace {

using test::complaint;

/// The number of a part of a point.
float numberOf(std::size_t column, std::size_t row, int part) {
  return static_cast<float>(100 * row + 10 * column) + 0.25F * static_cast<float>(part);
}

std::string gridOf(std::size_t columns, std::size_t rows, bool isBigEndian) {
  std::string bytes;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      for (int part = 0; part < 3; ++part) {
        std::string raw;
        test::put(raw, numberOf(column, row, part));
        if (isBigEndian) std::reverse(raw.begin(), raw.end());
        bytes += raw;
      }
    }
  }
  return bytes;
}

TEST(PfmFile, PointsAreReadInBothOrdersOfBytes) {
  for (const bool isBigEndian : {false, true}) {
    const std::string header = isBigEndian ? "PF\n4 3\n1.0\n" : "PF\r\n4 3\n -2.5\n",
                      content = header + gridOf(4, 3, isBigEndian);
    const PfmGrid grid = parsePfm(content, true, 100);
    EXPECT_EQ(grid.columns, 4U);
    EXPECT_EQ(grid.rows, 3U);
    EXPECT_EQ(grid.at, header.size());
    EXPECT_EQ(grid.byteOf(3, 2, 2), content.size() - 4);
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 4; ++column) {
        for (int part = 0; part < 3; ++part)
          EXPECT_EQ(grid.point(column, row)[part], numberOf(column, row, part)) << column << ' ' << row;
      }
    }
  }
}

TEST(PfmFile, AGridForTwoEyesHasAnEvenNumberOfColumns) {
  const std::string odd = "PF\n3 2\n-1\n" + gridOf(3, 2, false);
  EXPECT_EQ(parsePfm(odd, false, 100).columns, 3U);
  EXPECT_TRUE(complaint([&] { parsePfm(odd, true, 100); }).starts_with("2:1: '3' is wrong"));
  const std::string two = "PF\n2 2\n-1\n" + gridOf(2, 2, false);
  EXPECT_EQ(parsePfm(two, false, 100).columns, 2U);
  EXPECT_TRUE(complaint([&] { parsePfm(two, true, 100); }).starts_with("2:1: '2' is wrong"));
}

TEST(PfmFile, FaultsHaveTheirPlace) {
  const auto said = [](const std::string& content) {
    return complaint([&] { parsePfm(content, false, 3); });
  };
  EXPECT_TRUE(said("PF\n4 2\n-1\n").starts_with("2:1: '4' is wrong, expected a number of columns"));
  EXPECT_TRUE(said("PF\n2 4\n-1\n").starts_with("2:3: '4' is wrong, expected a number of rows"));
  EXPECT_TRUE(said("PF\n2 2\n-1\n" + gridOf(2, 2, false) + "x")
                  .starts_with("1:1: 2 × 2 points take 48 bytes behind the header, but there are 49"));
}

}  // namespace
}  // namespace carom
