// What the operator's choices put on the walls, and that the session comes back from them as it was.
#include <gtest/gtest.h>

#include <map>

#include "app/temporary_folder.h"
#include "cave/display/display_walls.h"
#include "cave/glowing_puck.h"
#include "engine/light_speed.h"

namespace carom {
namespace {

using test::kC_m_s;

class Controls : public testing::Test {
 protected:
  /// The bytes of both eyes' pictures, once the walls have drawn a frame with these choices.
  std::map<std::string, std::string> drawn(const WallControls& controls, double display_s = 1.0) {
    FrameRecord record;
    record.display_s = display_s;
    record.controls = controls;
    record.viewers[0].observer.headFromBoard = Lorentz(kC_m_s);
    record.viewers[0].observer.left = {{0.0, {-0.03, 0.0, 0.0}}, {-0.03, 0.0, 0.0}, {-0.03, 0.0, 0.0}};
    record.viewers[0].observer.right = {{0.0, {0.03, 0.0, 0.0}}, {0.03, 0.0, 0.0}, {0.03, 0.0, 0.0}};
    record.viewers[0].observer.middle = {};
    walls_.draw(record, world_);
    Capture capture(folder_ / "", WhenFull::wait);
    walls_.capture(capture, 0);
    capture.finish();
    return {{"left", test::contentOf(folder_ / "wall-left-000000.png")},
            {"right", test::contentOf(folder_ / "wall-right-000000.png")}};
  }

  static std::vector<Wall> oneWall() {
    Wall wall = test::wallTowards({0, 0, 0}, {0, 1, 0}, {200, 200});
    wall.name = "wall";
    wall.stereo = StereoMode::sideBySide;
    return {wall};
  }

  test::TemporaryFolder folder_;
  Graphics graphics_;
  DisplayWalls walls_{graphics_, test::glowingPuck(0.2), kC_m_s, oneWall(), std::nullopt, false};
  const World world_{
      {WorldLine(Knot{}, kC_m_s), WorldLine({{0.0, {0.1, 2.0, 0.3}}, {}, 0.0, {}, 0.0}, kC_m_s)}, {}};
};

TEST_F(Controls, SwappedEyesSwapTheirPictures) {
  auto plain = drawn({}), swapped = drawn({Shown::session, 0, 1});
  ASSERT_NE(plain["left"], plain["right"]);
  EXPECT_EQ(swapped["left"], plain["right"]);
  EXPECT_EQ(swapped["right"], plain["left"]);
  auto pattern = drawn({Shown::calibrationPattern, 0, 0}),
       swappedPattern = drawn({Shown::calibrationPattern, 0, 1});
  ASSERT_NE(pattern["left"], pattern["right"]);
  EXPECT_EQ(swappedPattern["left"], pattern["right"]);
  EXPECT_EQ(swappedPattern["right"], pattern["left"]);
}

TEST_F(Controls, BlackIsBlackWhateverIsShown) {
  const auto black = drawn({Shown::session, 1, 0});
  const Image image = readBack(RenderTarget({200, 200}));  // made black
  writePng(image, folder_ / "black.png");
  EXPECT_EQ(black.at("left"), test::contentOf(folder_ / "black.png"));
  for (const Shown shown : {Shown::session, Shown::calibrationPattern, Shown::alignmentPattern}) {
    EXPECT_EQ(drawn({shown, 1, 1}), black);
    EXPECT_NE(drawn({shown, 0, 0}), black);
  }
}

TEST_F(Controls, TheSessionComesBackAsItWas) {
  const auto before = drawn({});
  for (const WallControls& other :
       {WallControls{Shown::calibrationPattern, 0, 0}, WallControls{Shown::alignmentPattern, 0, 0},
        WallControls{Shown::session, 1, 0}, WallControls{Shown::calibrationPattern, 1, 0}}) {
    EXPECT_NE(drawn(other), before);
    EXPECT_EQ(drawn({}), before);
  }
}

TEST_F(Controls, TheAlignmentPatternMovesAndTheCalibrationPatternStands) {
  EXPECT_NE(drawn({Shown::alignmentPattern, 0, 0}, 1.0), drawn({Shown::alignmentPattern, 0, 0}, 2.0));
  const auto pattern = drawn({Shown::calibrationPattern, 0, 0}, 1.0);
  EXPECT_EQ(drawn({Shown::calibrationPattern, 0, 0}, 2.0), pattern);
  drawn({Shown::alignmentPattern, 0, 0});
  EXPECT_EQ(drawn({Shown::calibrationPattern, 0, 0}, 3.0), pattern);
}

}  // namespace
}  // namespace carom
