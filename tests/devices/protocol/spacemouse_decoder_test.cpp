#include "devices/protocol/spacemouse_decoder.h"

#include <gtest/gtest.h>

#include <map>

namespace carom {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// The value of each axis that the report told.
std::map<int, double> axes(SpaceMouseDecoder& decoder, const Bytes& report) {
  std::vector<Reading> readings;
  EXPECT_TRUE(decoder.decode(report, readings));
  std::map<int, double> told;
  for (const Reading& reading : readings) {
    EXPECT_EQ(reading.kind, Reading::Kind::axis);
    told[reading.index] = reading.value;
  }
  return told;
}

using Axes = std::map<int, double>;

TEST(SpaceMouseDecoder, PushedRightUpAndBack) {
  SpaceMouseDecoder decoder;
  // The device's x is right, y toward the user, z down; 350 = 0x015e, -350 = 0xfea2.
  EXPECT_EQ(axes(decoder, {1, 0x5e, 1, 0, 0, 0, 0}), (Axes{{0, 1.0}, {1, 0.0}, {2, 0.0}}));
  EXPECT_EQ(axes(decoder, {1, 0, 0, 0xaf, 0, 0, 0}), (Axes{{0, 0.0}, {1, 0.0}, {2, 0.5}}));
  EXPECT_EQ(axes(decoder, {1, 0, 0, 0, 0, 0xa2, 0xfe}), (Axes{{0, 0.0}, {1, 1.0}, {2, 0.0}}));
}

TEST(SpaceMouseDecoder, TurnedInTheSecondReportOrTheLongFirst) {
  SpaceMouseDecoder decoder;
  EXPECT_EQ(axes(decoder, {2, 0x5e, 1, 0, 0, 0, 0}), (Axes{{3, 1.0}, {4, 0.0}, {5, 0.0}}));
  const Axes both = axes(decoder, {1, 0xaf, 0, 0, 0, 0, 0, 0, 0, 0x5e, 1, 0x51, 0xff});
  EXPECT_EQ(both, (Axes{{0, 0.5}, {1, 0.0}, {2, 0.0}, {3, 0.0}, {4, 0.5}, {5, 1.0}}));
}

TEST(SpaceMouseDecoder, NoAxisExceedsOne) {
  SpaceMouseDecoder decoder;
  const Axes told = axes(decoder, {1, 0xff, 0x7f, 0x00, 0x80, 0x00, 0x80});  // 32767, -32768, -32768
  EXPECT_EQ(told, (Axes{{0, 1.0}, {1, 1.0}, {2, -1.0}}));
}

TEST(SpaceMouseDecoder, ButtonsAreToldWhenTheyChange) {
  SpaceMouseDecoder decoder;
  std::vector<Reading> readings;
  ASSERT_TRUE(decoder.decode(Bytes{3, 0x01, 0x10, 0, 0x04}, readings));  // 0, 12 and 26
  ASSERT_EQ(readings.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(readings[i].kind, Reading::Kind::button);
    EXPECT_EQ(readings[i].index, (std::array{0, 12, 26})[i]);
    EXPECT_EQ(readings[i].value, 1.0);
  }
  readings.clear();
  ASSERT_TRUE(decoder.decode(Bytes{3, 0x01, 0x10, 0, 0x04}, readings));
  EXPECT_TRUE(readings.empty());
  ASSERT_TRUE(decoder.decode(Bytes{3, 0x01, 0x00, 0, 0x04}, readings));
  ASSERT_EQ(readings.size(), 1u);
  EXPECT_EQ(readings[0].index, 12);
  EXPECT_EQ(readings[0].value, 0.0);
}

TEST(SpaceMouseDecoder, CentreAndReleaseUndoWhatWasTold) {
  SpaceMouseDecoder decoder;
  std::vector<Reading> readings;
  decoder.decode(Bytes{1, 1, 0, 0, 0, 0, 0}, readings);
  decoder.decode(Bytes{2, 0, 0, 0, 0, 1, 0}, readings);
  decoder.decode(Bytes{3, 2}, readings);
  readings.clear();
  decoder.centre(readings);
  ASSERT_EQ(readings.size(), 2u);
  EXPECT_EQ(readings[0].index, 0);
  EXPECT_EQ(readings[1].index, 4);
  for (const Reading& reading : readings) EXPECT_EQ(reading.value, 0.0);
  readings.clear();
  decoder.centre(readings);
  EXPECT_TRUE(readings.empty());
  decoder.release(readings);
  ASSERT_EQ(readings.size(), 1u);
  EXPECT_EQ(readings[0].kind, Reading::Kind::button);
  EXPECT_EQ(readings[0].index, 1);
  EXPECT_EQ(readings[0].value, 0.0);
}

TEST(SpaceMouseDecoder, TooShortReportsAreRefusedOthersPassedOver) {
  SpaceMouseDecoder decoder;
  std::vector<Reading> readings;
  for (const Bytes& report :
       {Bytes{}, Bytes{1}, Bytes{1, 0, 0, 0, 0, 0}, Bytes{2, 0, 0, 0, 0, 0}, Bytes{3}}) {
    EXPECT_FALSE(decoder.decode(report, readings));
  }
  EXPECT_TRUE(decoder.decode(Bytes{23, 88}, readings));  // the battery's
  EXPECT_TRUE(readings.empty());
}

}  // namespace
}  // namespace carom
