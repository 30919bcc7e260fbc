#include "devices/filter/celerity_filter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <random>
#include <vector>

#include "devices/tracker/simulated_tracker.h"
#include "sanitized.h"

namespace carom {
namespace {

constexpr double kSigma_m = 0.0003;

glm::dvec3 noise(std::mt19937_64& random, double sigma_m = kSigma_m) {
  std::normal_distribution<double> normal(0.0, sigma_m);
  const double x = normal(random), y = normal(random), z = normal(random);
  return {x, y, z};
}

// Feeds positions at an even rate.
CelerityFilter fed(double rate_hz, double seconds, const std::function<glm::dvec3(double)>& position_m,
                   const std::function<void(double, const CelerityFilter&)>& each = {}) {
  CelerityFilter filter(kSigma_m);
  filter.start(0.0, position_m(0.0));
  for (int i = 1; i <= seconds * rate_hz; ++i) {
    filter.update(i / rate_hz, position_m(i / rate_hz));
    if (each) each(i / rate_hz, filter);
  }
  return filter;
}

// The same models by another way: the matrix exponential summed up, the noise in a thousand slices, each
// pair of models mixed by itself.
class Reference {
 public:
  static constexpr int kModels = 7;

  glm::dvec3 next(double time_s, const glm::dvec3& position_m) {
    const double interval_s = time_s - time_s_;
    time_s_ = time_s;
    noise_.add(time_s, position_m);
    const auto before = beliefs_;
    double total = 0.0;
    for (int j = 0; j < kModels; ++j) {
      Belief& to = beliefs_[j];
      if (started_) {
        to = mixed(before, j, interval_s);
        advance(to, kTable[j], interval_s);
        correct(to, position_m);
      } else {
        begin(to, kTable[j], position_m);
      }
      total += to.weight;
    }
    started_ = true;
    glm::dvec3 celerity_m_s(0.0);
    for (Belief& belief : beliefs_) {
      belief.weight /= total;
      celerity_m_s += belief.weight * glm::dvec3(belief.axes[0][1], belief.axes[1][1], belief.axes[2][1]);
    }
    return celerity_m_s;
  }

 private:
  struct Model {
    double sigma_m_s2, perStop_s, dwell_s, share;  // perStop_s: 1/T
  };
  static constexpr std::array<Model, kModels> kTable = {{{0.0008, 1.0 / 0.07, 20.0, 1.0},
                                                         {0.0007, 1.0 / 0.333, 0.38, 1.0},
                                                         {0.0107, 0.0, 1.0, 0.3},
                                                         {0.143, 0.0, 0.38, 1.0},
                                                         {0.56, 0.0, 0.38, 1.0},
                                                         {1.2, 0.0, 0.38, 1.0},
                                                         {4.3, 0.0, 0.583, 0.04}}};
  static constexpr double kTau_s = 0.185, kDriveTau_s = 0.0185;

  struct Belief {
    double weight = 0.0;
    std::array<glm::dvec4, 3> axes{};
    glm::dmat4 covariance{0.0};
  };

  static glm::dmat4 exponential(const Model& model, double time_s) {
    // Columns are what a unit of position, celerity, acceleration, drive changes a second.
    const glm::dmat4 rates(glm::dvec4(0.0), glm::dvec4(1.0, -model.perStop_s, 0.0, 0.0),
                           glm::dvec4(0.0, 1.0, -1.0 / kTau_s, 0.0),
                           glm::dvec4(0.0, 0.0, 1.0, -1.0 / kDriveTau_s));
    glm::dmat4 sum(1.0), term(1.0);
    for (int k = 1; k < 40; ++k) sum += term = term * rates * (time_s / k);
    return sum;
  }

  static Belief mixed(const std::array<Belief, kModels>& before, int j, double interval_s) {
    Belief to;
    std::array<double, kModels> share;
    for (int i = 0; i < kModels; ++i) {
      const double stays = std::exp(-interval_s / kTable[i].dwell_s);
      double others = 0.0;
      for (int k = 0; k < kModels; ++k) others += k == i ? 0.0 : kTable[k].share;
      share[i] = before[i].weight * (i == j ? stays : (1.0 - stays) * kTable[j].share / others);
      to.weight += share[i];
    }
    for (int i = 0; i < kModels; ++i) {
      share[i] /= to.weight;
      for (int axis = 0; axis < 3; ++axis) to.axes[axis] += share[i] * before[i].axes[axis];
    }
    for (int i = 0; i < kModels; ++i) {
      to.covariance += share[i] * before[i].covariance;
      for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec4 apart = before[i].axes[axis] - to.axes[axis];
        to.covariance += share[i] / 3.0 * glm::outerProduct(apart, apart);
      }
    }
    return to;
  }

