// Trackers whose errors last or are rounded: a head at rest stays at rest.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <random>

#include "devices/filter/head_filter.h"
#include "devices/lasting_noise.h"
#include "devices/recorded_head.h"
#include "devices/simulated_heads.h"
#include "devices/unturned_head.h"
#include "devices/velocity_peers.h"
#include "sanitized.h"

namespace carom {
namespace {

using test::celerityOf;
using test::poseAt;

const glm::dvec3 kPlace_m(0.5, 1.7, -0.3);

// A magnetic tracker near metal: 1 mm for 50 ms. At c = 1.42 m/s, 5 mm/s turn the sky by 0.2°.
TEST(ColouredNoise, AHeadAtRestIsCalm) {
  for (const double rate_hz : test::someOf({60.0, 30.0, 120.0, 240.0})) {
    for (const double sigma_m : {0.0003, 0.001}) {
      for (const std::uint64_t seed : {1u, 2u, 3u}) {
        LastingNoise noise(seed, sigma_m, 0.05, rate_hz);
        const double rest_m_s =
            restOf_m_s(celerityOf(HeadFilter()), rate_hz, [&] { return kPlace_m + noise(); });
        EXPECT_LE(rest_m_s, 0.005) << sigma_m << " m at " << rate_hz << " Hz, seed " << seed;
      }
    }
  }
}

// What was learnt at rest serves in motion: no worse than models that are told the standard deviation alone,
// but for a tenth.
TEST(ColouredNoise, IsRememberedInMotion) {
  for (const SimulatedHead& head : simulatedHeads(60.0)) {
    HeadFilter filter;
    SingerModels<4> peer = fourSingers(0.001);
    LastingNoise noise(4, 0.001, 0.05, 60.0);
    double square = 0.0, peerSquare = 0.0;
    for (int i = -600; i < static_cast<int>(head.path.times_s.size()); ++i) {
      const std::size_t row = static_cast<std::size_t>(std::max(i, 0));
      const glm::dvec3 sample_m = head.path.positions_m[row] + noise();
      filter.add(i / 60.0, poseAt(sample_m));
      const glm::dvec3 peer_m_s = peer(i / 60.0, sample_m);
      if (i < 0) continue;
      const glm::dvec3 truth_m_s = head.path.velocities_m_s[row];
      const glm::dvec3 off_m_s = filter.at(i / 60.0).celerity_m_s - truth_m_s;
      square += glm::dot(off_m_s, off_m_s);
      peerSquare += glm::dot(peer_m_s - truth_m_s, peer_m_s - truth_m_s);
    }
    EXPECT_LT(std::sqrt(square), 1.1 * std::sqrt(peerSquare)) << head.name;
  }
}

// A head that moves without rest shows no colour: its noise is white, and known to a quarter.
TEST(ColouredNoise, MotionIsNone) {
  for (const SimulatedHead& head : simulatedHeads(60.0)) {
    std::mt19937_64 random(6);
    HeadFilter filter;
    double largest_m = 0.0;
    for (std::size_t i = 0; i < head.path.times_s.size(); ++i) {
      filter.add(head.path.times_s[i], poseAt(head.path.positions_m[i] + trackerNoise(random)));
      if (i > 300) largest_m = std::max(largest_m, filter.trackerSigma_m());
    }
    EXPECT_LT(largest_m, 1.6 * kTrackerNoise_m)
        << head.name;  // of two seconds at a time, the largest of a minute
    EXPECT_NEAR(filter.trackerSigma_m(), kTrackerNoise_m, 0.25 * kTrackerNoise_m) << head.name;
  }
}

// A tracker that rounds to q, a sensor near the edge of a step: it flips over and back, often or seldom.
TEST(RoundedPositions, TheEdgeOfAStepIsNoMotion) {
  const glm::dquat turned = glm::normalize(glm::dquat(0.9, 0.1, -0.3, 0.2));
  for (const double step_m : {0.001, 0.0005}) {
    for (const double own : {0.003, 0.01, 0.03, 0.1, 0.3}) {
      for (const double edge : {0.5, 0.49, 0.45, 0.4, 0.3, 0.2}) {
        for (const bool isTurned : {false, true}) {
          std::mt19937_64 random(7);
          const double rest_m_s = restOf_m_s(celerityOf(HeadFilter()), 60.0, [&] {
            const glm::dvec3 at_m =
                (glm::dvec3(520.0, 1700.0, -300.0) + edge) * step_m + trackerNoise(random, own * step_m);
            const glm::dvec3 rounded_m = step_m * glm::round(at_m / step_m);
            return isTurned ? turned * rounded_m : rounded_m;
          });
          EXPECT_LE(rest_m_s, 0.0005) << step_m << " m, own noise " << own << ", " << edge << " of a step";
        }
      }
    }
  }
}

// A whole head rounded to 1 mm has errors of 1/√12 mm.
TEST(RoundedPositions, AreAsGoodAsTheirErrorsAllow) {
  for (const SimulatedHead& head : simulatedHeads(60.0)) {
    HeadFilter filter;
    SingerModels<4> peer = fourSingers(0.001 / std::sqrt(12.0));
    double square = 0.0, peerSquare = 0.0;
    for (std::size_t i = 0; i < head.path.times_s.size(); ++i) {
      const glm::dvec3 sample_m = 0.001 * glm::round(1000.0 * head.path.positions_m[i]);
      const double time_s = head.path.times_s[i];
      filter.add(time_s, poseAt(sample_m));
      const glm::dvec3 peer_m_s = peer(time_s, sample_m) - head.path.velocities_m_s[i];
      const glm::dvec3 off_m_s = filter.at(time_s).celerity_m_s - head.path.velocities_m_s[i];
      if (time_s < 1.0) continue;
      square += glm::dot(off_m_s, off_m_s);
      peerSquare += glm::dot(peer_m_s, peer_m_s);
    }
    EXPECT_LT(std::sqrt(square), 1.05 * std::sqrt(peerSquare)) << head.name;
  }
}

// A walker whose tracker sends every sample twice: steps of equal length that are no rounding.
TEST(RoundedPositions, RepeatedSamplesAreNone) {
  std::mt19937_64 random(9);
  TrackerNoise noise(0.0003);
  glm::dvec3 sample_m(0.0);
  for (int i = 0; i < 1200; ++i) {
    if (i % 2 == 0) sample_m = glm::dvec3(0.01 * i, 0.0, 0.0) + trackerNoise(random);
    noise.add(i / 120.0, sample_m);
    ASSERT_TRUE(noise.sigma_m() < 0.0012) << i;
  }
}

}  // namespace
}  // namespace carom
