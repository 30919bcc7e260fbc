// Wavefront OBJ: points, places in a picture, and faces of both.
#include "cave/mesh_files/obj_file.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "cave/mesh_files/measured_faults.h"

namespace carom {
namespace {

using test::complaint;

constexpr ObjWishes kFree{.mostPoints = 100}, kPaired{.coordinates = 2, .isPaired = true, .mostPoints = 100};
const std::string kPoints = "v 1 2 3\nv 4 5 6\nv 7 8 9 1.0\nv -1 -2 -3\n";

/// The corners of its triangles, counted from 1.
std::vector<std::vector<std::string>> cornersOf(const ObjFile& file) {
  std::vector<std::vector<std::string>> all;
  for (const auto& triangle : file.triangles) {
    auto& corners = all.emplace_back();
    for (const ObjCorner& corner : triangle)
      corners.push_back(std::to_string(corner.point + 1) + '/' + std::to_string(corner.inPicture + 1));
  }
  return all;
}

// A polygon is cut into a fan from its first corner; of a corner's normal nothing is read.
TEST(ObjFile, PolygonsAreFansOfTheirFirstCorner) {
  const ObjFile file = parseObj(
      "# a comment\no name\n" + kPoints + "vt 0 0.25\nvt 1 0.5\nvn 0 0 1\ns off\nf 2/1 3/2/1 4/1/9 1/2\n",
      kFree);
  ASSERT_EQ(file.points.size(), 4U);
  EXPECT_EQ(file.points[2], glm::dvec3(7, 8, 9));
  ASSERT_EQ(file.inPicture.size(), 2U);
  EXPECT_EQ(file.inPicture[1], glm::dvec2(1, 0.5));
  EXPECT_EQ(cornersOf(file),
            (std::vector<std::vector<std::string>>{{"2/1", "3/2", "4/1"}, {"2/1", "4/1", "1/2"}}));
}

TEST(ObjFile, PairedCornersHaveOneNumberForBoth) {
  const std::string places = "vt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\n";
  const ObjFile file = parseObj(kPoints + places + "f 1 2/2 4/4/1\n", kPaired);
  EXPECT_EQ(file.points[1], glm::dvec3(4, 5, 0)) << "two coordinates are read";
  EXPECT_EQ(cornersOf(file), (std::vector<std::vector<std::string>>{{"1/1", "2/2", "4/4"}}));
  EXPECT_TRUE(complaint([&] {
                parseObj(kPoints + places + "f 1 2/3 4\n", kPaired);
              }).starts_with("9:5: '2/3' is wrong, expected the same number for v and vt"));
  EXPECT_TRUE(complaint([&] {
                parseObj(kPoints + "f 1 2 4\n", kPaired);
              }).starts_with("1:1: there are 4 v and 0 vt, expected one vt for each v"));
}

TEST(ObjFile, FaultsHaveTheirPlace) {
  const std::string vt = "vt 0 0\n";
  for (const auto& [more, said] : std::vector<std::pair<std::string, std::string>>{
           {"f 1/1 2/1 5/1\n", "6:1: corner 5 is none of the 4 points"},
           {"f 1/1 2/1 3/2\n", "6:1: corner 2 is none of the 1 points"},
           {"f 1/1 2/1 3\n", "6:11: '3' is wrong, expected both v and vt"},
           {"f 1/1 2/1 0/1\n", "6:11: '0/1' is wrong, expected a corner, counted from 1"},
           {"f 1/1 2/1\n", "6:10: something is missing here, expected a corner"},
           {"f 1/1 2/1 101/1\n", "6:11: '101/1' is wrong, expected a corner, counted from 1"},
           {"curv 1\n", "6:1: 'curv' is wrong, expected v, vt, f or another word of OBJ"},
           {"v 1 2\n", "6:6: something is missing here"},
           {"vt 0 17\n", "6:6: '17' is wrong, expected a number from -16 to 16"},
           {"", "1:1: there is no f"}}) {
    const std::string heard = complaint([&] { parseObj(kPoints + vt + more, kFree); });
    EXPECT_TRUE(heard.starts_with(said)) << said << "\n" << heard;
  }
}

TEST(ObjFile, HasAsManyPointsAsWished) {
  ObjWishes few = kFree;
  few.mostPoints = 3;
  EXPECT_TRUE(complaint([&] { parseObj(kPoints, few); }).starts_with("4:1: there are more than 3 v"));
}

}  // namespace
}  // namespace carom
