#pragma once
// What a person sees of their tracker's noise: tracker → HeadFilter → Observer → the direction in which a
// landmark is seen, beside the same with the difference of positions for a celerity.

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <random>
#include <vector>

#include "devices/filter/aberration_error.h"
#include "devices/filter/head_filter.h"
#include "engine/spacetime/observers.h"

namespace carom::test {

inline constexpr double kLightSpeed_m_s = 1.42;
inline constexpr double kRate_hz = 60.0;
inline constexpr double kNoise_m = 0.0003;

/// A head that stands at 1.7 m, and from 20 s on walks along x: it gathers way in 1.5 s, goes on for 1 s and
/// comes to a stop, as smoothly; its steps lift and sway it by 1 cm each way.
inline constexpr double kWalkBegin_s = 20.0;
inline constexpr double kWalkEnd_s = kWalkBegin_s + 4.0;

inline Vec3 walkPosition_m(double time_s) {
  constexpr double kPeak_m_s = 1.61;  // celerity: 0.75 c
  constexpr double kGather_s = 1.5, kGoOn_s = 1.0, kStep_hz = 1.8;
  // ∫ of the smooth step 3u² − 2u³.
  const auto gathered = [](double u) {
    return u <= 0.0 ? 0.0 : u >= 1.0 ? u - 0.5 : u * u * u * (1.0 - 0.5 * u);
  };
  const auto way_s = [&](double begin_s) { return kGather_s * gathered((time_s - begin_s) / kGather_s); };
  const auto smooth = [](double u) { return u <= 0.0 ? 0.0 : u >= 1.0 ? 1.0 : u * u * (3.0 - 2.0 * u); };
  const double stop_s = kWalkBegin_s + kGather_s + kGoOn_s;
  const double along_m = kPeak_m_s * (way_s(kWalkBegin_s) - way_s(stop_s));
  const double share = smooth((time_s - kWalkBegin_s) / kGather_s) - smooth((time_s - stop_s) / kGather_s);
  const double step_rad = 2.0 * 3.14159265358979323846 * kStep_hz * (time_s - kWalkBegin_s);
  return {along_m, 1.7 + 0.01 * share * std::sin(step_rad), 0.01 * share * std::sin(0.5 * step_rad)};
}

/// Its celerity: the walker's own time is the time.
inline Vec3 walkCelerity_m_s(double time_s) {
  constexpr double kStep_s = 1e-4;  // the error of the difference is below 1e-6 m/s
  return (walkPosition_m(time_s + kStep_s) - walkPosition_m(time_s - kStep_s)) / (2.0 * kStep_s);
}

/// Which way a point at rest on the board is seen, in the head's frame.
inline Vec3 seenDirection(const Observers& observer, const Vec3& landmark_m) {
  const ObserverView view = observer.view(0.064);
  const Vec3 away_m = landmark_m - view.middle.observation.r_m;
  const Displacement light{-glm::length(away_m) / kLightSpeed_m_s, away_m};
  return glm::normalize((view.headFromBoard * light).dr_m);
}

inline double angle_rad(const Vec3& a, const Vec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// At one sample: how far from its true place a landmark is seen.
struct SwingSample {
  double time_s = 0.0;
  double beta = 0.0;  // of the head, truly
  double filtered_rad = 0.0;
  double stated_rad = 0.0;  // by the filter, one standard deviation
  double unfiltered_rad = 0.0;
};

inline Head headAt(const Vec3& position_m, const Vec3& celerity_m_s) {
  return {{position_m, glm::dquat(1.0, 0.0, 0.0, 0.0)}, celerity_m_s};
}

/// Up to `end_s`, at every sample; the landmark is far away, at right angles to the walk.
inline std::vector<SwingSample> aberrationError(double end_s, std::uint64_t seed) {
  const Vec3 landmark_m(0.0, 0.0, -1000.0);
  const Head first = headAt(walkPosition_m(0.0), Vec3(0.0));
  const Observers begin(Lorentz(kLightSpeed_m_s), {0.0, Vec3(0.0)}, first);
  Observers truth = begin, filtered = begin, unfiltered = begin;
  HeadFilter filter;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0.0, kNoise_m);
  std::vector<SwingSample> samples;
  Vec3 before_m = first.roomFromHead.position_m;
  for (int i = 0; i < end_s * kRate_hz; ++i) {
    const double time_s = i / kRate_hz, step_s = i == 0 ? 0.0 : 1.0 / kRate_hz;
    const double x = normal(random), y = normal(random), z = normal(random);
    const Vec3 position_m = walkPosition_m(time_s), celerity_m_s = walkCelerity_m_s(time_s);
    const Vec3 measured_m = position_m + Vec3(x, y, z);
    filter.add(time_s, {measured_m, glm::dquat(1.0, 0.0, 0.0, 0.0)});
    const HeadEstimate head = filter.at(time_s);
    truth.step(step_s, headAt(position_m, celerity_m_s));
    filtered.step(step_s, {head.pose, head.celerity_m_s});
    unfiltered.step(step_s, headAt(measured_m, i == 0 ? Vec3(0.0) : (measured_m - before_m) * kRate_hz));
    before_m = measured_m;
    const Vec3 seen = seenDirection(truth, landmark_m);
    samples.push_back({time_s, glm::length(betaFromU(celerity_m_s / kLightSpeed_m_s)),
                       angle_rad(seen, seenDirection(filtered, landmark_m)),
                       aberrationError_rad(head.celerity_m_s, head.celerityCovariance_m2_s2, kLightSpeed_m_s),
                       angle_rad(seen, seenDirection(unfiltered, landmark_m))});
  }
  return samples;
}

inline bool isStanding(const SwingSample& sample) {
  return sample.time_s > 5.0 && sample.time_s < kWalkBegin_s;
}
inline bool isOnTheWay(const SwingSample& sample) {
  return sample.time_s > kWalkBegin_s && sample.time_s < kWalkEnd_s;
}
inline bool isFast(const SwingSample& sample) { return sample.beta > 0.65; }

/// Root mean square of a figure over some samples, in degrees.
template <class Which>
inline double rms_deg(const std::vector<SwingSample>& samples, double SwingSample::*figure,
                      const Which& which) {
  double square = 0.0;
  int count = 0;
  for (const SwingSample& sample : samples) {
    if (!which(sample)) continue;
    square += sample.*figure * (sample.*figure);
    ++count;
  }
  return glm::degrees(std::sqrt(square / count));
}

}  // namespace carom::test
