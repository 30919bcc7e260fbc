#include "devices/protocol/natnet_decoder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "devices/natnet_sender.h"
#include "places.h"

namespace carom {
namespace {

using test::NatnetSender;
using Bytes = NatnetSender::Bytes;
using Packet = NatnetDecoder::Packet;
using Kind = Reading::Kind;

constexpr float kSine = 0.19866933f, kCosine = 0.98006658f;  // of 0.2 rad
const std::vector<NatnetSender::Body> kBodies{{1, 0.5f, 1.75f, -0.25f, 0.0f, kSine, 0.0f, kCosine},
                                              {2, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, false}};

TEST(NatnetDecoder, ReadsEveryVersion) {
  for (const auto& [major, minor] : {std::pair{3, 0}, {3, 1}, {4, 0}, {4, 1}, {4, 2}}) {
    SCOPED_TRACE(testing::Message() << "version " << major << '.' << minor);
    const NatnetSender sender(major, minor);
    NatnetDecoder decoder;
    std::vector<Reading> readings;
    EXPECT_EQ(decoder.decode(sender.frame(7, kBodies, 500.0, 0.012), readings), Packet::other)
        << "not yet known";
    ASSERT_EQ(decoder.decode(sender.serverInfo(), readings), Packet::server);
    EXPECT_EQ(decoder.server()->application, "Test");
    EXPECT_EQ(decoder.server()->major, major);
    EXPECT_EQ(decoder.server()->ticksPerSecond, 1e7);
    ASSERT_EQ(decoder.decode(sender.frame(7, kBodies, 500.0, 0.012), readings), Packet::frame);
    EXPECT_EQ(decoder.frame(), 7u);
    ASSERT_EQ(readings.size(), 2u);
    EXPECT_EQ(readings[0].kind, Kind::pose);
    EXPECT_EQ(readings[0].sensor, 1);
    EXPECT_EQ(readings[0].pose.position_m, glm::dvec3(0.5, 1.75, -0.25));
    EXPECT_NEAR(readings[0].pose.orientation.y, std::sin(0.2), 1e-7);  // floats
    EXPECT_NEAR(readings[0].device_s, 500.0, 1e-7);                    // ticks
    EXPECT_NEAR(readings[0].latency_s, 0.012, 2e-7);
    EXPECT_EQ(readings[1].kind, Kind::lost);
    EXPECT_EQ(readings[1].sensor, 2);
  }
}

TEST(NatnetDecoder, ReadsARecordedFrame) {
  const std::filesystem::path file = CAROM_TESTS_DIR "/data/tracking/natnet_v3_mocapframe.bin";
  std::ifstream in(file, std::ios::binary);
  const Bytes packet{std::istreambuf_iterator<char>(in), {}};
  NatnetDecoder decoder;
  std::vector<Reading> readings;
  decoder.decode(NatnetSender(3, 0).serverInfo(), readings);
  ASSERT_EQ(decoder.decode(packet, readings), Packet::frame);
  EXPECT_EQ(decoder.frame(), 162734u);
  ASSERT_EQ(readings.size(), 1u);
  EXPECT_EQ(readings[0].kind, Kind::pose);
  // Its markers lie about the body's place, at a height of 1.45 m.
  EXPECT_NEAR(readings[0].pose.position_m.x, 0.1744, 1e-4);
  EXPECT_NEAR(readings[0].pose.position_m.y, 1.4471, 1e-4);
  EXPECT_NEAR(readings[0].pose.position_m.z, -0.7343, 1e-4);
  // Its clock read 0x149cdd85af2 when it was sent, 18204 ticks after the exposure; taken for ticks of 10 MHz.
  EXPECT_NEAR(readings[0].device_s, 0x149cdd85af2 * 1e-7, 1e-7);
  EXPECT_NEAR(readings[0].latency_s, 0.0018204, 1e-9);
}

TEST(NatnetDecoder, EveryCutIsRefused) {
  for (const int minor : {0, 1}) {
    const NatnetSender sender(4, minor);
    NatnetDecoder decoder;
    std::vector<Reading> readings;
    decoder.decode(sender.serverInfo(), readings);
    const Bytes whole = sender.frame(7, kBodies, 500.0, 0.012);
    // The last six bytes, flags and an end mark, tell nothing.
    for (std::size_t size = 0; size + 6 + (minor ? 8 : 0) < whole.size(); ++size) {
      Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
      EXPECT_EQ(decoder.decode(cut, readings), Packet::refused) << size;
      if (size >= 4) {  // and with a size that agrees
        cut[2] = static_cast<std::uint8_t>(size - 4);
        cut[3] = static_cast<std::uint8_t>((size - 4) >> 8);
        EXPECT_EQ(decoder.decode(cut, readings), Packet::refused) << size;
      }
    }
    EXPECT_TRUE(readings.empty());
  }
}

TEST(NatnetDecoder, WithoutAnExposureTheArrivalOfTheCamerasDataCounts) {
  const NatnetSender sender(3, 0);
  NatnetDecoder decoder;
  std::vector<Reading> readings;
  decoder.decode(sender.serverInfo(), readings);
  Bytes packet = sender.frame(7, kBodies, 500.0, 0.012);
  const auto exposure = packet.end() - 6 - 24;
  std::fill(exposure, exposure + 8, std::uint8_t{0});
  ASSERT_EQ(decoder.decode(packet, readings), Packet::frame);
  EXPECT_NEAR(readings.at(0).latency_s, 0.006, 2e-7);
  std::fill(exposure, exposure + 24, std::uint8_t{0});
  readings.clear();
  ASSERT_EQ(decoder.decode(packet, readings), Packet::frame);
  EXPECT_EQ(readings.at(0).device_s, 1234.5) << "time since the start";
  EXPECT_EQ(readings.at(0).latency_s, 0.0);
}

}  // namespace
}  // namespace carom
