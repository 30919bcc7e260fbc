// Prints how well velocity filters do on a recorded head: RMS error of a component, of the walking parts
// apart, lag, noise at rest, and the time a sample takes, at 60, 120 and 240 Hz.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "devices/head_filter.h"
#include "devices/recorded_head.h"

namespace {

using namespace carom;

// One component of a Kalman filter with Singer's acceleration (1970), state (x, v, a).
struct Singer {
  double x[3] = {};
  double p[3][3] = {};

  void start(double position_m, double sigma_m_s2) {
    x[0] = position_m;
    p[0][0] = kTrackerNoise_m * kTrackerNoise_m;
    p[1][1] = 0.25;
    p[2][2] = sigma_m_s2 * sigma_m_s2;
  }
  void predict(double t, double sigma, double tau) {
    const double u = t / tau, e = std::exp(-u), f = tau * (1 - e), g = tau * tau * (u - 1 + e);
    x[0] += t * x[1] + g * x[2];
    x[1] += f * x[2];
    x[2] *= e;
    const double a[3][3] = {{1, t, g}, {0, 1, f}, {0, 0, e}};
    double ap[3][3] = {}, result[3][3] = {};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k) ap[i][j] += a[i][k] * p[k][j];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k) result[i][j] += ap[i][k] * a[j][k];
    // Singer's closed forms, divided by their common factor.
    const double c = 2 * sigma * sigma / tau, e2 = e * e, t2 = tau * tau, t3 = t2 * tau;
    result[0][0] += c * t3 * t2 / 2 * (1 - e2 + 2 * u + 2 * u * u * u / 3 - 2 * u * u - 4 * u * e);
    result[0][1] += c * t2 * t2 / 2 * (e2 + 1 - 2 * e + 2 * u * e - 2 * u + u * u);
    result[0][2] += c * t3 / 2 * (1 - e2 - 2 * u * e);
    result[1][1] += c * t3 / 2 * (4 * e - 3 - e2 + 2 * u);
    result[1][2] += c * t2 / 2 * (e2 + 1 - 2 * e);
    result[2][2] += c * tau / 2 * (1 - e2);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) p[i][j] = i <= j ? result[i][j] : result[j][i];
  }
  double correct(double position_m) {
    const double s = p[0][0] + kTrackerNoise_m * kTrackerNoise_m, innovation = position_m - x[0];
    const double k[3] = {p[0][0] / s, p[1][0] / s, p[2][0] / s}, row[3] = {p[0][0], p[0][1], p[0][2]};
    for (int i = 0; i < 3; ++i) {
      x[i] += k[i] * innovation;
      for (int j = 0; j < 3; ++j) p[i][j] -= k[i] * row[j];
    }
    return -0.5 * (innovation * innovation / s + std::log(s));
  }
};

// Interacting multiple models: Singer with accelerations of `Sigmas`, tau 0.15 s, dwell 1 s, each axis
// with its own covariance, the axes scored together.
template <std::size_t kModels>
class SingerModels {
 public:
  explicit SingerModels(const std::array<double, kModels>& sigmas_m_s2) : sigmas_(sigmas_m_s2) {}

  glm::dvec3 operator()(double time_s, const glm::dvec3& position_m) {
    const double interval_s = time_s - time_s_;
    time_s_ = time_s;
    if (!started_) {
      started_ = true;
      for (std::size_t m = 0; m < kModels; ++m) {
        probability_[m] = 1.0 / kModels;
        for (int axis = 0; axis < 3; ++axis) axes_[m][axis].start(position_m[axis], sigmas_[m]);
      }
      return glm::dvec3(0.0);
    }
    const double leaves = kModels == 1 ? 0.0 : (1.0 - std::exp(-interval_s)) / (kModels - 1.0);
    std::array<double, kModels> prior{}, score{};
    const auto before = axes_;
    for (std::size_t j = 0; j < kModels; ++j) {
      std::array<double, kModels> weight{};
      for (std::size_t i = 0; i < kModels; ++i) {
        weight[i] = probability_[i] * (i == j ? 1.0 - (kModels - 1.0) * leaves : leaves);
        prior[j] += weight[i];
      }
      score[j] = std::log(prior[j]);
      for (int axis = 0; axis < 3; ++axis) {
        Singer mixed;
        for (std::size_t i = 0; i < kModels; ++i)
          for (int k = 0; k < 3; ++k) mixed.x[k] += weight[i] / prior[j] * before[i][axis].x[k];
        for (std::size_t i = 0; i < kModels; ++i)
          for (int k = 0; k < 3; ++k)
            for (int l = 0; l < 3; ++l)
              mixed.p[k][l] += weight[i] / prior[j] *
                               (before[i][axis].p[k][l] +
                                (before[i][axis].x[k] - mixed.x[k]) * (before[i][axis].x[l] - mixed.x[l]));
        mixed.predict(interval_s, sigmas_[j], 0.15);
        score[j] += mixed.correct(position_m[axis]);
        axes_[j][axis] = mixed;
      }
    }
    const double best = *std::max_element(score.begin(), score.end());
    double sum = 0.0;
    for (std::size_t m = 0; m < kModels; ++m) sum += probability_[m] = std::exp(score[m] - best);
    glm::dvec3 velocity_m_s(0.0);
    for (std::size_t m = 0; m < kModels; ++m) {
      probability_[m] /= sum;
      for (int axis = 0; axis < 3; ++axis) velocity_m_s[axis] += probability_[m] * axes_[m][axis].x[1];
    }
    return velocity_m_s;
  }

