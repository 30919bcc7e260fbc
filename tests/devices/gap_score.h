#pragma once
// How wrong a velocity filter is after samples have been missing for a while.

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <random>

#include "devices/recorded_head.h"

namespace carom {

struct GapScore {
  double error_m_s = 0.0;  ///< RMS of a component in the 0.3 s after gaps
  double worst_m_s = 0.0;  ///< the largest error there
};

/// Takes samples out of the path for `gap_s` every two seconds and a little, beginning elsewhere with each
/// seed.
inline GapScore gapScoreOf(const Path& path, double gap_s, const FilterMaker& make, int seeds,
                           double noise_m = kTrackerNoise_m) {
  constexpr double kEvery_s = 2.13, kAfter_s = 0.3, kFirst_s = 3.0;
  GapScore score;
  double square = 0.0;
  int count = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    VelocityFilter filter = make();
    const double first_s = path.times_s.front() + kFirst_s + kEvery_s * (seed - 1) / seeds;
    for (std::size_t i = 0; i < path.times_s.size(); ++i) {
      const glm::dvec3 noise_m3 = trackerNoise(random, noise_m);
      const double since_s = path.times_s[i] - first_s;
      const double into_s = since_s < 0.0 ? 2.0 : std::fmod(since_s, kEvery_s);
      if (into_s < gap_s) continue;
      const glm::dvec3 off_m_s =
          filter(path.times_s[i], path.positions_m[i] + noise_m3) - path.velocities_m_s[i];
      if (since_s < 0.0 || into_s >= gap_s + kAfter_s) continue;
      square += glm::dot(off_m_s, off_m_s) / 3.0;
      score.worst_m_s = std::max(score.worst_m_s, glm::length(off_m_s));
      ++count;
    }
  }
  score.error_m_s = std::sqrt(square / count);
  return score;
}

}  // namespace carom
