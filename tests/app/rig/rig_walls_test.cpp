// The walls of a rig file with their windows and projectors.
#include "app/rig/rig_walls.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/rig/rig_text.h"
#include "app/toml/input_file.h"

namespace carom {
namespace {

using test::changed;
using test::expectNear;
using test::Fault;
using test::kGood;
using test::kRounding_m;
using test::read;
using test::RigFaults;
using test::TemporaryFolder;
using test::withSecond;

TEST(Rig, AWindowNamesItsMonitors) {
  const auto windowOf = [](const std::string& keys) {
    return read(kGood + "window = { size = [800, 600]" + keys + " }\n").walls.at(0).window;
  };
  EXPECT_EQ(windowOf("").monitor, 0);
  EXPECT_FALSE(windowOf("").border);
  EXPECT_TRUE(windowOf(", border = true").border);
  EXPECT_EQ(windowOf(", monitor = 2").monitor, 2);
  EXPECT_EQ(windowOf(", monitor = 'DP-1'").monitorNames, std::vector<std::string>{"DP-1"});
  EXPECT_EQ(windowOf(", monitor = ['DP-1', 'DP-3']").monitorNames,
            (std::vector<std::string>{"DP-1", "DP-3"}));
  for (const char* wrong : {"[]", "[1]", "-1", "64", "true", "''", "['DP-1', '']", "1.5"})
    EXPECT_THROW(windowOf(std::string(", monitor = ") + wrong), InputErrors) << wrong;
}

TEST(Rig, CarriesWhatTheProjectorDoes) {
  const TemporaryFolder folder;
  folder.file("warp.pfm", "PF\n4 2\n-1.0\n" + std::string(4 * 2 * 12, '\0'));
  folder.file("blend.png", "");
  const Wall wall = readRig(folder.file("given.toml", kGood + "warp = 'warp.pfm'\nblend = 'blend.png'\n"
                                                              "black_level = 0.02\nflip = 'both'\n"
                                                              "display_latency_ms = 12.5\n"))
                        .walls.at(0);
  EXPECT_EQ(wall.warp, folder / "warp.pfm");
  EXPECT_EQ(wall.blend, folder / "blend.png");
  EXPECT_EQ(wall.blackLevel, 0.02);
  EXPECT_EQ(wall.flip, Flip::both);
  EXPECT_NEAR(wall.displayLatency_s, 0.0125, 1e-15);
}

TEST(Rig, CarriesTheColoursOfTheProjector) {
  const TemporaryFolder folder;
  folder.file("warp.pfm", "PF\n4 2\n-1.0\n" + std::string(4 * 2 * 12, '\0'));
  const std::string meshes = "warp_red = 'warp.pfm'\nwarp_green = 'warp.pfm'\nwarp_blue = 'warp.pfm'\n";
  const Wall wall =
      readRig(folder.file("given.toml", kGood + "gain = [1, 0.9, 0.8]\ngamma = [2.2, 2.3, 2.4]\n" + meshes))
          .walls.at(0);
  EXPECT_EQ(wall.gain, glm::dvec3(1.0, 0.9, 0.8));
  EXPECT_EQ(wall.gamma, glm::dvec3(2.2, 2.3, 2.4));
  for (const auto& warp : wall.colourWarps) EXPECT_EQ(warp, folder / "warp.pfm");
  const Wall plain = read(kGood).walls.at(0);
  EXPECT_EQ(plain.gain, glm::dvec3(1.0));
  EXPECT_FALSE(plain.gamma);
}

TEST(Rig, NamesWhatIsWrongInAWarpAtItsOwnLine) {
  const TemporaryFolder folder;
  const auto warp = folder.file("warp.obj", "v 0 0 0\nv nan 0 0\n");
  try {
    readRig(folder.file("given.toml", kGood + "warp = 'warp.obj'\n"));
    FAIL() << "the warp is broken";
  } catch (const InputError& error) {
    EXPECT_EQ(std::pair(error.line(), error.column()), std::pair(15, 8));
    EXPECT_TRUE(error.message().starts_with(warp.string() + ":2:3: 'nan' is wrong")) << error.what();
  }
}

TEST(Rig, EyesMayShareAWindow) {
  // A projector for each eye: two walls with equal corners, side by side in the one window.
  std::string second = kGood.substr(kGood.find("[[wall]]"));
  second.replace(second.find("front"), 5, "front-right");
  const std::string text = changed("[head]", "[one_window]\nsize = [200, 100]\n[head]") +
                           "window = { size = [100, 100] }\nstereo = 'left'\n" + second +
                           "window = { size = [100, 100], position = [100, 0] }\nstereo = 'right'\n";
  EXPECT_EQ(read(text).walls.size(), 2u);
}

TEST(Rig, WallsOfANodeShareAWindowByViewports) {
  const std::string window = "window = { size = [200, 100], viewport = { size = [100, 100]";
  const Rig rig = read(withSecond(window + " } }\n", window + ", position = [100, 0] } }\n"));
  ASSERT_TRUE(rig.walls[0].viewport && rig.walls[1].viewport);
  EXPECT_TRUE(rig.walls[0].window == rig.walls[1].window);
  EXPECT_EQ(rig.walls[1].viewport->position_px, glm::ivec2(100, 0));
  EXPECT_EQ(rig.walls[1].viewport->size_px, glm::ivec2(100, 100));
  EXPECT_NO_THROW(read(withSecond(window + " } }\n", window + " } }\nnode = 1\n"))) << "windows of two nodes";
}

TEST(Rig, EachNodeHasItsOneWindow) {
  const std::string text =
      withSecond("window = { size = [100, 100] }\n", "window = { size = [100, 100] }\nnode = 1\n");
  std::string one = text;
  one.replace(one.find("[head]"), 6, "[one_window]\nsize = [100, 100]\n[head]");
  EXPECT_EQ(read(one).walls.size(), 2u);
}

// A screen that a projector distorts is drawn for the rectangle around it.
TEST(Rig, MayHaveASkewedScreen) {
  const std::string four =
      "lower_left = [-1500, 0, -1500]\nlower_right = [1480, 10, -1500]\nupper_left = [-1460, 1990, -1500]\n"
      "upper_right = [1500, 2000, -1500]\nskewed = true\n";
  const std::string three =
      "lower_left = [-1500, 0, -1500]\nlower_right = [1500, 0, -1500]\nupper_left = [-1500, 2000, -1500]\n";
  const Wall wall = read(changed(three, four)).walls.at(0);
  ASSERT_TRUE(wall.skewed);
  expectNear(wall.skewed->corners_m[3], {1.5, 2.0, -1.5});
  EXPECT_NEAR(wall.skewed->offPlane_m, 0.0, kRounding_m);
  // The edges of the rectangle touch the screen: along each side lies one corner at least, none beyond.
  glm::dvec2 least(1.0), most(0.0);
  for (const glm::dvec2& corner : wall.skewed->inPicture) {
    least = glm::min(least, corner);
    most = glm::max(most, corner);
  }
  EXPECT_EQ(least, glm::dvec2(0.0));
  EXPECT_EQ(most, glm::dvec2(1.0));
  const std::string unsaid = changed(three, four.substr(0, four.find("skewed")));
  EXPECT_THROW(read(unsaid), InputErrors);  // a slip of the tape is not taken for a skewed screen
}

TEST(Rig, OneThingAloneSaysWhereThePictureGoes) {
  const TemporaryFolder folder;
  folder.file("warp.pfm", "PF\n4 2\n-1.0\n" + std::string(4 * 2 * 12, '\0'));
  const std::string colours = "warp_red = 'warp.pfm'\nwarp_green = 'warp.pfm'\nwarp_blue = 'warp.pfm'\n";
  const std::string skewed = "skewed = true\nupper_right = [1500, 1900, -1500]\n";
  const auto faultsOf = [&](const std::string& text) {
    try {
      readRig(folder.file("given.toml", kGood + text));
    } catch (const InputErrors& error) {
      std::string all;
      for (const InputError& fault : error.faults()) all += fault.message() + "\n";
      return all;
    }
    return std::string();
  };
  EXPECT_EQ(faultsOf(skewed), "");
  EXPECT_EQ(faultsOf(colours), "");
  EXPECT_NE(faultsOf(skewed + "warp = 'warp.pfm'\n").find("as the corners of a skewed wall do"),
            std::string::npos);
  EXPECT_NE(faultsOf(skewed + colours).find("as the corners of a skewed wall do"), std::string::npos);
  EXPECT_NE(faultsOf(colours + "warp = 'warp.pfm'\n").find("expected no warp for all of them"),
            std::string::npos);
  EXPECT_NE(faultsOf("warp_red = 'warp.pfm'\n").find("warp_green is missing"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    Walls, RigFaults,
    ::testing::Values(
        Fault{"no pixels", changed("[1920, 1280]", "[1920, 0]"), 14, 17, "from 1"},
        Fault{"half a pixel", changed("[1920, 1280]", "[1920, 0.5]"), 14, 17, "whole number"},
        Fault{"stereo", kGood + "stereo = 'both'\n", 15, 10, "'side-by-side'"},
        Fault{"no such warp", kGood + "warp = 'no.pfm'\n", 15, 8, "'no.pfm' is no file"},
        Fault{"warp of another kind", kGood + "warp = 'rigs/desk.toml'\n", 15, 8, "ending in .pfm or .obj"},
        Fault{"blend of another kind", kGood + "blend = 'rigs/desk.toml'\n", 15, 9, "ending in .png"},
        Fault{"black level", kGood + "black_level = 1.1\n", 15, 15, "from 0 to 1"},
        Fault{"flip", kGood + "flip = true\n", 15, 8, "'none' or 'horizontal'"},
        Fault{"gain", kGood + "gain = [1, 1, 1.1]\n", 15, 15, "above 0 up to 1"},
        Fault{"two gains", kGood + "gain = [1, 1]\n", 15, 8, "3 numbers"},
        Fault{"white below black", kGood + "gain = [1, 0.1, 1]\nblack_level = 0.2\n", 15, 8,
              "white above black"},
        Fault{"gamma", kGood + "gamma = [0.5, 2, 2]\n", 15, 10, "from 1 to 4"},
        Fault{"skewed of three corners", kGood + "skewed = true\n", 15, 10, "needs all four corners"},
        Fault{"bent", kGood + "skewed = true\nupper_right = [1500, 2000, -1400]\n", 16, 15, "off one plane"},
        Fault{"crossed", kGood + "skewed = true\nupper_right = [-1600, 2000, -1500]\n", 16, 15, "degrees"},
        Fault{"latency of a wall", kGood + "display_latency_ms = -1\n", 15, 22, "from 0"},
        Fault{"window", kGood + "window = { position = [0, 0] }\n", 15, 10, "size is missing"},
        Fault{"viewport inside the one window",
              changed("[head]", "[one_window]\nsize = [100, 100]\n[head]") +
                  "window = { size = [100, 100], viewport = { size = [50, 50] } }\n",
              17, 42, "expected none"},
        Fault{"place not given", changed("[head]", "[one_window]\nsize = [100, 100]\n[head]"), 11, 1,
              "window is missing"}),
    test::nameOfFault);

}  // namespace
}  // namespace carom