  static void advance(Belief& belief, const Model& model, double interval_s) {
    constexpr int kSlices = 1000;
    const glm::dmat4 phi = exponential(model, interval_s), slice = exponential(model, interval_s / kSlices);
    for (glm::dvec4& axis : belief.axes) axis = phi * axis;
    // Of the drive, so that acceleration has its sigma in the long run.
    const double density = 2.0 * model.sigma_m_s2 * model.sigma_m_s2 * (kTau_s + kDriveTau_s) /
                           (kTau_s * kTau_s * kDriveTau_s * kDriveTau_s);
    glm::dmat4 noise(0.0);
    glm::dvec4 response = exponential(model, 0.5 * interval_s / kSlices)[3];
    for (int i = 0; i < kSlices; ++i) {
      noise += density * interval_s / kSlices * glm::outerProduct(response, response);
      response = slice * response;
    }
    belief.covariance = phi * belief.covariance * glm::transpose(phi) + noise;
  }

  void correct(Belief& belief, const glm::dvec3& position_m) const {
    const glm::dvec4 column = belief.covariance[0];
    const double variance_m2 = column[0] + noise_.sigma_m() * noise_.sigma_m();
    double likelihood = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
      const double off_m = position_m[axis] - belief.axes[axis][0];
      belief.axes[axis] += column * (off_m / variance_m2);
      likelihood *= 1e-4 * std::exp(-0.5 * off_m * off_m / variance_m2) / std::sqrt(variance_m2);
    }
    belief.covariance -= glm::outerProduct(column, column) / variance_m2;
    belief.weight *= std::pow(likelihood, 0.36);
  }

  void begin(Belief& belief, const Model& model, const glm::dvec3& position_m) const {
    belief.weight = 1.0;
    for (int axis = 0; axis < 3; ++axis) belief.axes[axis] = {position_m[axis], 0.0, 0.0, 0.0};
    // Acceleration and drive have settled after ten seconds of noise.
    Belief settled;
    for (int i = 0; i < 100; ++i) advance(settled, {model.sigma_m_s2, 1.0, 1.0, 1.0}, 0.1);
    belief.covariance = settled.covariance;
    for (int i = 0; i < 4; ++i) belief.covariance[0][i] = belief.covariance[i][0] = 0.0;
    for (int i = 0; i < 4; ++i) belief.covariance[1][i] = belief.covariance[i][1] = 0.0;
    belief.covariance[0][0] = noise_.sigma_m() * noise_.sigma_m();
    belief.covariance[1][1] = 0.25;
  }

  std::array<Belief, kModels> beliefs_;
  double time_s_ = 0.0;
  bool started_ = false;
  TrackerNoise noise_{kSigma_m};
};

TEST(CelerityFilter, IsThatOfItsModels) {
  SimulatedTracker person({.seed = 19});
  std::vector<TrackerSample> samples;
  person.poll(12.0, samples);
  CelerityFilter filter(kSigma_m);
  Reference reference;
  double fastest_m_s = 0.0;
  bool first = true;
  for (std::size_t i = 0; i < samples.size(); i += i % 7 == 0 ? 2 : 1) {  // some are missing
    const TrackerSample& sample = samples[i];
    const glm::dvec3 expected_m_s = reference.next(sample.time_s, sample.pose.position_m);
    if (first) {
      filter.start(sample.time_s, sample.pose.position_m);
      first = false;
      continue;
    }
    filter.update(sample.time_s, sample.pose.position_m);
    // A fiftieth of what the celerity of a still head does.
    ASSERT_TRUE(glm::distance(filter.celerity_m_s(), expected_m_s) < 2e-6)
        << i << ": " << glm::distance(filter.celerity_m_s(), expected_m_s);
    fastest_m_s = std::max(fastest_m_s, glm::length(expected_m_s));
  }
  EXPECT_GT(fastest_m_s, 0.1);  // it did move
}

// Even motion is a steady state of the moving models; those of standing keep a trace of belief, and it holds
// the celerity back. At c = 1.42 m/s this turns the sky by 0.1°, and its noise then turns it by 0.3°.
constexpr double kBias_m_s = 0.0025;

