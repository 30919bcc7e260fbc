#pragma once
// A recorded head as a measure for velocity filters: the recording is its own truth, noise is added.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace carom {

/// A velocity filter, fed one sample at a time.
using VelocityFilter = std::function<glm::dvec3(double time_s, const glm::dvec3& position_m)>;
using FilterMaker = std::function<VelocityFilter()>;

struct Path {
  std::vector<double> times_s;
  std::vector<glm::dvec3> positions_m;
  std::vector<glm::dvec3> velocities_m_s;  // of the truth
};

inline constexpr double kTrackerNoise_m = 0.0003;

/// Rows [first, end) of the 120 Hz recording (columns t, t_receive, seq, x, y, z, …), none if it is absent.
/// True velocity: central difference over three rows to each side.
inline std::optional<Path> recordedHead(std::size_t first, std::size_t end) {
  std::ifstream in(CAROM_SHARED_DIR "/data/tracking/optitrack_head_120hz.csv");
  Path all;
  for (std::string line; std::getline(in, line);) {
    double values[6] = {};
    const char* at = line.data();
    const char* const stop = at + line.size();
    int count = 0;
    for (; count < 6 && at < stop; ++count) {
      const auto [after, error] = std::from_chars(at, stop, values[count]);
      if (error != std::errc()) break;
      at = after + 1;
    }
    if (count < 6) continue;
    all.times_s.push_back(values[0]);
    all.positions_m.emplace_back(values[3], values[4], values[5]);
  }
  if (all.times_s.size() < end + 3) return std::nullopt;
  Path path;
  for (std::size_t i = std::max<std::size_t>(first, 3); i < end; ++i) {
    path.times_s.push_back(all.times_s[i]);
    path.positions_m.push_back(all.positions_m[i]);
    path.velocities_m_s.push_back((all.positions_m[i + 3] - all.positions_m[i - 3]) /
                                  (all.times_s[i + 3] - all.times_s[i - 3]));
  }
  return path;
}

/// The 120 Hz path at 60, 120 or 240 Hz; between rows by the cubic through positions and velocities.
inline Path resampled(const Path& path, int rate_hz) {
  Path result;
  const auto add = [&result](double time_s, const glm::dvec3& position_m, const glm::dvec3& velocity_m_s) {
    result.times_s.push_back(time_s);
    result.positions_m.push_back(position_m);
    result.velocities_m_s.push_back(velocity_m_s);
  };
  for (std::size_t i = 0; i + 1 < path.times_s.size(); i += rate_hz == 60 ? 2 : 1) {
    const glm::dvec3 &p = path.positions_m[i], &q = path.positions_m[i + 1];
    const glm::dvec3 &v = path.velocities_m_s[i], &w = path.velocities_m_s[i + 1];
    add(path.times_s[i], p, v);
    if (rate_hz != 240) continue;
    const double interval_s = path.times_s[i + 1] - path.times_s[i];
    add(path.times_s[i] + 0.5 * interval_s, 0.5 * (p + q) + interval_s / 8.0 * (v - w), 0.5 * (v + w));
  }
  return result;
}

inline glm::dvec3 trackerNoise(std::mt19937_64& random) {
  std::normal_distribution<double> normal(0.0, kTrackerNoise_m);
  const double x = normal(random), y = normal(random), z = normal(random);
  return {x, y, z};
}

struct FilterScore {
  double error_m_s = 0.0;  // RMS of a component
  double lag_s = 0.0;      // the shift of least RMS
  double rest_m_s = 0.0;   // RMS of a component, sensor held in one place
};

inline FilterScore scoreOf(const Path& path, int rate_hz, const FilterMaker& make) {
  constexpr double kSettle_s = 0.5;
  constexpr int kSeeds = 3;
  FilterScore score;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    std::mt19937_64 random(seed);
    VelocityFilter filter = make();
    std::vector<glm::dvec3> estimates_m_s;
    for (std::size_t i = 0; i < path.times_s.size(); ++i) {
      estimates_m_s.push_back(filter(path.times_s[i], path.positions_m[i] + trackerNoise(random)));
    }
    // RMS against the truth of `shift_s` earlier, linear between samples.
    const auto error_m_s = [&](double shift_s) {
      double square = 0.0;
      int count = 0;
      std::size_t before = 0;
      for (std::size_t i = 0; i < path.times_s.size(); ++i) {
        const double time_s = path.times_s[i] - shift_s;
        if (path.times_s[i] < path.times_s[0] + kSettle_s || time_s > path.times_s.back()) continue;
        while (before + 2 < path.times_s.size() && path.times_s[before + 1] < time_s) ++before;
        const double share =
            (time_s - path.times_s[before]) / (path.times_s[before + 1] - path.times_s[before]);
        const glm::dvec3 truth_m_s =
            (1.0 - share) * path.velocities_m_s[before] + share * path.velocities_m_s[before + 1];
        square += glm::dot(truth_m_s - estimates_m_s[i], truth_m_s - estimates_m_s[i]) / 3.0;
        ++count;
      }
      return std::sqrt(square / count);
    };
    score.error_m_s += error_m_s(0.0) / kSeeds;
    double least_m_s = 1e9, lag_s = 0.0;
    for (double shift_s = -0.010; shift_s < 0.060; shift_s += 0.0005) {
      const double shifted_m_s = error_m_s(shift_s);
      if (shifted_m_s < least_m_s) {
        least_m_s = shifted_m_s;
        lag_s = shift_s;
      }
    }
    score.lag_s += lag_s / kSeeds;

    // Twenty seconds in one place, of which the last fifteen count.
    VelocityFilter atRest = make();
    double square = 0.0;
    int count = 0;
    for (int i = 0; i < 20 * rate_hz; ++i) {
      const double time_s = static_cast<double>(i) / rate_hz;
      const glm::dvec3 estimate_m_s = atRest(time_s, glm::dvec3(0.5, 1.7, -0.3) + trackerNoise(random));
      if (time_s < 5.0) continue;
      square += glm::dot(estimate_m_s, estimate_m_s) / 3.0;
      ++count;
    }
    score.rest_m_s += std::sqrt(square / count) / kSeeds;
  }
  return score;
}

}  // namespace carom
