#include "devices/protocol/rift_decoder.h"

#include <gtest/gtest.h>

#include <random>

#include "devices/rift_report.h"

namespace carom {
namespace {

using test::RiftSample;
using Bytes = std::vector<std::uint8_t>;

std::vector<ImuSample> decoded(RiftDecoder& decoder, const Bytes& report) {
  std::vector<ImuSample> samples;
  EXPECT_TRUE(decoder.decode(report, samples));
  return samples;
}

void expectNear(const glm::dvec3& value, const glm::dvec3& expected) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(value[i], expected[i], 0.5001e-4);  // half a step of its numbers
}

TEST(RiftDecoder, ReadsAPackedVectorByHand) {
  Bytes report(62);
  report[0] = 1;
  report[1] = 1;
  // x = 1, y = -1, z = 2: 000000000000000000001 111111111111111111111 000000000000000000010 0
  const Bytes packed{0x00, 0x00, 0x0f, 0xff, 0xff, 0xc0, 0x00, 0x04};
  std::copy(packed.begin(), packed.end(), report.begin() + 16);  // of the gyroscope
  RiftDecoder decoder;
  const auto samples = decoded(decoder, report);
  ASSERT_EQ(samples.size(), 1u);
  EXPECT_EQ(samples[0].rate_rad_s, 1e-4 * glm::dvec3(1, -1, 2));
  EXPECT_EQ(samples[0].acceleration_m_s2, glm::dvec3(0.0));
}

TEST(RiftDecoder, ReadsWhatAFirmwareWrites) {
  const unsigned seed = 1;
  std::mt19937 random(seed);
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::uniform_real_distribution<double> any(-100.0, 100.0);  // near what 21 bits hold: 104.8
  const auto vector = [&] { return glm::dvec3(any(random), any(random), any(random)); };
  for (int i = 0; i < 1000; ++i) {
    const std::vector<RiftSample> made{{vector(), vector()}, {vector(), vector()}};
    RiftDecoder decoder;
    for (const Bytes& report : {test::dk1Report(7, made), test::dk2Report(7000, made)}) {
      const auto samples = decoded(decoder, report);
      ASSERT_EQ(samples.size(), 2u);
      for (std::size_t k = 0; k < 2; ++k) {
        expectNear(samples[k].acceleration_m_s2, made[k].acceleration_m_s2);
        expectNear(samples[k].rate_rad_s, made[k].rate_rad_s);
      }
      EXPECT_NEAR(samples[0].device_s, 0.006, 1e-12);
      EXPECT_NEAR(samples[1].device_s, 0.007, 1e-12);
    }
  }
}

TEST(RiftDecoder, ClocksGoOnWhenTheyWrap) {
  RiftDecoder dk1, dk2;
  for (std::uint32_t i = 0; i < 200000; ++i) {  // the DK1's wraps three times
    const auto one = decoded(dk1, test::dk1Report(static_cast<std::uint16_t>(65000 + i), {{}}));
    ASSERT_NEAR(one.at(0).device_s, 65.0 + 1e-3 * i, 1e-9);
  }
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const auto two = decoded(dk2, test::dk2Report(0xfff00000U + 1000 * i, {{}}));
    ASSERT_NEAR(two.at(0).device_s, 1e-6 * 0xfff00000U + 1e-3 * i, 1e-9);
  }
}

TEST(RiftDecoder, SamplesThatWereNotSentAreCounted) {
  RiftDecoder decoder;
  Bytes dk1 = test::dk1Report(10, {{}, {}, {}}), dk2 = test::dk2Report(10, {{}, {}});
  dk1[1] = 255;
  dk2[3] = 3;
  EXPECT_EQ(decoded(decoder, dk1).size(), 3u);
  EXPECT_EQ(decoded(decoder, dk2).size(), 2u);
  EXPECT_EQ(decoder.missed(), 252u + 1u);
}

TEST(RiftDecoder, TooShortReportsAreRefusedOthersPassedOver) {
  RiftDecoder decoder;
  std::vector<ImuSample> samples;
  for (std::size_t size = 0; size < 62; ++size) {
    EXPECT_FALSE(decoder.decode(Bytes(size, 1), samples));
  }
  EXPECT_FALSE(decoder.decode(Bytes(63, 11), samples));
  EXPECT_TRUE(decoder.decode(Bytes(64, 9), samples));
  EXPECT_TRUE(samples.empty());
}

}  // namespace
}  // namespace carom
