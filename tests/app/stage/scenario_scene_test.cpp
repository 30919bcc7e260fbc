#include "app/stage/scenario_scene.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "app/rig/rig.h"
#include "places.h"

namespace carom {
namespace {

// The flat pieces of a curved screen, and those of a picture by direction far outside, have up to about two
// texels for what one of the window's pixels shows.
TEST(ScenarioScene, MeshesAreAsFineAsThePixelsOfCurvedWindows) {
  constexpr double kPi = std::numbers::pi;
  struct Case {
    const char* rig;
    double windowPixel_rad;
  };
  for (const auto& [name, windowPixel_rad] : {Case{"dome-master", kPi / 2048}, Case{"dome", kPi / 1024},
                                              Case{"cylinder", kPi * 85.0 / 180.0 / 900}}) {
    const Rig rig = readRig(CAROM_CONFIG_DIR "/rigs/" + std::string(name) + ".toml");
    const double pixel_rad = tessellationFor(rig, true).pixel_rad;
    EXPECT_LT(pixel_rad, windowPixel_rad) << name;
    EXPECT_GT(pixel_rad, windowPixel_rad / 3.0) << name;
  }
}

}  // namespace
}  // namespace carom
