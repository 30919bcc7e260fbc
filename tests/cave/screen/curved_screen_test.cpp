// Curved screens and their flat pieces, against the formulas of their surfaces.
#include "cave/screen/true_screens.h"

#include <algorithm>
#include <array>
#include <optional>

#include <gtest/gtest.h>

#include "cave/room/off_axis.h"

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

TEST(CurvedScreen, EachPixelOfAPieceIsOnItsWallForEveryEye) {
  std::mt19937_64 random(42);
  for (const TrueScreen& screen : screens()) {
    const CurvedScreen made = curved(screen);
    ASSERT_FALSE(made.pieces.empty()) << screen.name;
    double texels = 0.0, covered = 0.0;
    for (const FlatPiece& piece : made.pieces) {
      EXPECT_LE(2.0 * piece.stands_m, screen.sagitta_m) << screen.name;
      texels += static_cast<double>(piece.wall.pixels.x) * piece.wall.pixels.y;
      for (const ScreenTriangle& triangle : piece.mesh)
        covered += 0.5 * std::abs(windowArea(triangle)) * screen.window_px.x * screen.window_px.y;
      for (int i = 0; i < 50; ++i) {
        const glm::dvec3 eye_m = eyeNear(screen.middle_m, random);
        const auto clip = clipFromRoom(piece.wall, eye_m);
        ASSERT_TRUE(clip) << screen.name;
        for (const ScreenTriangle& triangle : piece.mesh) {
          for (const ScreenPoint& point : triangle) {
            const glm::dvec4 at = *clip * glm::dvec4(point.inRoom_m, 1.0);
            ASSERT_GT(at.w, 0.0) << screen.name;
            ASSERT_LE(std::abs(at.x / at.w), 1.0) << screen.name << " from " << eye_m.x << " " << eye_m.z;
            ASSERT_LE(std::abs(at.y / at.w), 1.0) << screen.name << " from " << eye_m.x << " " << eye_m.z;
          }
        }
      }
    }
    fmt::print("{}: {} pieces, {:.2f} texels a pixel, predicted slide {:.3f} px\n", screen.name,
               made.pieces.size(), texels / covered, made.slide_px);
    if (screen.name.starts_with("cylinder of 3 m")) {
      EXPECT_LE(texels / covered, 2.3);
    }
  }
}

}  // namespace
}  // namespace carom
