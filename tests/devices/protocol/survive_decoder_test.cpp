#include "devices/protocol/survive_decoder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace carom {
namespace {

using Kind = Reading::Kind;

std::vector<Reading> readingsOf(SurviveDecoder& decoder, std::string_view text) {
  std::vector<Reading> readings;
  decoder.decode({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, readings);
  return readings;
}

constexpr std::string_view kPose =
    "12.345678 T20 POSE 0.500000 -0.250000 1.750000 0.800000 0.000000 0.600000 0.000000 \r\n";

TEST(SurviveDecoder, ReadsAPose) {
  SurviveDecoder decoder({"WM0", "T20"});
  const auto readings = readingsOf(decoder, kPose);
  ASSERT_EQ(readings.size(), 1u);
  EXPECT_EQ(readings[0].kind, Kind::pose);
  EXPECT_EQ(readings[0].sensor, 1);
  EXPECT_EQ(readings[0].device_s, 12.345678);
  EXPECT_EQ(readings[0].pose.position_m, glm::dvec3(0.5, -0.25, 1.75));
  EXPECT_TRUE(readings[0].hasOrientation);
  EXPECT_NEAR(readings[0].pose.orientation.w, 0.8, 1e-12);  // it comes first
  EXPECT_NEAR(readings[0].pose.orientation.y, 0.6, 1e-12);
}

TEST(SurviveDecoder, NumbersDevicesAsTheyComeWithoutNames) {
  SurviveDecoder decoder({});
  const auto readings =
      readingsOf(decoder, "1 WM0 POSE 0 0 1 1 0 0 0\n1 T20 POSE 0 0 2 1 0 0 0\n2 WM0 POSE 0 0 3 1 0 0 0\n");
  ASSERT_EQ(readings.size(), 3u);
  EXPECT_EQ(readings[0].sensor, 0);
  EXPECT_EQ(readings[1].sensor, 1);
  EXPECT_EQ(readings[2].sensor, 0);
  EXPECT_EQ(decoder.devices(), (std::vector<std::string>{"WM0", "T20"}));
}

TEST(SurviveDecoder, ReadsButtonsAndLosses) {
  SurviveDecoder decoder({"WM0"});
  const auto readings =
      readingsOf(decoder,
                 "1 WM0 BUTTON 3 0\r\n2 WM0 BUTTON 2 0\r\n3 WM0 BUTTON 5 1\r\n4 WM0 BUTTON 8 255\r\n"
                 "5 T20 BUTTON 3 0\r\n6 WM0 DISCONNECT\r\n7 T20 DISCONNECT\r\n");
  ASSERT_EQ(readings.size(), 3u) << "touches, axes and other devices are passed by";
  EXPECT_EQ(readings[0].kind, Kind::button);
  EXPECT_EQ(readings[0].index, 0);
  EXPECT_EQ(readings[0].value, 1.0);
  EXPECT_EQ(readings[1].value, 0.0);
  EXPECT_EQ(readings[2].kind, Kind::lost);
  EXPECT_EQ(decoder.refused(), 0u);
}

TEST(SurviveDecoder, PassesOtherWordsBy) {
  SurviveDecoder decoder({});
  EXPECT_TRUE(
      readingsOf(
          decoder,
          "Info: Loaded drivers\n0.1 OPTION v i 0\n0.2 T20 CONFIG { }\r\n0.3 INFO LOG No base station\r\n"
          "0.4 T20 VELOCITY 0 0 0 0 0 0 \r\n0.5 1 LH_POSE 0 0 0 1 0 0 0 7\r\n0.6 0.7 T20 POSE 0 0\r\n\n \n")
          .empty());
  EXPECT_EQ(decoder.refused(), 0u);
  EXPECT_EQ(decoder.lastWords(), "No base station");
}

TEST(SurviveDecoder, LinesAreFoundHoweverTheyAreCut) {
  std::string text;
  for (int i = 0; i < 100; ++i) text += kPose;
  std::mt19937_64 random(5);
  SurviveDecoder decoder({});
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t size = 1 + random() % 70;
    count += readingsOf(decoder, std::string_view(text).substr(at, size)).size();
    at += size;
  }
  EXPECT_EQ(count, 100u);
}

TEST(SurviveDecoder, NamesWhatItCannotRead) {
  SurviveDecoder decoder({});
  for (const char* wrong :
       {"1 T20 POSE 0 0 0 1 0 0\n", "1 T20 POSE 0 0 0 1 0 0 0 0\n", "1 T20 POSE 0 0 x 1 0 0 0\n",
        "1 T20 POSE 0 0 nan 1 0 0 0\n", "1 T20 POSE 0 0 0 0 0 0 0\n", "1 T20 POSE 0 0 2000 1 0 0 0\n",
        "1 WM0 BUTTON 3\n", "1 WM0 BUTTON three 0\n"}) {
    const std::uint64_t before = decoder.refused();
    EXPECT_TRUE(readingsOf(decoder, wrong).empty()) << wrong;
    EXPECT_EQ(decoder.refused(), before + 1) << wrong;
    EXPECT_NE(decoder.whyRefused().find("cannot be read"), std::string::npos) << decoder.whyRefused();
  }
}

TEST(SurviveDecoder, LongLinesArePassedByInBoundedMemory) {
  SurviveDecoder decoder({});
  const std::string million(1'000'000, 'x');
  EXPECT_TRUE(readingsOf(decoder, million + '\n').empty());
  EXPECT_EQ(decoder.refused(), 1u);
  EXPECT_NE(decoder.whyRefused().find("a line has over 4096 bytes"), std::string::npos)
      << decoder.whyRefused();
  EXPECT_EQ(readingsOf(decoder, "1 T20 CONFIG " + million + "\r\n" + std::string(kPose)).size(), 1u);
  EXPECT_EQ(decoder.refused(), 1u) << "a configuration may be long";
  EXPECT_TRUE(readingsOf(decoder, million).empty());
  EXPECT_EQ(decoder.refused(), 2u) << "a line that does not end is told of before it does";
  EXPECT_EQ(readingsOf(decoder, million + '\n' + std::string(kPose)).size(), 1u);
  EXPECT_EQ(decoder.refused(), 2u) << "and once only";
}

TEST(SurviveDecoder, TellsOfSomeDevicesOnly) {
  SurviveDecoder decoder({});
  for (int i = 0; i < 1000; ++i) readingsOf(decoder, "1 T" + std::to_string(i) + " POSE 0 0 0 1 0 0 0\n");
  EXPECT_EQ(decoder.devices().size(), SurviveDecoder::kMostDevices);
}

}  // namespace
}  // namespace carom
