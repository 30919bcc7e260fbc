// The flat walls on which a curved screen is drawn.
#include "cave/screen/flat_pieces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "cave/room/off_axis.h"
#include "cave/screen/true_screens.h"

namespace carom {
namespace {

using namespace test;

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
