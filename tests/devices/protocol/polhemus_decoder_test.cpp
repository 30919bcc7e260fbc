#include "devices/protocol/polhemus_decoder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace carom {
namespace {

using Bytes = std::vector<std::uint8_t>;

// A LIBERTY record, byte by byte: station 2, at 12345 ms, frame 1000, distortion level 3, (50, -25, 12.5) cm,
// turned by a third of a turn about (1, 1, 1).
const Bytes kLiberty{'L',  'Y',  2,    'C',  ' ',  0,    40,   0,                       //
                     0x39, 0x30, 0,    0,    0xe8, 0x03, 0,    0,    3, 0,    0,    0,  //
                     0,    0,    0x48, 0x42, 0,    0,    0xc8, 0xc1, 0, 0,    0x48, 0x41, 0, 0,
                     0,    0x3f, 0,    0,    0,    0x3f, 0,    0,    0, 0x3f, 0,    0,    0, 0x3f};

// A FASTRAK record: station 3, the same pose.
const Bytes kFastrak{'0', '3', ' ',  0, 0, 0x48, 0x42, 0, 0, 0xc8, 0xc1, 0, 0, 0x48, 0x41, 0,
                     0,   0,   0x3f, 0, 0, 0,    0x3f, 0, 0, 0,    0x3f, 0, 0, 0,    0x3f, ' '};

std::vector<Reading> decoded(PolhemusDecoder& decoder, const Bytes& bytes) {
  std::vector<Reading> readings;
  decoder.decode(bytes, readings);
  return readings;
}

void expectThePose(const Reading& reading) {
  EXPECT_EQ(reading.kind, Reading::Kind::pose);
  EXPECT_TRUE(reading.hasOrientation);
  EXPECT_NEAR(glm::length(reading.pose.position_m - glm::dvec3(0.5, -0.25, 0.125)), 0.0, 1e-15);
  EXPECT_EQ(reading.pose.orientation, glm::dquat(0.5, 0.5, 0.5, 0.5));
}

TEST(PolhemusDecoder, ReadsALibertyRecord) {
  PolhemusDecoder decoder(PolhemusFormat::liberty);
  const auto readings = decoded(decoder, kLiberty);
  ASSERT_EQ(readings.size(), 1u);
  expectThePose(readings[0]);
  EXPECT_EQ(readings[0].sensor, 1);
  EXPECT_NEAR(readings[0].device_s, 12.345, 1e-12);
  EXPECT_EQ(readings[0].quality, 0.25);
}

TEST(PolhemusDecoder, ReadsAFastrakRecord) {
  PolhemusDecoder decoder(PolhemusFormat::fastrak);
  const auto readings = decoded(decoder, kFastrak);
  ASSERT_EQ(readings.size(), 1u);
  expectThePose(readings[0]);
  EXPECT_EQ(readings[0].sensor, 2);
  EXPECT_TRUE(std::isnan(readings[0].device_s));
  EXPECT_TRUE(std::isnan(readings[0].quality));
}

TEST(PolhemusDecoder, AFlaggedRecordIsLost) {
  Bytes liberty = kLiberty, fastrak = kFastrak;
  liberty[4] = 'a';
  std::fill(liberty.begin() + 20, liberty.end(), std::uint8_t{0xff});  // NaN everywhere
  fastrak[2] = 'E';
  PolhemusDecoder one(PolhemusFormat::liberty), other(PolhemusFormat::fastrak);
  for (const auto& readings : {decoded(one, liberty), decoded(other, fastrak)}) {
    ASSERT_EQ(readings.size(), 1u);
    EXPECT_EQ(readings[0].kind, Reading::Kind::lost);
    EXPECT_EQ(readings[0].pose.position_m, glm::dvec3(0.0));
  }
}

/// A stream of records whose x is their number (cm), cut wherever `random` likes.
TEST(PolhemusDecoder, RecordsComeJoinedAndSplit) {
  const unsigned seed = 20260;
  std::mt19937 random(seed);
  SCOPED_TRACE("seed " + std::to_string(seed));
  for (const bool fastrak : {false, true}) {
    Bytes stream;
    for (int i = 0; i < 500; ++i) {
      Bytes record = fastrak ? kFastrak : kLiberty;
      const auto x = static_cast<float>(i);
      std::memcpy(&record[fastrak ? 3 : 20], &x, sizeof x);
      stream.insert(stream.end(), record.begin(), record.end());
    }
    PolhemusDecoder decoder(fastrak ? PolhemusFormat::fastrak : PolhemusFormat::liberty);
    std::vector<Reading> readings;
    for (std::size_t at = 0; at < stream.size();) {
      const std::size_t size = std::min<std::size_t>(random() % 130, stream.size() - at);
      decoder.decode({&stream[at], size}, readings);
      at += size;
    }
    ASSERT_EQ(readings.size(), 500u);
    for (std::size_t i = 0; i < 500; ++i)
      ASSERT_NEAR(readings[i].pose.position_m.x, 0.01 * static_cast<double>(i), 1e-12);
    EXPECT_EQ(decoder.refused(), 0u);
  }
}

/// Whatever is cut out of the stream, at most the record it was cut from and one that its rest runs into are
/// lost.
TEST(PolhemusDecoder, FindsTheNextRecordAfterEveryCut) {
  for (const bool fastrak : {false, true}) {
    const Bytes& record = fastrak ? kFastrak : kLiberty;
    for (std::size_t from = 0; from < record.size(); ++from) {
      for (std::size_t count = 1; from + count <= record.size(); ++count) {
        Bytes stream;
        for (int i = 0; i < 6; ++i) stream.insert(stream.end(), record.begin(), record.end());
        const auto begin = stream.begin() + static_cast<std::ptrdiff_t>(2 * record.size() + from);
        stream.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
        PolhemusDecoder decoder(fastrak ? PolhemusFormat::fastrak : PolhemusFormat::liberty);
        const auto readings = decoded(decoder, stream);
        // A byte of a number where a status should be may look like a fault: then one is lost, never misread.
        int poses = 0;
        for (const Reading& reading : readings) {
          if (reading.kind == Reading::Kind::lost) continue;
          expectThePose(reading);
          ++poses;
        }
        ASSERT_GE(poses, 4) << from << ' ' << count;
        ASSERT_LE(readings.size(), 5u);
        EXPECT_LE(decoder.refused(), 1u);
      }
    }
  }
}

TEST(PolhemusDecoder, HeadersThatLieAreNotBelieved) {
  for (const auto& [index, value] : {std::pair<std::size_t, int>{0, 'l'},
                                     {1, 'X'},
                                     {2, 0},
                                     {2, 17},
                                     {3, 'c'},
                                     {6, 41},
                                     {6, 0},
                                     {7, 0xff}}) {
    Bytes liar = kLiberty;
    liar[index] = static_cast<std::uint8_t>(value);
    liar.insert(liar.end(), kLiberty.begin(), kLiberty.end());
    PolhemusDecoder decoder(PolhemusFormat::liberty);
    const auto readings = decoded(decoder, liar);
    ASSERT_EQ(readings.size(), 1u) << index;
    EXPECT_EQ(decoder.refused(), 1u);
  }
}

TEST(PolhemusDecoder, NumbersThatAreNoPoseAreRefused) {
  const float nan = std::numeric_limits<float>::quiet_NaN(),
              infinite = std::numeric_limits<float>::infinity();
  for (const float bad : {nan, infinite, -infinite, 1e30F, 2e5F}) {  // 2 km
    for (std::size_t at = 20; at < 48; at += 4) {
      Bytes record = kLiberty;
      std::memcpy(&record[at], &bad, sizeof bad);
      PolhemusDecoder decoder(PolhemusFormat::liberty);
      EXPECT_TRUE(decoded(decoder, record).empty()) << bad << " at " << at;
    }
  }
}

TEST(PolhemusDecoder, TheClockGoesOnWhenItsCounterWraps) {
  PolhemusDecoder decoder(PolhemusFormat::liberty);
  double last_s = 0.0;
  for (std::uint32_t i = 0; i < 100; ++i) {
    Bytes record = kLiberty;
    const std::uint32_t time_ms = 0xffffff00U + 8 * i, frame = 0xfffffff0U + i;
    std::memcpy(&record[8], &time_ms, 4);
    std::memcpy(&record[12], &frame, 4);
    const auto readings = decoded(decoder, record);
    ASSERT_EQ(readings.size(), 1u);
    if (i > 0) {
      EXPECT_NEAR(readings[0].device_s - last_s, 0.008, 1e-8);  // doubles at 4e6 s
    }
    last_s = readings[0].device_s;
  }
  EXPECT_EQ(decoder.missed(), 0u);
}

TEST(PolhemusDecoder, FramesThatNeverCameAreCountedForEachStation) {
  PolhemusDecoder decoder(PolhemusFormat::liberty);
  const auto frame = [&](std::uint8_t station, std::uint32_t count) {
    Bytes record = kLiberty;
    record[2] = station;
    std::memcpy(&record[12], &count, 4);
    decoded(decoder, record);
  };
  frame(1, 7), frame(2, 7), frame(1, 8), frame(2, 8);
  EXPECT_EQ(decoder.missed(), 0u);
  frame(1, 12), frame(2, 9);
  EXPECT_EQ(decoder.missed(), 3u);
  frame(1, 0);  // the device started again
  EXPECT_EQ(decoder.missed(), 3u);
}

}  // namespace
}  // namespace carom
