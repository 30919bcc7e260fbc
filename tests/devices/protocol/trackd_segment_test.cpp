#include "devices/protocol/trackd_segment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/mat3x3.hpp>
#include <random>
#include <stdexcept>

#include "print.h"

namespace carom {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Words = std::vector<std::uint32_t>;

constexpr double kDegree = 3.14159265358979323846 / 180.0;

Bytes bytesOf(const Words& words, std::size_t size) {
  Bytes bytes(size);
  std::memcpy(bytes.data(), words.data(), std::min(size, words.size() * 4));
  return bytes;
}

Bytes sensorsOf(std::uint32_t count, std::uint32_t offset, std::uint32_t size, std::size_t whole) {
  return bytesOf({1, count, offset, size, 1800000000, 250000, 0}, whole);
}

TrackdSensorBytes sensorOf(const std::array<float, 6>& numbers) {
  TrackdSensorBytes bytes{};
  std::memcpy(bytes.data(), numbers.data(), sizeof numbers);
  const std::array<std::uint32_t, 2> time{12, 345678};
  std::memcpy(bytes.data() + 24, time.data(), sizeof time);
  return bytes;
}

/// A rotation of the plane of two axes, written out.
glm::dmat3 turn(int from, int to, double angle) {
  glm::dmat3 m(1.0);
  m[from][from] = m[to][to] = std::cos(angle);
  m[from][to] = std::sin(angle);
  m[to][from] = -std::sin(angle);
  return m;
}

TEST(TrackdSegment, ReadsItsHeader) {
  const TrackdSensors sensors = readTrackdSensors(sensorsOf(3, 28, 40, 148));
  EXPECT_EQ(sensors.count, 3u);
  EXPECT_EQ(sensors.offset, 28u);
  EXPECT_EQ(sensors.size, 40u);
  EXPECT_EQ(sensors.seconds, 1800000000u);
  EXPECT_EQ(sensors.microseconds, 250000u);
  EXPECT_EQ(readTrackdSensors(sensorsOf(2, 64, 48, 160)).size, 48u) << "a larger sensor, elsewhere";
}

TEST(TrackdSegment, WhatDoesNotFitIsRefused) {
  const std::vector<std::pair<Bytes, std::string>> faults{
      {Bytes(8), "it has 8 bytes, expected 28 at least"},
      {{}, "it has 0 bytes"},
      {sensorsOf(1, 28, 0, 68), "its sensors have 0 bytes, expected from 40 to 4096"},
      {sensorsOf(1, 28, 0x80000000U, 68), "its sensors have 2147483648 bytes"},
      {sensorsOf(0xffffffffU, 28, 40, 68), "it has 4294967295 sensors, expected 256 at most"},
      {sensorsOf(2, 28, 40, 107),
       "2 sensors of 40 bytes from byte 28 on, expected them within its 107 bytes"},
      {sensorsOf(1, 0, 40, 107), "from byte 0 on"},
      {sensorsOf(1, 0xffffffffU, 40, 107), "from byte 4294967295 on"},
  };
  for (const auto& [segment, words] : faults) {
    try {
      readTrackdSensors(segment);
      ADD_FAILURE() << words;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }
}

// By matrices of which each turns one plane.
TEST(TrackdSegment, TurnsByAzimuthElevationAndRoll) {
  std::mt19937_64 random(41);
  std::uniform_real_distribution<float> angle_deg(-180.0f, 180.0f);
  for (int i = 0; i < 200; ++i) {
    const float azimuth = angle_deg(random), elevation = angle_deg(random), roll = angle_deg(random);
    const auto sensor = readTrackdSensor(sensorOf({1, 2, 3, azimuth, elevation, roll}), 0.3048);
    ASSERT_TRUE(sensor);
    const glm::dmat3 expected = turn(2, 0, static_cast<double>(azimuth) * kDegree) *
                                turn(1, 2, static_cast<double>(elevation) * kDegree) *
                                turn(0, 1, static_cast<double>(roll) * kDegree);
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 unit(0.0);
      unit[axis] = 1.0;
      EXPECT_NEAR(glm::distance(sensor->pose.orientation * unit, expected[axis]), 0.0, 1e-12)
          << azimuth << ' ' << elevation << ' ' << roll;
    }
    EXPECT_NEAR(glm::distance(sensor->pose.position_m, glm::dvec3(0.3048, 0.6096, 0.9144)), 0.0, 1e-12);
    EXPECT_EQ(sensor->seconds, 12u);
    EXPECT_EQ(sensor->microseconds, 345678u);
  }
}

TEST(TrackdSegment, NumbersThatAreNoPoseAreRefused) {
  const float nothing = std::nanf("");
  EXPECT_FALSE(readTrackdSensor(sensorOf({nothing, 0, 0, 0, 0, 0}), 1.0));
  EXPECT_FALSE(readTrackdSensor(sensorOf({0, 0, 0, 0, nothing, 0}), 1.0));
  EXPECT_FALSE(readTrackdSensor(sensorOf({0, 0, 0, 0, 0, 1e30f}), 1.0));
  EXPECT_FALSE(readTrackdSensor(sensorOf({2000, 0, 0, 0, 0, 0}), 1.0));
  EXPECT_TRUE(readTrackdSensor(sensorOf({2000, 0, 0, 0, 0, 0}), 0.3048));
}

TEST(TrackdSegment, ReadsAWandOfEitherShape) {
  TrackdWand wand;
  Bytes own = bytesOf({1, 32, 44, 3, 2, 0, 0, 0, 0, 1, 0xffffffffU, 0x3f000000U, 0xc0000000U}, 52);
  readTrackdWand(own, wand);
  EXPECT_EQ(wand.buttons, (std::vector<std::int32_t>{0, 1, 1}));
  EXPECT_EQ(wand.axes, (std::vector<float>{0.5f, -1.0f}));
  // A header as of sensors, one wand, 2 buttons and 1 axis in 32 places each.
  Bytes other = bytesOf({1, 1, 32, 264, 1800000000, 5, 0, 1, 2, 1, 1, 0}, 32 + 264);
  const float half = 0.5f;
  std::memcpy(other.data() + 40 + 128, &half, sizeof half);
  readTrackdWand(other, wand);
  EXPECT_EQ(wand.buttons, (std::vector<std::int32_t>{1, 0}));
  EXPECT_EQ(wand.axes, std::vector<float>{0.5f});
}

TEST(TrackdSegment, AWandThatDoesNotFitIsRefused) {
  TrackdWand wand;
  for (const Bytes& segment :
       {Bytes(8), Bytes(32), bytesOf({1, 32, 44, 0xffffffffU, 2, 0, 0, 0}, 64),
        bytesOf({1, 0x80000000U, 44, 1, 1, 0, 0, 0}, 64), bytesOf({1, 32, 44, 9, 9, 0, 0, 0}, 64),
        bytesOf({1, 0, 0, 1, 1, 0, 0, 0}, 64)}) {
    EXPECT_THROW(readTrackdWand(segment, wand), std::runtime_error);
  }
  Bytes strange = bytesOf({1, 32, 36, 1, 1, 0, 0, 0, 7, 0x7fc00000U}, 40);  // an axis that is no number
  readTrackdWand(strange, wand);
  EXPECT_EQ(wand.axes, std::vector<float>{0.0f});
}

}  // namespace
}  // namespace carom
