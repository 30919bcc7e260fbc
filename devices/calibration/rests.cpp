#include "devices/calibration/rests.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace carom {
namespace {

constexpr double kMostGap_s = 0.25;    // between samples of one rest
constexpr double kMostGlitch_s = 0.1;  // samples elsewhere that do not end it
constexpr double kGoneAway_m = 0.05;   // from a place, before it can be touched again

/// Finds rests one after the other.
class Finder {
 public:
  Finder(std::span<const TrackerSample> samples, const glm::dvec3& point_m, const RestLimits& limits)
      : samples_(samples), limits_(limits) {
    for (const TrackerSample& sample : samples) points_m_.push_back(sample.pose * point_m);
  }

  std::vector<Rest> find() {
    std::vector<Rest> rests;
    for (std::size_t first = 0; first < samples_.size();) {
      const std::size_t end = endOf(first);
      if (samples_[end - 1].time_s - samples_[first].time_s < limits_.least_s) {
        ++first;
        continue;
      }
      if (!rests.empty() && isSamePlace(rests.back(), lastEnd_, end)) {
        rests.back().end_s = samples_[end - 1].time_s;
      } else {
        rests.push_back(restBetween(first, end));
      }
      first = lastEnd_ = end;
    }
    return rests;
  }

 private:
  /// Returns the end (exclusive) of the longest stay that begins with that sample.
  std::size_t endOf(std::size_t first) const {
    glm::dvec3 sum_m(0.0);
    double count = 0.0;
    std::size_t end = first;
    for (std::size_t i = first; i < samples_.size(); ++i) {
      if (i > first && samples_[i].time_s - samples_[i - 1].time_s > kMostGap_s) break;
      const bool near = count == 0.0 || glm::distance(points_m_[i], sum_m / count) <= limits_.radius_m;
      if (near) {
        sum_m += points_m_[i];
        ++count;
        end = i + 1;
      } else if (samples_[i].time_s - samples_[end - 1].time_s > kMostGlitch_s) {
        break;
      }
    }
    return end;
  }

  /// Returns whether the stay from `from` to `end` goes on with `rest`: the point has never left its place.
  bool isSamePlace(const Rest& rest, std::size_t from, std::size_t end) const {
    for (std::size_t i = from; i < end; ++i) {
      if (samples_[i].time_s - samples_[i - 1].time_s > kMostGap_s) return false;
      if (glm::distance(points_m_[i], rest.at_m) > kGoneAway_m) return false;
    }
    return true;
  }

  Rest restBetween(std::size_t first, std::size_t end) const {
    Rest rest;
    rest.begin_s = samples_[first].time_s;
    rest.end_s = samples_[end - 1].time_s;
    rest.hasOrientation = samples_[first].hasOrientation;
    glm::dvec3 sensor_m(0.0), point_m(0.0);
    glm::dquat turn(0.0, 0.0, 0.0, 0.0);
    double squares_m2 = 0.0;
    std::vector<std::size_t> kept;
    const std::size_t anchor = medianOf(first, end);
    for (std::size_t i = first; i < end; ++i) {
      if (glm::distance(points_m_[i], points_m_[anchor]) > 2.0 * limits_.radius_m) continue;  // a glitch
      const glm::dquat& q = samples_[i].pose.orientation;
      turn = turn + (glm::dot(q, samples_[anchor].pose.orientation) < 0.0 ? -q : q);
      sensor_m += samples_[i].pose.position_m;
      point_m += points_m_[i];
      kept.push_back(i);
    }
    rest.samples = kept.size();
    const auto count = static_cast<double>(kept.size());
    rest.pose = {sensor_m / count, glm::normalize(turn)};
    rest.at_m = point_m / count;
    for (const std::size_t i : kept) {
      const glm::dvec3 miss_m = points_m_[i] - rest.at_m;
      squares_m2 += glm::dot(miss_m, miss_m);
    }
    rest.spread_m = std::sqrt(squares_m2 / count);
    return rest;
  }

  /// Returns the sample that is nearest to the median of each coordinate.
  std::size_t medianOf(std::size_t first, std::size_t end) const {
    glm::dvec3 median_m(0.0);
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<double> values_m;
      for (std::size_t i = first; i < end; ++i) values_m.push_back(points_m_[i][axis]);
      const auto middle = values_m.begin() + static_cast<std::ptrdiff_t>(values_m.size() / 2);
      std::nth_element(values_m.begin(), middle, values_m.end());
      median_m[axis] = *middle;
    }
    const auto nearest = std::min_element(points_m_.begin() + static_cast<std::ptrdiff_t>(first),
                                          points_m_.begin() + static_cast<std::ptrdiff_t>(end),
                                          [&](const auto& a, const auto& b) {
                                            return glm::distance(a, median_m) < glm::distance(b, median_m);
                                          });
    return static_cast<std::size_t>(nearest - points_m_.begin());
  }

  std::span<const TrackerSample> samples_;
  RestLimits limits_;
  std::vector<glm::dvec3> points_m_;
  std::size_t lastEnd_ = 0;
};

}  // namespace

std::vector<Rest> restsOf(std::span<const TrackerSample> samples, const glm::dvec3& point_m,
                          const RestLimits& limits) {
  return Finder(samples, point_m, limits).find();
}

/// White noise σ has second differences x₋ - 2x + x₊ of standard deviation √6 σ a component; the median
/// length of a vector of three normal components is 1.538 of that of one (χ with three degrees of freedom).
double noiseOf_m(std::span<const TrackerSample> samples) {
  if (samples.size() < 3) return 0.0;
  std::vector<double> lengths_m;
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    lengths_m.push_back(glm::length(samples[i - 1].pose.position_m - 2.0 * samples[i].pose.position_m +
                                    samples[i + 1].pose.position_m));
  }
  const auto middle = lengths_m.begin() + static_cast<std::ptrdiff_t>(lengths_m.size() / 2);
  std::nth_element(lengths_m.begin(), middle, lengths_m.end());
  return *middle / (1.538 * std::sqrt(6.0));
}

}  // namespace carom
