#include "devices/protocol/dtrack_decoder.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <locale>
#include <string>

namespace carom {
namespace {

using Kind = Reading::Kind;

// Turned by 30° about z, column by column, as DTRACK prints it.
const std::string kTurned =
    "[0.866025 0.500000 0.000000 -0.500000 0.866025 0.000000 0.000000 0.000000 1.000000]";
constexpr double kDecimals = 1e-6;  // of what is printed

std::vector<Reading> decoded(const std::string& text) {
  DtrackDecoder decoder;
  std::vector<Reading> readings;
  decoder.decode({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, readings);
  return readings;
}

TEST(DtrackDecoder, ReadsBodies) {
  const std::string text = "fr 21753\r\n6d 2 [0 0.950][326.848 -187.216 109.503]" + kTurned +
                           "[7 1.000] [1.0 2.0 3.0] " + kTurned + "\r\n" + '\0';
  const auto readings = decoded(text);
  ASSERT_EQ(readings.size(), 2u);
  EXPECT_EQ(readings[0].kind, Kind::pose);
  EXPECT_EQ(readings[0].sensor, 0);
  EXPECT_EQ(readings[1].sensor, 7);
  EXPECT_EQ(readings[0].quality, 0.95);
  EXPECT_NEAR(readings[0].pose.position_m.x, 0.326848, 1e-12);
  EXPECT_NEAR(readings[0].pose.position_m.y, -0.187216, 1e-12);
  EXPECT_NEAR(readings[0].pose.orientation.z, std::sin(M_PI / 12), kDecimals);
  EXPECT_NEAR(readings[0].pose.orientation.w, std::cos(M_PI / 12), kDecimals);
  EXPECT_TRUE(std::isnan(readings[0].device_s)) << "there is no time in it";
}

TEST(DtrackDecoder, TakesTheLatencyOff) {
  const std::string body = "6d 1 [0 1.000][0 0 0]" + kTurned + "\r\n";
  const auto readings = decoded("fr 1\r\nts 100.5\r\nts2 1800000000 250000 6500\r\n" + body);
  ASSERT_EQ(readings.size(), 1u);
  // ts2 is when the cameras looked: sent 6.5 ms later, and so old.
  EXPECT_NEAR(readings[0].device_s - readings[0].latency_s, 1800000000.25, 1e-6);
  EXPECT_NEAR(readings[0].latency_s, 0.0065, 1e-12);
  const auto plain = decoded("fr 1\r\nts 100.5\r\n" + body);
  ASSERT_EQ(plain.size(), 1u);
  EXPECT_EQ(plain[0].device_s, 100.5);
  EXPECT_EQ(plain[0].latency_s, 0.0);
  EXPECT_EQ(decoded("ts2 1800000000 250000 6500\r\nts 100.5\r\n" + body)[0].device_s, 1800000000.2565);
}

TEST(DtrackDecoder, GoesOnPastMidnight) {
  DtrackDecoder decoder;
  double last_s = 0.0;
  for (const double ofDay_s : {86399.99, 0.0, 0.01, 43200.0, 86399.0, 0.5}) {
    const std::string text = "ts " + std::to_string(ofDay_s) + "\n6d 1 [0 1][0 0 0]" + kTurned;
    std::vector<Reading> readings;
    decoder.decode({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, readings);
    ASSERT_EQ(readings.size(), 1u);
    EXPECT_GT(readings[0].device_s, last_s);
    last_s = readings[0].device_s;
  }
  EXPECT_NEAR(last_s, 2 * 86400.5 - 0.5, 1e-6);
}

TEST(DtrackDecoder, ReadsFlysticks) {
  const auto readings =
      decoded("6df2 2 2 [0 1.000 34 2][100 200 300]" + kTurned + "[-2147483643 3 0.50 -1.00] " +
              "[1 -1.000 4 0][0.000 0.000 0.000][0 0 0 0 0 0 0 0 0][8]\r\n");
  ASSERT_EQ(readings.size(), 1u + 34 + 2 + 1 + 4);
  EXPECT_EQ(readings[0].sensor, 100);
  EXPECT_EQ(readings[0].kind, Kind::pose);
  EXPECT_EQ(readings[0].pose.position_m, glm::dvec3(0.1, 0.2, 0.3));
  // −2147483643 is 0x80000005; the second number holds buttons 32 and 33.
  for (int i = 0; i < 34; ++i) {
    EXPECT_EQ(readings[1 + i].kind, Kind::button);
    EXPECT_EQ(readings[1 + i].index, i);
    EXPECT_EQ(readings[1 + i].value, i == 0 || i == 2 || i >= 31) << "button " << i;
  }
  EXPECT_EQ(readings[35].kind, Kind::axis);
  EXPECT_EQ(readings[35].value, 0.5);
  EXPECT_EQ(readings[36].value, -1.0);
  EXPECT_EQ(readings[37].kind, Kind::lost) << "not seen, but its buttons are there";
  EXPECT_EQ(readings[37].sensor, 101);
  EXPECT_EQ(readings[41].value, 1.0);
}

TEST(DtrackDecoder, ReadsOldFlysticks) {
  // Button 2, and the hat to the right (0x80) and down (0x10).
  const auto readings = decoded("6df 1 [2 1.000 146][100 200 300]" + kTurned + "\n");
  ASSERT_EQ(readings.size(), 7u);
  EXPECT_EQ(readings[0].sensor, 102);
  EXPECT_EQ(readings[1].value, 0.0);
  EXPECT_EQ(readings[2].value, 1.0);
  EXPECT_EQ(readings[5].value, 1.0);
  EXPECT_EQ(readings[6].value, -1.0);
}

TEST(DtrackDecoder, ReadsHybridBodies) {
  const auto readings = decoded("6di 2 [0 3 0.100][1 2 3]" + kTurned + "[1 0 0.000][0 0 0]" + kTurned + "\n");
  ASSERT_EQ(readings.size(), 2u);
  EXPECT_EQ(readings[0].sensor, 200);
  EXPECT_EQ(readings[0].kind, Kind::pose);
  EXPECT_EQ(readings[1].kind, Kind::lost);
}

TEST(DtrackDecoder, BodiesNotListedAreLost) {
  // Four adjusted: two bodies, a Flystick and a tool.
  const auto readings =
      decoded("6dcal 4\r\n6d 1 [1 1.000][0 0 0]" + kTurned + "\r\n6df2 1 0\r\n6dmt2 1 0\r\n");
  ASSERT_EQ(readings.size(), 2u);
  EXPECT_EQ(readings[0].kind, Kind::pose);
  EXPECT_EQ(readings[1].kind, Kind::lost);
  EXPECT_EQ(readings[1].sensor, 0);
}

// A `6dcal` counts hybrid bodies as well, which `6d` never lists.
TEST(DtrackDecoder, AHybridBodyIsNoLostStandardBody) {
  const std::string hybrid = "6di 1 [0 3 0.100][1 2 3]" + kTurned + "\r\n";
  for (const std::string& frame : {"6dcal 1\r\n6d 0\r\n" + hybrid, "6dcal 1\r\n" + hybrid + "6d 0\r\n"}) {
    const auto readings = decoded(frame);
    ASSERT_EQ(readings.size(), 1u) << frame;
    EXPECT_EQ(readings[0].sensor, 200);
  }
  const auto both = decoded("6dcal 2\r\n6d 0\r\n" + hybrid);
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[1].sensor, 0);
  EXPECT_EQ(both[1].kind, Kind::lost);
}

TEST(DtrackDecoder, PassesOverWhatItDoesNotKnowAndWhatIsWrong) {
  const std::string good = "6d 1 [0 1.000][0 0 0]" + kTurned + "\r\n";
  for (const char* line : {"6d",
                           "6d x",
                           "6d -1",
                           "6d 99999999999999999999",
                           "6d 1",
                           "6d 1 [0 1.000]",
                           "6d 1 [0 1.000][0 0]",
                           "6d 1 [100 1.000][0 0 0][1 0 0 0 1 0 0 0 1]",
                           "6d 1 [-1 1.000][0 0 0][1 0 0 0 1 0 0 0 1]",
                           "6d 1 [0.5 1.000][0 0 0][1 0 0 0 1 0 0 0 1]",
                           "6d 1 [0 1.000][nan 0 0][1 0 0 0 1 0 0 0 1]",
                           "6d 1 [0 1.000][1e999 0 0][1 0 0 0 1 0 0 0 1]",
                           "6d 1 [0 1.000][0 0 0][1 0 0 0 1 0 0 0",
                           "6d 2 [0 1.000][0 0 0][1 0 0 0 1 0 0 0 1]",
                           "6df2 1 1 [0 1 2000000000 0][0 0 0][1 0 0 0 1 0 0 0 1][1]",
                           "6df2 1 1 [0 1 33 0][0 0 0][1 0 0 0 1 0 0 0 1][1]",
                           "6df2 1 1 [0 1 1 0][0 0 0][1 0 0 0 1 0 0 0 1][1e18]",
                           "fr x",
                           "ts nan",
                           "ts -1",
                           "ts2 1 2",
                           "ts2 1 2 99999999"}) {
    const std::string text = std::string(line) + "\r\n" + good;
    DtrackDecoder decoder;
    std::vector<Reading> readings;
    EXPECT_TRUE(decoder.decode({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, readings))
        << line;
    EXPECT_EQ(readings.size(), 1u) << line;
    EXPECT_EQ(decoder.refused(), 1u) << line;
  }
  EXPECT_EQ(decoded("3d 1 [1 1.0][0 0 0]\r\n6dj 1 nonsense\r\n6dcov 1 [\r\n" + good).size(), 1u);
  EXPECT_EQ(decoded("6d 1 [0 1.000 7 7][0 0 0 7]" + kTurned + "\n").size(), 1u)
      << "extra numbers are passed over";
}

TEST(DtrackDecoder, WhatIsNoRotationIsNoPose) {
  for (const char* matrix :
       {"[0 0 0 0 0 0 0 0 0]", "[2 0 0 0 1 0 0 0 1]", "[1 0 0 0 1 0 0 0 -1]", "[1 1 0 0 1 0 0 0 1]"}) {
    const auto readings = decoded(std::string("6d 1 [0 1.000][0 0 0]") + matrix + "\n");
    ASSERT_EQ(readings.size(), 1u);
    EXPECT_EQ(readings[0].kind, Kind::lost) << matrix;
  }
}

TEST(DtrackDecoder, SaysWhereNothingWasUnderstood) {
  DtrackDecoder decoder;
  std::vector<Reading> readings;
  for (const std::string text : {"", "hello\r\n", "fr\r\n"}) {
    EXPECT_FALSE(decoder.decode({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, readings))
        << text;
  }
}

/// Numbers of C++'s streams then have a decimal comma.
struct Comma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

// A decimal comma is the trap of many parsers of numbers.
TEST(DtrackDecoder, ReadsTheSameInEveryLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  const std::locale streams = std::locale::global(std::locale(std::locale::classic(), new Comma));
  for (const char* name : {"de_DE", "de_DE.utf8", "fr_FR.utf8"})
    std::setlocale(LC_ALL, name);  // those installed
  const auto readings = decoded("6d 1 [0 0.950][326.848 0 0]" + kTurned + "\n");
  std::locale::global(streams);
  std::setlocale(LC_ALL, before.c_str());
  ASSERT_EQ(readings.size(), 1u);
  EXPECT_NEAR(readings[0].pose.position_m.x, 0.326848, 1e-12);
}

}  // namespace
}  // namespace carom
