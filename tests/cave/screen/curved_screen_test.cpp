// Curved screens, against the formulas of their surfaces.
#include "cave/screen/true_screens.h"

#include <algorithm>
#include <optional>

#include <gtest/gtest.h>

namespace carom {
namespace {

using namespace test;

// What stands on the true surface is seen in the window where the surface has it, whatever eye looks.
TEST(CurvedScreen, APointOfTheSurfaceStaysInItsPixelForEveryEye) {
  std::mt19937_64 random(41);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (const TrueScreen& screen : screens()) {
    double most_px = 0.0;
    for (int i = 0; i < 10000; ++i) {
      const glm::dvec2 place(share(random), share(random));
      if (!screen.isScreen(place)) continue;
      const glm::dvec3 eye_m = eyeNear(screen.middle_m, random);
      const std::optional<glm::dvec3> drawn_m = inRoom_m(screen.mesh, place);
      ASSERT_TRUE(drawn_m) << screen.name << " at " << place.x << " " << place.y;
      const glm::dvec2 seen = screen.inWindow(eye_m, *drawn_m - eye_m);
      const double off_px = glm::length((seen - place) * glm::dvec2(screen.window_px));
      most_px = std::max(most_px, off_px);
      ASSERT_LE(off_px, 0.2) << screen.name << " at " << place.x << " " << place.y << " from " << eye_m.x
                             << " " << eye_m.y << " " << eye_m.z;
    }
    fmt::print("{}: at most {:.3f} px off\n", screen.name, most_px);
  }
}

}  // namespace
}  // namespace carom
