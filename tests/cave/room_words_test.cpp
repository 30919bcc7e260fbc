// Words in the room: what they say, how large they are, and that both eyes see them at the same place.
#include "cave/room_words.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "cave/capture.h"
#include "cave/glowing_puck.h"
#include "cave/wall_set.h"

namespace carom {
namespace {

constexpr double kC_m_s = 1.42;

Wall frontOf(const char* name, StereoMode stereo) {
  Wall wall;
  wall.name = name;
  wall.lowerLeft_m = {-1.5, 0.0, -1.5};
  wall.lowerRight_m = {1.5, 0.0, -1.5};
  wall.upperLeft_m = {-1.5, 3.0, -1.5};
  wall.pixels = {900, 900};
  wall.stereo = stereo;
  return wall;
}

FrameRecord recordAt(double display_s) {
  FrameRecord record;
  record.display_s = record.observer.properTime_s = display_s;
  record.lightSpeed_m_s = kC_m_s;
  record.observer.headFromBoard = Lorentz::boost(uFromBeta({0.0, 0.6, 0.0}), kC_m_s).inverse();
  record.observer.eyes = {EyeView{{0.0, {-0.03, 0.0, 0.0}}, {-0.03, 1.7, 0.0}},
                          EyeView{{0.0, {0.03, 0.0, 0.0}}, {0.03, 1.7, 0.0}}, EyeView{{}, {0.0, 1.7, 0.0}}};
  return record;
}

std::vector<std::string> said(const FrameRecord& record) {
  std::vector<RoomLine> lines;
  describe(record, lines);
  std::vector<std::string> texts;
  for (const RoomLine& line : lines) texts.push_back(line.text);
  return texts;
}

TEST(RoomWords, SayWhichViewsAreOn) {
  FrameRecord record = recordAt(12.36);
  EXPECT_TRUE(said(record).empty());
  record.views.boardNow = record.views.frozen = 1;
  EXPECT_EQ(said(record), (std::vector<std::string>{"as seen", "now on the board", "frozen"}));
  record.views = {};
  record.views.clocks = 1;
  EXPECT_EQ(said(record),
            (std::vector<std::string>{"my clock  12.3 s", "my speed  0.60 c   gamma 1.25", "light  1.42 m/s"}));
  record.views = {};
  record.views.split = 1;
  EXPECT_EQ(said(record), (std::vector<std::string>{"as seen", "left: Einstein, right: Newton"}));
}

TEST(RoomWords, AreOnTheFirstWallAhead) {
  RoomFacts room;
  Wall left = frontOf("left", StereoMode::mono);
  left.lowerLeft_m = {-1.5, 0.0, 1.5};
  left.lowerRight_m = {-1.5, 0.0, -1.5};
  left.upperLeft_m = {-1.5, 3.0, 1.5};
  room.walls = {left};
  EXPECT_FALSE(frontWall(room));
  room.walls.push_back(frontOf("front", StereoMode::mono));
  ASSERT_TRUE(frontWall(room));
  EXPECT_EQ(frontWall(room)->name, "front");
}

class DrawnWords : public testing::Test {
 protected:
  Image drawn(const std::vector<RoomLine>& lines) {
    graphics_.makeCurrent();
    WallPicture picture({900, 900});
    words_.set(lines);
    words_.draw(frontOf("front", StereoMode::mono), picture);
    return readBack(picture);
  }

  Graphics graphics_;
  RoomWords words_;
};

TEST_F(DrawnWords, CapitalsAreFourCentimetresHigh) {
  const Image image = drawn({{"HHHH", {}}});
  int lowest = 900, highest = -1;
  for (int y = 0; y < 900; ++y) {
    for (int x = 0; x < 900; ++x) {
      if (image.rgb[static_cast<std::size_t>(3 * (y * 900 + x))] < 128) continue;
      lowest = std::min(lowest, y);
      highest = std::max(highest, y);
    }
  }
  EXPECT_NEAR(highest - lowest + 1, 0.04 * 300.0, 1.0);  // 300 pixels a metre
  EXPECT_GT(lowest, RoomWords::kMargin_m * 300.0);
}

TEST_F(DrawnWords, NothingToSayIsNothingDrawn) {
  EXPECT_GT(drawn({{"words", {}}}).rgb, std::vector<std::uint8_t>(3 * 900 * 900, 0));
  EXPECT_EQ(drawn({}).rgb, std::vector<std::uint8_t>(3 * 900 * 900, 0));
}

TEST_F(DrawnWords, ALongLineStaysOnTheWall) {
  const Image image = drawn({{std::string(200, 'm'), {}}});
  for (int y = 0; y < 900; ++y) EXPECT_EQ(image.rgb[static_cast<std::size_t>(3 * (y * 900 + 899))], 0) << y;
}

// A computer for each eye: both pictures hold the same panel on the same pixels, and other things elsewhere.
TEST(RoomWords, HaveNoParallax) {
  Graphics graphics;
  const std::vector<Wall> walls{frontOf("l", StereoMode::left), frontOf("r", StereoMode::right)};
  WallSet set(graphics, test::glowingPuck(0.2), kC_m_s, walls, std::nullopt, false);
  RoomFacts room;
  room.walls = walls;
  set.standIn(room);
  FrameRecord record = recordAt(3.0);
  const World world{
      {WorldLine(Knot{}, kC_m_s), WorldLine({{0.0, {0.1, 0.3, -1.0}}, {}, 0.0, {}, 0.0}, kC_m_s)}, {}};
  const auto images = [&] {
    set.draw(record, world);
    graphics.makeCurrent();
    return std::pair(readBack(*set.pictureOf("l")), readBack(*set.pictureOf("r")));
  };
  const auto [leftBefore, rightBefore] = images();
  EXPECT_NE(leftBefore.rgb, rightBefore.rgb);
  record.views.clocks = 1;
  const auto [left, right] = images();
  int changed = 0;
  for (std::size_t i = 0; i < left.rgb.size(); ++i) {
    const bool inLeft = left.rgb[i] != leftBefore.rgb[i], inRight = right.rgb[i] != rightBefore.rgb[i];
    ASSERT_EQ(inLeft, inRight) << i;
    if (!inLeft) continue;
    ASSERT_EQ(left.rgb[i], right.rgb[i]) << i;
    ++changed;
  }
  EXPECT_GT(changed, 10000);
}

}  // namespace
}  // namespace carom
