// The reader of rigs reads the keys that are declared for them.
#include "app/file_keys/rig_keys.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "app/file_keys/declared_keys.h"
#include "app/rig/rig.h"

namespace carom {
namespace {

using test::compare;
using test::Variant;

TEST(FileKey, ReaderOfRigsReadsTheDeclaredKeys) {
  const std::string osc = "kind = 'osc'", dome = "shape = 'dome'", grid = "shape = 'grid'",
                    wand = "tracker = 'wand'";
  const Variant forOne{.leftOut = {"headset", "viewer", "wall.screen", "wall.sky"},
                       .more = {{"tracker", osc}, {"hand", wand}}},
      forSeveral{.leftOut = {"headset", "head", "hand", "wall.screen", "wall.sky"},
                 .more = {{"viewer.hand", wand}}},
      ofHeadset{.leftOut = {"head", "hand", "viewer", "tracker", "wall", "node"}},
      ofCylinder{.leftOut = {"headset", "viewer"}}, ofSky{.leftOut = {"headset", "viewer", "wall.screen"}},
      ofDome{.leftOut = {"headset", "viewer"}, .more = {{"wall.screen", dome}}},
      ofGrid{.leftOut = {"headset", "viewer"}, .more = {{"wall.screen", grid}}};
  const auto read = [](const std::filesystem::path& file) { readRig(file); };
  compare(rigKeys(), read, {forOne, forSeveral, ofHeadset, ofCylinder, ofDome, ofGrid, ofSky});
}

}  // namespace
}  // namespace carom