TEST(CelerityFilter, EvenMotionHasHardlyAnyBias) {
  for (const double speed_m_s : {0.05, 0.3, 1.5, 5.0}) {
    const glm::dvec3 celerity_m_s = speed_m_s * glm::normalize(glm::dvec3(1.3, -0.1, 0.7));
    for (const double rate_hz : {60.0, 240.0}) {
      const CelerityFilter exact = fed(rate_hz, 5.0, [&](double t) { return t * celerity_m_s; });
      EXPECT_TRUE(glm::distance(exact.celerity_m_s(), celerity_m_s) < kBias_m_s)
          << speed_m_s << " m/s at " << rate_hz << " Hz";
      EXPECT_TRUE(glm::distance(exact.position_m(), 5.0 * celerity_m_s) < 0.00005) << rate_hz;

      std::mt19937_64 random(1);
      glm::dvec3 sum(0.0);
      int count = 0;
      fed(
          rate_hz, 60.0, [&](double t) { return t * celerity_m_s + noise(random); },
          [&](double t, const CelerityFilter& filter) {
            if (t < 2.0) return;
            sum += filter.celerity_m_s() - celerity_m_s;
            ++count;
          });
      EXPECT_TRUE(glm::length(sum / static_cast<double>(count)) < kBias_m_s)
          << speed_m_s << " m/s at " << rate_hz << " Hz";
    }
  }
}

TEST(CelerityFilter, AnAtRestUserIsStill) {
  for (const double rate_hz : {60.0, 120.0, 240.0}) {
    std::mt19937_64 random(2);
    double square = 0.0;
    int count = 0;
    fed(
        rate_hz, 60.0, [&](double) { return glm::dvec3(1, 2, 3) + noise(random); },
        [&](double t, const CelerityFilter& filter) {
          if (t < 5.0) return;
          square += glm::dot(filter.celerity_m_s(), filter.celerity_m_s()) / 3.0;
          ++count;
        });
    EXPECT_LT(std::sqrt(square / count), 0.0006) << rate_hz;  // m/s
  }
}

// Constant acceleration, closed form: the celerity is late by the stated lag, and a little by the trace of
// belief in standing that even slow motion leaves.
TEST(CelerityFilter, StatesItsLag) {
  for (const double rate_hz : {60.0, 120.0, 240.0}) {
    for (const double acceleration_m_s2 : {0.3, 1.0, 2.0}) {
      double error_s = 0.0, stated_s = 0.0;
      std::mt19937_64 random(3);
      fed(
          rate_hz, 4.0,
          [&](double t) { return glm::dvec3(0.5 * acceleration_m_s2 * t * t, 0.0, 0.0) + noise(random); },
          [&](double t, const CelerityFilter& filter) {
            if (t < 1.0) return;
            error_s += (t * acceleration_m_s2 - filter.celerity_m_s().x) / acceleration_m_s2 / rate_hz / 3.0;
            stated_s += filter.lag_s() / rate_hz / 3.0;
          });
      EXPECT_NEAR(error_s / stated_s, 1.1, 0.25) << rate_hz << " Hz, " << acceleration_m_s2 << " m/s²";
      EXPECT_GT(stated_s, 0.001);
      EXPECT_LT(stated_s, 0.04);
    }
  }
}

// Noise and motion are isotropic: turning the axes turns the estimate.
TEST(CelerityFilter, IsTheSameInTurnedAxes) {
  const glm::dquat turn = glm::normalize(glm::dquat(0.3, -0.5, 0.7, 0.2));
  SimulatedTracker person({.seed = 12});
  std::vector<TrackerSample> samples;
  person.poll(30.0, samples);
  CelerityFilter plain(kSigma_m), turned(kSigma_m);
  plain.start(0.0, samples[0].pose.position_m);
  turned.start(0.0, turn * samples[0].pose.position_m);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    plain.update(samples[i].time_s, samples[i].pose.position_m);
    turned.update(samples[i].time_s, turn * samples[i].pose.position_m);
    ASSERT_TRUE(glm::distance(turn * plain.celerity_m_s(), turned.celerity_m_s()) < 1e-9) << i;
  }
}

