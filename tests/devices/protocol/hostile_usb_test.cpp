// What USB and HID decoders make of a million spoiled packets each: sound readings, and hardly any memory.

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <functional>

#include "counted_new.h"
#include "devices/filter/orientation_filter.h"
#include "devices/protocol/polhemus_decoder.h"
#include "devices/protocol/rift_decoder.h"
#include "devices/protocol/spacemouse_decoder.h"
#include "devices/rift_report.h"
#include "mutate.h"

namespace carom {
namespace {

using test::Bytes;

#if defined(__SANITIZE_THREAD__)
constexpr int kUsbPackets = 10'000;  // a hundred times slower there, and there is one thread
#elif defined(__SANITIZE_ADDRESS__)
constexpr int kUsbPackets = 100'000;
#else
constexpr int kUsbPackets = 1'000'000;
#endif
constexpr std::size_t kMostMemory = 1'000'000;  // bytes

bool sound(const Reading& reading) {
  const glm::dvec3& p = reading.pose.position_m;
  const glm::dquat& q = reading.pose.orientation;
  return glm::length(p) <= 1000.1 && std::abs(glm::length(q) - 1.0) < 1e-9 && reading.sensor >= 0 &&
         reading.index >= 0 && std::abs(reading.value) <= 1.0;  // all false for NaN
}

/// One decoder is fed with all of them, so that what one packet leaves behind meets the next.
void withstand(const std::vector<Bytes>& packets,
               const std::function<std::size_t(const Bytes&, std::vector<Reading>&)>& decode) {
  const unsigned seed = 77;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  std::vector<Reading> readings;
  std::size_t made = 0;
  for (int i = 0; i < kUsbPackets; ++i) {
    const Bytes packet =
        test::mutated(packets[random() % packets.size()], packets[random() % packets.size()], random);
    readings.clear();
    const std::size_t before = test::bytesHeld();
    made += decode(packet, readings);
    ASSERT_LT(test::bytesHeld(), before + kMostMemory) << "packet " << i;
    for (const Reading& reading : readings) ASSERT_TRUE(sound(reading)) << "packet " << i;
  }
  EXPECT_GT(made, static_cast<std::size_t>(kUsbPackets) / 100);  // enough of them still made sense
}

void append(Bytes& bytes, std::initializer_list<float> numbers) {
  for (const float number : numbers) {
    bytes.resize(bytes.size() + sizeof number);
    std::memcpy(&bytes[bytes.size() - sizeof number], &number, sizeof number);
  }
}

TEST(HostileUsb, Polhemus) {
  Bytes liberty{'L', 'Y', 2, 'C', ' ', 0, 40, 0, 1, 2, 3, 4, 5, 6, 0, 0, 1, 0, 0, 0};
  append(liberty, {50.0F, -25.0F, 12.5F, 0.5F, 0.5F, -0.5F, 0.5F});
  Bytes fastrak{'0', '3', ' '};
  append(fastrak, {50.0F, -25.0F, 12.5F, 0.5F, 0.5F, -0.5F, 0.5F});
  fastrak.push_back(' ');
  for (const PolhemusFormat format : {PolhemusFormat::liberty, PolhemusFormat::fastrak}) {
    PolhemusDecoder decoder(format);
    withstand({liberty, fastrak}, [&](const Bytes& packet, std::vector<Reading>& readings) {
      decoder.decode(packet, readings);
      return readings.size();
    });
  }
}

TEST(HostileUsb, SpaceMouse) {
  SpaceMouseDecoder decoder;
  withstand({{1, 0x5e, 1, 0xa2, 0xfe, 0, 0},
             {2, 1, 0, 2, 0, 3, 0},
             {1, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12},
             {3, 1, 0x10, 0, 4}},
            [&](const Bytes& packet, std::vector<Reading>& readings) {
              decoder.decode(packet, readings);
              return readings.size();
            });
}

TEST(HostileUsb, Rift) {
  const test::RiftSample sample{{0.0, 9.8, 0.0}, {0.1, 1.0, -0.2}};
  RiftDecoder decoder;
  OrientationFilter filter;
  std::vector<ImuSample> samples;
  withstand({test::dk1Report(65535, {sample, sample, sample}), test::dk2Report(0xffffffff, {sample, sample})},
            [&](const Bytes& packet, std::vector<Reading>& readings) {
              samples.clear();
              decoder.decode(packet, samples);
              for (const ImuSample& one : samples) {
                filter.update(1e-3, one.rate_rad_s, one.acceleration_m_s2);
                Reading reading;
                reading.pose.orientation = filter.orientation();
                readings.push_back(reading);
              }
              return readings.size();
            });
}

}  // namespace
}  // namespace carom
