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
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "devices/tracker/tracker.h"
#include "places.h"

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

/// Returns the rows of a recording: times and positions, of columns t, x, y, z, … or
/// t, t_receive, seq, x, y, z, …. Throws if the file cannot be read.
inline std::vector<TrackerSample> recordedRows(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file);
  std::vector<TrackerSample> rows;
  std::size_t columns = 0;
  for (std::string line; std::getline(in, line);) {
    std::vector<double> values;
    const char* const stop = line.data() + line.size();
    for (const char* at = line.data(); at < stop;) {
      double value = 0.0;
      const auto [after, error] = std::from_chars(at, stop, value);
      if (error != std::errc()) break;
      values.push_back(value);
      at = after + 1;
    }
    if (columns == 0) columns = values.size();
    if (values.size() < 8 || values.size() != columns) {
      columns = 0;
      continue;
    }
    const std::size_t x = columns - 7;
    TrackerSample row;
    row.time_s = values[0];
    row.pose.position_m = {values[x], values[x + 1], values[x + 2]};
    rows.push_back(row);
  }
  return rows;
}

/// Returns rows [first, end) of the 120 Hz recording. True velocity: central difference over
/// three rows to each side.
inline Path recordedHead(std::size_t first, std::size_t end) {
  Path all;
  for (const TrackerSample& row : recordedRows(CAROM_TESTS_DIR "/data/tracking/optitrack_head_120hz.csv")) {
    all.times_s.push_back(row.time_s);
    all.positions_m.push_back(row.pose.position_m);
  }
  if (all.times_s.size() < end + 3) throw std::runtime_error("the recording is too short");
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

inline glm::dvec3 trackerNoise(std::mt19937_64& random, double sigma_m = kTrackerNoise_m) {
  std::normal_distribution<double> normal(0.0, sigma_m);
  const double x = normal(random), y = normal(random), z = normal(random);
  return {x, y, z};
}

/// Which samples are of walking: the head is carried along at over 0.25 m/s, over a second.
inline std::vector<bool> walkingParts(const Path& path) {
  constexpr double kHalf_s = 0.5, kCarried_m_s = 0.25;
  std::vector<bool> walking(path.times_s.size(), false);
  std::size_t first = 0, last = 0;
  for (std::size_t i = 0; i < path.times_s.size(); ++i) {
    while (path.times_s[first] < path.times_s[i] - kHalf_s) ++first;
    while (last + 1 < path.times_s.size() && path.times_s[last] < path.times_s[i] + kHalf_s) ++last;
    const double carried_m = glm::distance(path.positions_m[last], path.positions_m[first]);
    walking[i] = carried_m > kCarried_m_s * 2.0 * kHalf_s;
  }
  return walking;
}

struct FilterScore {
  double error_m_s = 0.0;    // RMS of a component
  double walking_m_s = 0.0;  // the same of the walking parts alone
  double lag_s = 0.0;        // the shift of least RMS
  double rest_m_s = 0.0;     // RMS of a component, sensor held in one place
  double setOff_s =
      0.0;  // lag of setting off from there: ∫ (true − estimated) dt over the change of velocity
};

/// From rest to 0.5 m/s in 0.7 s (a smooth step, 1.1 m/s² at most), after so long.
inline constexpr double kSetOff_s = 20.0, kGoing_m_s = 0.5, kGather_s = 0.7;

inline double goneAfterSettingOff_m(double since_s) {
  const double u = since_s / kGather_s;
  if (u <= 0.0) return 0.0;
  return kGoing_m_s * kGather_s * (u < 1.0 ? u * u * u * (1.0 - 0.5 * u) : u - 0.5);
}

/// The path that a filter has been given from the beginning is the integral of the truth: what its estimates
/// sum up to less comes late.
inline double setOffLag_s(int rate_hz, const FilterMaker& make, std::mt19937_64& random) {
  VelocityFilter filter = make();
  double late_m = 0.0;
  for (int i = 0; i < static_cast<int>((kSetOff_s + 1.0) * rate_hz); ++i) {
    const double time_s = static_cast<double>(i) / rate_hz, since_s = time_s - kSetOff_s;
    const double gone_m = goneAfterSettingOff_m(since_s);
    const glm::dvec3 estimate_m_s =
        filter(time_s, glm::dvec3(0.5 + gone_m, 1.7, -0.3) + trackerNoise(random));
    if (since_s < 0.0) continue;
    constexpr double kStep_s = 1e-4;
    const double true_m_s =
        (goneAfterSettingOff_m(since_s + kStep_s) - goneAfterSettingOff_m(since_s - kStep_s)) /
        (2.0 * kStep_s);
    late_m += (true_m_s - estimate_m_s.x) / rate_hz;
  }
  return late_m / kGoing_m_s;
}

inline FilterScore scoreOf(const Path& path, int rate_hz, const FilterMaker& make, int seeds = 3) {
  constexpr double kSettle_s = 0.5;
  const std::vector<bool> walking = walkingParts(path), all(path.times_s.size(), true);
  FilterScore score;
  for (int seed = 1; seed <= seeds; ++seed) {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    VelocityFilter filter = make();
    std::vector<glm::dvec3> estimates_m_s;
    for (std::size_t i = 0; i < path.times_s.size(); ++i) {
      estimates_m_s.push_back(filter(path.times_s[i], path.positions_m[i] + trackerNoise(random)));
    }
    // RMS against the truth of `shift_s` earlier, linear between samples.
    const auto error_m_s = [&](double shift_s, const std::vector<bool>& counted) {
      double square = 0.0;
      int count = 0;
      std::size_t before = 0;
      for (std::size_t i = 0; i < path.times_s.size(); ++i) {
        const double time_s = path.times_s[i] - shift_s;
        if (!counted[i] || path.times_s[i] < path.times_s[0] + kSettle_s || time_s > path.times_s.back())
          continue;
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
    score.error_m_s += error_m_s(0.0, all) / seeds;
    score.walking_m_s += error_m_s(0.0, walking) / seeds;
    double least_m_s = 1e9, lag_s = 0.0;
    for (double shift_s = -0.010; shift_s < 0.060; shift_s += 0.0005) {
      const double shifted_m_s = error_m_s(shift_s, all);
      if (shifted_m_s < least_m_s) {
        least_m_s = shifted_m_s;
        lag_s = shift_s;
      }
    }
    score.lag_s += lag_s / seeds;

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
    score.rest_m_s += std::sqrt(square / count) / seeds;
    score.setOff_s += setOffLag_s(rate_hz, make, random) / seeds;
  }
  return score;
}

}  // namespace carom
