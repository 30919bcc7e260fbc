#pragma once
// Other filters of velocity, told the tracker's noise where they know what to do with it, and how well they
// and another find recorded heads with noise of several sizes.

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "devices/recorded_head.h"
#include "devices/tracker/tracker.h"
#include "places.h"

namespace carom {

// One component of a Kalman filter with Singer's acceleration (1970), state (x, v, a).
struct Singer {
  double x[3] = {};
  double p[3][3] = {};
  double noise_m2 = 0.0;

  void start(double position_m, double sigma_m_s2, double noise_m) {
    noise_m2 = noise_m * noise_m;
    x[0] = position_m;
    p[0][0] = noise_m2;
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
    const double s = p[0][0] + noise_m2, innovation = position_m - x[0];
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
  SingerModels(const std::array<double, kModels>& sigmas_m_s2, double noise_m)
      : sigmas_(sigmas_m_s2), noise_m_(noise_m) {}

  glm::dvec3 operator()(double time_s, const glm::dvec3& position_m) {
    const double interval_s = time_s - time_s_;
    time_s_ = time_s;
    if (!started_) {
      started_ = true;
      for (std::size_t m = 0; m < kModels; ++m) {
        probability_[m] = 1.0 / kModels;
        for (int axis = 0; axis < 3; ++axis) {
          axes_[m][axis].start(position_m[axis], sigmas_[m], noise_m_);
        }
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
        mixed.noise_m2 = noise_m_ * noise_m_;
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
  double noise_m_;
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

/// The slope of the straight line of least squares through the last 66 ms.
class StraightLine {
 public:
  glm::dvec3 operator()(double time_s, const glm::dvec3& position_m) {
    constexpr double kSpan_s = 0.0668;
    samples_.emplace_back(time_s, position_m);
    while (samples_.front().first < time_s - kSpan_s) samples_.pop_front();
    const double count = static_cast<double>(samples_.size());
    double meanTime_s = 0.0, square_s2 = 0.0;
    for (const auto& [each_s, each_m] : samples_) meanTime_s += each_s / count;
    glm::dvec3 product(0.0);
    for (const auto& [each_s, each_m] : samples_) {
      square_s2 += (each_s - meanTime_s) * (each_s - meanTime_s);
      product += (each_s - meanTime_s) * each_m;
    }
    return square_s2 > 0.0 ? product / square_s2 : glm::dvec3(0.0);
  }

 private:
  std::deque<std::pair<double, glm::dvec3>> samples_;
};

inline SingerModels<4> fourSingers(double noise_m) { return {{0.005, 0.1, 0.4, 1.0}, noise_m}; }
inline SingerModels<1> oneSinger(double noise_m) { return {{0.4}, noise_m}; }
inline OneEuro tunedOneEuro(int rate_hz) {
  return {0.5, 960.0 / rate_hz, rate_hz == 60 ? 3.0 : rate_hz == 120 ? 5.0 : 8.0};
}

/// A recording, smoothed by two passes of Savitzky-Golay (cubics over 100 ms, which shift nothing) at 240 Hz,
/// at 60 or 120 Hz; velocity is the central difference at 240 Hz.
inline Path smoothed(const std::vector<TrackerSample>& rows, int rate_hz, double longest_s) {
  constexpr int kHalf = 12, kFine_hz = 240;
  std::vector<glm::dvec3> fine_m;
  std::size_t before = 0;
  const double end_s = std::min(rows.back().time_s, rows.front().time_s + longest_s);
  for (int i = 0; rows.front().time_s + static_cast<double>(i) / kFine_hz < end_s; ++i) {
    const double time_s = rows.front().time_s + static_cast<double>(i) / kFine_hz;
    while (rows[before + 1].time_s <= time_s) ++before;
    const double share = (time_s - rows[before].time_s) / (rows[before + 1].time_s - rows[before].time_s);
    fine_m.push_back((1.0 - share) * rows[before].pose.position_m + share * rows[before + 1].pose.position_m);
  }
  const int count = static_cast<int>(fine_m.size());
  for (int pass = 0; pass < 2; ++pass) {
    const std::vector<glm::dvec3> from_m = fine_m;
    for (int i = kHalf; i < count - kHalf; ++i) {
      // Weights (S4 − S2 k²)/(n S4 − S2²) with S2, S4 the sums of k² and k⁴.
      double s2 = 0.0, s4 = 0.0;
      for (int k = -kHalf; k <= kHalf; ++k) {
        s2 += k * k;
        s4 += static_cast<double>(k) * k * k * k;
      }
      fine_m[i] = glm::dvec3(0.0);
      for (int k = -kHalf; k <= kHalf; ++k) {
        fine_m[i] += (s4 - s2 * k * k) / ((2.0 * kHalf + 1.0) * s4 - s2 * s2) * from_m[i + k];
      }
    }
  }
  Path path;
  for (int i = 2 * kHalf; i < count - 2 * kHalf; i += kFine_hz / rate_hz) {
    path.times_s.push_back(static_cast<double>(i) / kFine_hz);
    path.positions_m.push_back(fine_m[i]);
    path.velocities_m_s.push_back(0.5 * kFine_hz * (fine_m[i + 1] - fine_m[i - 1]));
  }
  return path;
}

struct NoisyHead {
  const char* recording;
  int rate_hz;
  double noise_m;
  bool isRested;  ///< 15 s in one place before
  Path path;
};

/// The recordings, at 60 and 120 Hz with noise of 0.3 to 2 mm.
inline std::vector<NoisyHead> noisyHeads() {
  std::vector<NoisyHead> heads;
  for (const char* recording : {"optitrack_head_120hz", "tum_fr1_xyz"}) {
    const std::string file = std::string(CAROM_TESTS_DIR "/data/tracking/") + recording + ".csv";
    const std::vector<TrackerSample> rows = recordedRows(file);
    for (const int rate_hz : {60, 120}) {
      const Path path = smoothed(rows, rate_hz, 60.0);
      for (const double noise_m : {0.0003, 0.001, 0.002}) {
        for (const bool isRested : {false, true})
          heads.push_back({recording, rate_hz, noise_m, isRested, path});
      }
    }
  }
  return heads;
}

/// RMS of a component from half a second on.
inline double errorOf_m_s(const NoisyHead& head, const FilterMaker& make, int seeds) {
  constexpr double kRest_s = 15.0, kSettle_s = 0.5;
  double square = 0.0;
  int count = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    VelocityFilter filter = make();
    const double begin_s = head.path.times_s.front();
    for (double time_s = begin_s - kRest_s; head.isRested && time_s < begin_s - 0.5 / head.rate_hz;
         time_s += 1.0 / head.rate_hz) {
      filter(time_s, head.path.positions_m[0] + trackerNoise(random, head.noise_m));
    }
    for (std::size_t i = 0; i < head.path.times_s.size(); ++i) {
      const glm::dvec3 off_m_s =
          filter(head.path.times_s[i], head.path.positions_m[i] + trackerNoise(random, head.noise_m)) -
          head.path.velocities_m_s[i];
      if (head.path.times_s[i] < begin_s + kSettle_s) continue;
      square += glm::dot(off_m_s, off_m_s) / 3.0;
      ++count;
    }
  }
  return std::sqrt(square / count);
}

struct NoisyScore {
  std::array<double, 4> peers_m_s{};  ///< four Singers, one, a straight line, 1 €
  double own_m_s = 0.0;
  double ratio() const { return own_m_s / *std::min_element(peers_m_s.begin(), peers_m_s.end()); }
};

inline NoisyScore noisyScoreOf(const NoisyHead& head, const FilterMaker& own, int seeds) {
  const std::array<FilterMaker, 4> peers = {
      [&] { return fourSingers(head.noise_m); }, [&] { return oneSinger(head.noise_m); },
      [] { return StraightLine(); }, [&] { return tunedOneEuro(head.rate_hz); }};
  NoisyScore score;
  for (std::size_t i = 0; i < peers.size(); ++i) score.peers_m_s[i] = errorOf_m_s(head, peers[i], seeds);
  score.own_m_s = errorOf_m_s(head, own, seeds);
  return score;
}

}  // namespace carom
