// Projectors' meshes from files, told apart by their endings.
#include "cave/warps/warp_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>

#include <glm/geometric.hpp>

#include "app/temporary_folder.h"
#include "cave/mesh_files/measured_faults.h"
#include "cave/warps/some_keystone.h"

namespace carom {
namespace {

using test::kMeshes;
using test::kObj;

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

TEST(WarpFormats, FaultsOfAFileNameIt) {
  const test::TemporaryFolder folder;
  const auto said = [](const std::filesystem::path& path) {
    try {
      readWarp(path, {4, 3});
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string("nothing is wrong");
  };
  const auto broken = folder.file("broken.pfm", "PF\n4 2\n-1.0\n");
  EXPECT_TRUE(said(broken).starts_with(broken.string() + ":1:1: 4 × 2 points take 96 bytes")) << said(broken);
  EXPECT_NE(said(folder / "none.obj").find("there is no such file, expected a warp mesh"), std::string::npos);
  EXPECT_EQ(readWarp(folder.file("good.obj", kObj), {4, 3}).left.points.size(), 4U);
}

}  // namespace
}  // namespace carom
