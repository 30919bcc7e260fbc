// How well the celerity of a recorded head is found: RMS error, lag and noise at rest.

#include "devices/recorded_head.h"

#include <gtest/gtest.h>

#include "devices/filter/head_filter.h"
#include "devices/unturned_head.h"
#include "devices/velocity_peers.h"
#include "sanitized.h"

namespace carom {
namespace {

struct Limit {
  int rate_hz;
  double error_m_s, lag_s, rest_m_s;
};

// At least as good as the best filter known for such data (four Singer models) in error, lag and rest at
// once.
TEST(RecordedHead, CelerityIsFoundWithinTheLimits) {
  const Path path = recordedHead(2000, 8000);
  for (const Limit limit : test::someOf({Limit{60, 0.0088, 0.011, 0.0004}, Limit{120, 0.0080, 0.010, 0.0004},
                                         Limit{240, 0.0071, 0.009, 0.0004}})) {
    const FilterScore score = scoreOf(resampled(path, limit.rate_hz), limit.rate_hz, test::headFilter);
    EXPECT_LE(score.error_m_s, limit.error_m_s) << limit.rate_hz << " Hz";
    EXPECT_LE(score.lag_s, limit.lag_s) << limit.rate_hz << " Hz";
    EXPECT_LE(score.rest_m_s, limit.rest_m_s) << limit.rate_hz << " Hz";
  }
}

// The stated standard deviation and lag against what the recording shows.
TEST(RecordedHead, StatedErrorAndLagAreThoseSeen) {
  const Path path = recordedHead(2000, 8000);
  for (const int rate_hz : test::someOf({60, 120, 240})) {
    double variance = 0.0, lag_s = 0.0;
    int count = 0;
    const auto watched = [&]() -> VelocityFilter {
      return [&, filter = HeadFilter()](double time_s, const glm::dvec3& position_m) mutable {
        filter.add(time_s, test::poseAt(position_m));
        const HeadEstimate head = filter.at(time_s);
        if (time_s < 20.0) return head.celerity_m_s;  // settling, and the sensor at rest
        variance += head.sigma_m_s * head.sigma_m_s;
        lag_s += head.lag_s;
        ++count;
        return head.celerity_m_s;
      };
    };
    const FilterScore score = scoreOf(resampled(path, rate_hz), rate_hz, watched);
    EXPECT_LT(score.error_m_s, std::sqrt(variance / count)) << rate_hz << " Hz";
    EXPECT_GT(score.error_m_s, 0.5 * std::sqrt(variance / count)) << rate_hz << " Hz";
    EXPECT_NEAR(lag_s / count, score.lag_s, 0.006) << rate_hz << " Hz";
  }
}

// Whatever the noise, and in motion from the first sample on: not far behind the best of four other filters,
// of which two are told the noise.
TEST(RecordedHead, NoiseIsLearntInMotion) {
  std::vector<NoisyHead> heads = noisyHeads();
  heads.resize(test::casesOf(heads.size()));
  for (const NoisyHead& head : heads) {
    const NoisyScore score = noisyScoreOf(head, test::headFilter, 1);
    EXPECT_LE(score.ratio(), 1.1) << head.recording << " at " << head.rate_hz << " Hz with " << head.noise_m
                                  << " m, " << (head.isRested ? "rested: " : "from motion: ")
                                  << score.own_m_s;
  }
}

}  // namespace
}  // namespace carom