// The stated covariance against what the errors are: never much too small.
TEST(CelerityFilter, StatesItsError) {
  for (const double rate_hz : {60.0, 240.0}) {
    SimulatedPerson person{.seed = 13, .rate_hz = rate_hz};
    SimulatedTracker tracker(person);
    CelerityFilter filter(kSigma_m);
    std::vector<TrackerSample> samples;
    double relative = 0.0;
    int count = 0, beyondThree = 0;
    for (int i = 0; i < 120 * rate_hz; ++i) {
      samples.clear();
      tracker.poll(i / rate_hz, samples);
      if (i == 0) {
        filter.start(0.0, samples[0].pose.position_m);
        continue;
      }
      filter.update(samples[0].time_s, samples[0].pose.position_m);
      const glm::dvec3 error_m_s = filter.celerity_m_s() - tracker.truth().velocity_m_s;
      const glm::dmat3 covariance = filter.celerityCovariance_m2_s2();
      for (int axis = 0; axis < 3; ++axis) {
        const double square = error_m_s[axis] * error_m_s[axis] / covariance[axis][axis];
        relative += square;
        beyondThree += !(square <= 9.0);
        ++count;
      }
    }
    EXPECT_GT(relative / count, 0.2) << rate_hz;
    EXPECT_LT(relative / count, 1.1) << rate_hz;
    EXPECT_LT(beyondThree, 0.015 * count) << rate_hz;
  }
}

// Minutes on end, still or not, near the origin or far from it, with much noise or none: nothing is lost to
// rounding.
TEST(CelerityFilter, StaysSoundForLong) {
  for (const double rate_hz : test::someOf({30.0, 1000.0})) {
    for (const double sigma_m : {0.0, 0.00001, 0.003}) {
      for (const double far_m : {0.0, 1000.0}) {
        std::mt19937_64 random(16);
        const auto path_m = [&](double t) {
          const double way_m = t < 30.0 ? 0.0 : 0.3 * std::sin(2.0 * (t - 30.0));
          return glm::dvec3(far_m + way_m, 1.7, -far_m) + noise(random, sigma_m);
        };
        double least_m2_s2 = 1.0, most_m2_s2 = 0.0;
        const CelerityFilter filter = fed(rate_hz, 50.0, path_m, [&](double, const CelerityFilter& each) {
          const glm::dmat3 covariance = each.celerityCovariance_m2_s2();
          for (int axis = 0; axis < 3; ++axis) {
            least_m2_s2 = std::min(least_m2_s2, covariance[axis][axis]);
            most_m2_s2 = std::max(most_m2_s2, covariance[axis][axis]);
          }
        });
        const double truth_m_s = 0.6 * std::cos(2.0 * 20.0);
        EXPECT_TRUE(std::abs(filter.celerity_m_s().x - truth_m_s) < 0.2) << rate_hz << " " << sigma_m;
        EXPECT_TRUE(least_m2_s2 > 0.0) << rate_hz << " " << sigma_m << " " << far_m;
        EXPECT_TRUE(most_m2_s2 < 1.0) << rate_hz << " " << sigma_m << " " << far_m;
      }
    }
  }
}

// Uneven times and missing samples cost little beside the same mean rate.
TEST(CelerityFilter, TakesUnevenTimes) {
  SimulatedTracker tracker({.seed = 14, .rate_hz = 480.0, .noise_m = 0.0});
  std::mt19937_64 random(15);
  std::vector<TrackerSample> samples;
  std::vector<TrueMotion> truth;
  for (int i = 0; i < 480 * 90; ++i) {
    tracker.poll(i / 480.0, samples);
    truth.push_back(tracker.truth());
  }
  const auto error_m_s = [&](const std::function<std::size_t()>& stride) {
    CelerityFilter filter(kSigma_m);
    filter.start(0.0, samples[0].pose.position_m);
    double square = 0.0;
    int count = 0;
    for (std::size_t i = stride(); i < samples.size(); i += stride(), ++count) {
      filter.update(samples[i].time_s, samples[i].pose.position_m + noise(random));
      const glm::dvec3 error = filter.celerity_m_s() - truth[i].velocity_m_s;
      square += glm::dot(error, error) / 3.0;
    }
    return std::sqrt(square / count);
  };
  const double even_m_s = error_m_s([] { return std::size_t{8}; });
  const double uneven_m_s = error_m_s([&] { return random() % 10 == 0 ? 16 : 4 + random() % 8; });
  EXPECT_LT(even_m_s, 0.009);
  EXPECT_LT(uneven_m_s, 1.15 * even_m_s);
}

TEST(CelerityFilter, ClosedFormOfPrediction) {
  const CelerityFilter filter = fed(120.0, 3.0, [](double t) { return glm::dvec3(0.8 * t, 0, 0); });
  EXPECT_NEAR(filter.predictedPosition_m(0.05).x, 0.8 * 3.05, kSigma_m);
  EXPECT_EQ(filter.celerityChange_m2_s2(0.0), 0.0);
  EXPECT_GT(filter.celerityChange_m2_s2(0.05), 0.0);
}

}  // namespace
}  // namespace carom