 private:
  std::array<double, kModels> sigmas_;
  std::array<double, kModels> probability_{};
  std::array<std::array<Singer, 3>, kModels> axes_{};
  double time_s_ = 0.0;
  bool started_ = false;
};

// The 1 € filter (Casiez 2012) of each coordinate; velocity is the difference of filtered positions.
class OneEuro {
 public:
  OneEuro(double leastCutoff_hz, double speedCoefficient, double slopeCutoff_hz)
      : leastCutoff_hz_(leastCutoff_hz),
        speedCoefficient_(speedCoefficient),
        slopeCutoff_hz_(slopeCutoff_hz) {}

  glm::dvec3 operator()(double time_s, const glm::dvec3& position_m) {
    if (!started_) {
      started_ = true;
      time_s_ = time_s;
      filtered_ = position_m;
      return glm::dvec3(0.0);
    }
    const double interval_s = time_s - time_s_;
    time_s_ = time_s;
    const auto share = [interval_s](double cutoff_hz) {
      return 1.0 / (1.0 + 1.0 / (2.0 * std::numbers::pi * cutoff_hz * interval_s));
    };
    glm::dvec3 velocity_m_s;
    for (int axis = 0; axis < 3; ++axis) {
      slope_[axis] +=
          share(slopeCutoff_hz_) * ((position_m[axis] - filtered_[axis]) / interval_s - slope_[axis]);
      const double cutoff_hz = leastCutoff_hz_ + speedCoefficient_ * std::abs(slope_[axis]);
      const double step_m = share(cutoff_hz) * (position_m[axis] - filtered_[axis]);
      filtered_[axis] += step_m;
      velocity_m_s[axis] = step_m / interval_s;
    }
    return velocity_m_s;
  }

 private:
  double leastCutoff_hz_, speedCoefficient_, slopeCutoff_hz_;
  double time_s_ = 0.0;
  bool started_ = false;
  glm::dvec3 filtered_{0.0}, slope_{0.0};
};

VelocityFilter ours() {
  return [filter = HeadFilter()](double time_s, const glm::dvec3& position_m) mutable {
    filter.add(time_s, {position_m, glm::dquat(1.0, 0.0, 0.0, 0.0)});
    return filter.at(time_s).celerity_m_s;
  };
}

VelocityFilter rawDifference() {
  return [last_s = 0.0, last_m = glm::dvec3(0.0), first = true](double time_s,
                                                                const glm::dvec3& position_m) mutable {
    const glm::dvec3 velocity_m_s = first ? glm::dvec3(0.0) : (position_m - last_m) / (time_s - last_s);
    first = false;
    last_s = time_s;
    last_m = position_m;
    return velocity_m_s;
  };
}

/// The least of some runs: what other programs take of the machine is not the filter's.
double microsecondsPerSample(const Path& path, const FilterMaker& make) {
  constexpr int kRuns = 7;
  double least_us = 1e9;
  for (int run = 0; run < kRuns; ++run) {
    VelocityFilter filter = make();
    glm::dvec3 sum(0.0);
    const auto begin = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < path.times_s.size(); ++i) sum += filter(path.times_s[i], path.positions_m[i]);
    const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - begin;
    if (sum.x == sum.x)
      least_us = std::min(least_us, spent.count() / static_cast<double>(path.times_s.size()));
  }
  return least_us;
}

}  // namespace

int main() {
  const auto path = recordedHead(2000, 8000);
  if (!path) {
    std::puts("no recording of a head in " CAROM_SHARED_DIR ": nothing to measure");
    return 0;
  }
  struct Entry {
    const char* name;
    std::function<FilterMaker(int rate_hz)> make;
  };
  const std::array<Entry, 5> entries = {{
      {"carom", [](int) { return ours; }},
      {"4 Singer models", [](int) { return [] {
                                      return SingerModels<4>({0.005, 0.1, 0.4, 1.0});
                                    }; }},
      {"Singer Kalman", [](int) { return [] { return SingerModels<1>({0.4}); }; }},
      {"1 euro, tuned",
       [](int rate_hz) {
         return [rate_hz] {
           return OneEuro(0.5, 960.0 / rate_hz, rate_hz == 60 ? 3.0 : rate_hz == 120 ? 5.0 : 8.0);
         };
       }},
      {"raw difference", [](int) { return rawDifference; }},
  }};
  constexpr int kSeeds = 20;
  for (const int rate_hz : {60, 120, 240}) {
    const Path head = resampled(*path, rate_hz);
    const std::vector<bool> walking = walkingParts(head);
    const auto walked = std::count(walking.begin(), walking.end(), true);
    std::printf("%d Hz, mean of %d seeds (walking: %.0f %% of the time)\n", rate_hz, kSeeds,
                100.0 * static_cast<double>(walked) / static_cast<double>(walking.size()));
    std::printf("  %-16s %10s %10s %8s %10s %12s %12s\n", "", "RMS mm/s", "walking", "lag ms", "rest mm/s",
                "set off ms", "us a sample");
    for (const Entry& entry : entries) {
      const FilterMaker make = entry.make(rate_hz);
      const FilterScore score = scoreOf(head, rate_hz, make, kSeeds);
      std::printf("  %-16s %10.2f %10.2f %8.1f %10.2f %12.1f %12.2f\n", entry.name, 1e3 * score.error_m_s,
                  1e3 * score.walking_m_s, 1e3 * score.lag_s, 1e3 * score.rest_m_s, 1e3 * score.setOff_s,
                  microsecondsPerSample(head, make));
    }
  }
}
