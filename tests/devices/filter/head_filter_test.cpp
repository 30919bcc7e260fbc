#include "devices/filter/head_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <random>
#include <thread>
#include <vector>

#include "counted_new.h"
#include "devices/tracker/recorded_tracker.h"
#include "devices/tracker/simulated_tracker.h"
#include "sanitized.h"

namespace carom {
namespace {

constexpr double kRate_hz = 60.0;
constexpr double kFrame_s = 1.0 / kRate_hz;
constexpr double kSlew_m_s = 1.0;  // how fast a pose may come over to where samples came back

Pose at(const glm::dvec3& position_m) { return {position_m, glm::dquat(1.0, 0.0, 0.0, 0.0)}; }

// A head on a given path with noise of 0.3 mm, sampled at 60 Hz.
class Walker {
 public:
  explicit Walker(std::function<glm::dvec3(double)> path) : path_(std::move(path)) {}

  SampleUse sample(double time_s) {
    const double x = normal_(random_), y = normal_(random_), z = normal_(random_);
    return filter.add(time_s, at(path_(time_s) + glm::dvec3(x, y, z)));
  }
  /// Samples from one frame to before another.
  void sample(int first, int end) {
    for (int i = first; i < end; ++i) ASSERT_EQ(sample(i * kFrame_s), SampleUse::used) << i;
  }

  HeadFilter filter;

 private:
  std::function<glm::dvec3(double)> path_;
  std::mt19937_64 random_{21};
  std::normal_distribution<double> normal_{0.0, 0.0003};
};

glm::dvec3 moveUnseen(double time_s) { return {time_s, 1.7, 0.0}; }  // 1 m/s along x
glm::dvec3 stand(double) { return {0.0, 1.7, 0.0}; }

TEST(HeadFilter, BeforeTheFirstSampleNothingIsKnown) {
  const HeadEstimate head = HeadFilter().at(3.0);
  EXPECT_EQ(head.known, Known::lost);
  EXPECT_EQ(head.celerity_m_s, glm::dvec3(0.0));
  EXPECT_EQ(head.pose.position_m, glm::dvec3(0.0));
  EXPECT_GE(head.sigma_m_s, 0.5);
  EXPECT_STREQ(toString(head.known), "lost");
}

TEST(HeadFilter, TheCelerityFadesInWhereItIsAskedTo) {
  Walker plain(moveUnseen), fading(moveUnseen);
  EXPECT_FALSE(fading.filter.hasStarted());
  fading.filter.fadeInFrom(0.25);
  plain.sample(0, 60);
  fading.sample(0, 60);
  EXPECT_TRUE(fading.filter.hasStarted());
  for (const auto& [time_s, share] : {std::pair(1.0, 1.0), std::pair(1.01, 1.0)}) {
    EXPECT_EQ(fading.filter.at(time_s).celerity_m_s, share * plain.filter.at(time_s).celerity_m_s);
    EXPECT_EQ(fading.filter.at(time_s).pose.position_m, plain.filter.at(time_s).pose.position_m);
  }
  fading.filter.fadeInFrom(0.8);
  EXPECT_NEAR(fading.filter.at(1.0).celerity_m_s.x, 0.4 * plain.filter.at(1.0).celerity_m_s.x, 1e-12);
  fading.filter.fadeInFrom(1.5);
  EXPECT_EQ(fading.filter.at(1.0).celerity_m_s, glm::dvec3(0.0)) << "it has not begun";
}

TEST(HeadFilter, SaysHowThePoseIsKnown) {
  Walker walker(moveUnseen);
  walker.sample(0, 120);
  const double last_s = 119 * kFrame_s;
  EXPECT_EQ(walker.filter.at(last_s).known, Known::measured);
  EXPECT_EQ(walker.filter.at(last_s + 0.03).known, Known::predicted);
  EXPECT_EQ(walker.filter.at(last_s + 0.15).known, Known::held);
  EXPECT_EQ(walker.filter.at(last_s + 0.95).known, Known::held);
  EXPECT_EQ(walker.filter.at(last_s + 1.05).known, Known::lost);
}

TEST(HeadFilter, PredictsThePoseButNotTheCelerity) {
  Walker walker(moveUnseen);
  walker.sample(0, 180);
  const double last_s = 179 * kFrame_s;
  const HeadEstimate now = walker.filter.at(last_s), later = walker.filter.at(last_s + 0.035);
  EXPECT_NEAR(now.pose.position_m.x, last_s, 0.001);
  EXPECT_NEAR(later.pose.position_m.x, last_s + 0.035, 0.003);
  EXPECT_EQ(later.celerity_m_s, now.celerity_m_s);
  EXPECT_GT(later.sigma_m_s, now.sigma_m_s);  // it may have changed since
  EXPECT_NEAR(later.lag_s, now.lag_s + 0.035, 1e-12);
}

TEST(HeadFilter, PredictsATurn) {
  HeadFilter filter;
  const double rate_rad_s = 1.2;
  for (int i = 0; i < 120; ++i) {
    filter.add(i * kFrame_s,
               {glm::dvec3(0.0), glm::angleAxis(rate_rad_s * i * kFrame_s, glm::dvec3(0, 1, 0))});
  }
  const double then_s = 119 * kFrame_s + 0.04;
  const glm::dquat expected = glm::angleAxis(rate_rad_s * then_s, glm::dvec3(0, 1, 0));
  EXPECT_GT(std::abs(glm::dot(filter.at(then_s).pose.orientation, expected)), std::cos(0.5 * 0.001));
}

TEST(HeadFilter, TheOtherSignOfAQuaternionIsTheSameTurn) {
  HeadFilter plain, flipped;
  for (int i = 0; i < 60; ++i) {
    const glm::dquat q = glm::angleAxis(0.02 * i, glm::normalize(glm::dvec3(1, 2, 3)));
    plain.add(i * kFrame_s, {glm::dvec3(0.0), q});
    flipped.add(i * kFrame_s, {glm::dvec3(0.0), i % 2 ? -q : q});
  }
  const glm::dquat a = plain.at(1.0).pose.orientation, b = flipped.at(1.0).pose.orientation;
  EXPECT_NEAR(std::abs(glm::dot(a, b)), 1.0, 1e-12);
}

TEST(HeadFilter, RefusesWhatIsNoSample) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Walker walker(stand);
  EXPECT_EQ(walker.filter.add(nan, at({0, 0, 0})), SampleUse::unusable);
  walker.sample(0, 10);
  EXPECT_EQ(walker.filter.add(9 * kFrame_s, at({0, 1.7, 0})), SampleUse::unusable);
  EXPECT_EQ(walker.filter.add(5 * kFrame_s, at({0, 1.7, 0})), SampleUse::unusable);
  EXPECT_EQ(walker.filter.add(10 * kFrame_s, at({0, nan, 0})), SampleUse::unusable);
  EXPECT_EQ(walker.filter.add(10 * kFrame_s, {{0, 1.7, 0}, glm::dquat(0, 0, 0, 0)}), SampleUse::unusable);
  EXPECT_EQ(walker.filter.add(10 * kFrame_s, {{0, 1.7, 0}, glm::dquat(nan, 0, 0, 0)}), SampleUse::unusable);
  EXPECT_EQ(walker.sample(10 * kFrame_s), SampleUse::used);
}

TEST(HeadFilter, AGlitchLeavesNoTrace) {
  Walker walker(stand), calm(stand);
  walker.sample(0, 120);
  calm.sample(0, 120);
  EXPECT_EQ(walker.filter.add(120 * kFrame_s, at({0.5, 1.7, 0.0})), SampleUse::glitch);
  walker.sample(121, 180);
  calm.sample(121, 180);
  const HeadEstimate head = walker.filter.at(179 * kFrame_s), expected = calm.filter.at(179 * kFrame_s);
  EXPECT_EQ(head.celerity_m_s, expected.celerity_m_s);
  EXPECT_EQ(head.pose.position_m, expected.pose.position_m);
}

// Before the noise is known, a step of celerity above 12 m/s is a glitch, one below is travel, at any rate.
TEST(HeadFilter, TwelveMetresASecondIsTheLimitAtFirst) {
  for (const double rate_hz : {60.0, 120.0, 240.0}) {
    HeadFilter below, above;
    for (int i = 0; i < 6; ++i) {
      below.add(i / rate_hz, at({0, 0, 0}));
      above.add(i / rate_hz, at({0, 0, 0}));
    }
    EXPECT_EQ(below.add(6 / rate_hz, at({11.9 / rate_hz, 0, 0})), SampleUse::used) << rate_hz;
    EXPECT_EQ(above.add(6 / rate_hz, at({12.8 / rate_hz, 0, 0})), SampleUse::glitch) << rate_hz;
  }
}

// Someone stands, and the tracker is off for some samples, or for good, at once or by and by. No head does
// that, so the celerity stays that of a standing one.
TEST(HeadFilter, AJumpOfTheTrackerIsNoMotion) {
  struct Jump {
    double metres;
    int over;   // samples until it is whole
    int lasts;  // samples
  };
  constexpr int kForGood = 1 << 20;
  std::vector<Jump> jumps;
  for (const double metres : {0.006, 0.010, 0.020, 0.050, 0.1, 0.2, 0.5, 2.0}) {
    for (const int lasts : {1, 4, kForGood}) jumps.push_back({metres, 1, lasts});
  }
  for (const double metres : {0.3, 0.5}) {
    for (const int over : {3, 7}) jumps.push_back({metres, over, kForGood});
  }
  for (const double rate_hz : test::someOf({60.0, 72.0, 120.0, 240.0})) {
    for (const Jump& jump : jumps) {
      for (const std::uint64_t seed : {1u, 2u}) {
        std::mt19937_64 random(seed);
        std::normal_distribution<double> normal(0.0, 0.0003);
        HeadFilter filter;
        const int begin = static_cast<int>(5.0 * rate_hz);
        double fastest_m_s = 0.0;
        for (int i = 0; i < begin + static_cast<int>(rate_hz); ++i) {
          const double whole =
              i < begin || i >= begin + jump.lasts ? 0.0 : std::min(1.0, (i - begin + 1.0) / jump.over);
          const double x = normal(random), y = normal(random), z = normal(random);
          filter.add(i / rate_hz,
                     at(glm::dvec3(x + 0.6 * jump.metres * whole, 1.7 + y, z + 0.8 * jump.metres * whole)));
          if (i < begin) continue;
          fastest_m_s = std::max(fastest_m_s, glm::length(filter.at(i / rate_hz).celerity_m_s));
        }
        EXPECT_TRUE(fastest_m_s < 0.02)
            << fastest_m_s << " m/s: " << jump.metres << " m over " << jump.over << " samples for "
            << jump.lasts << " at " << rate_hz << " Hz, seed " << seed;
      }
    }
  }
}

// A step of the tracker beneath someone who walks leaves their walk as it is.
TEST(HeadFilter, AStepOfTheTrackerLeavesTheWalk) {
  for (const double metres : {0.05, 0.5}) {
    Walker walker([metres](double t) { return moveUnseen(t) + glm::dvec3(0, 0, t > 3.99 ? metres : 0.0); });
    for (int i = 0; i < 60 * 8; ++i) {
      walker.sample(i * kFrame_s);
      const glm::dvec3 celerity_m_s = walker.filter.at(i * kFrame_s).celerity_m_s;
      ASSERT_TRUE(i < 60 || glm::distance(celerity_m_s, glm::dvec3(1, 0, 0)) < 0.05)
          << metres << " m, frame " << i;
    }
    EXPECT_NEAR(walker.filter.at(479 * kFrame_s).pose.position_m.z, metres, 0.001);
  }
}

// A head that sets off as quickly as one can, a smooth push of up to 30 m/s² within a tenth of a second, is
// followed: a twentieth of a second after it the celerity is right to a tenth.
TEST(HeadFilter, AQuickStartIsFollowed) {
  for (const double rate_hz : test::someOf({60.0, 72.0, 120.0, 240.0})) {
    for (const double most_m_s2 : {2.0, 5.0, 10.0, 20.0, 30.0}) {
      for (const double phase : {0.0, 0.3, 0.6, 0.9}) {
        // a = A sin²(πt/P): v = A(t/2 − sin(2πt/P) P/4π), x = A(t²/4 − (1 − cos(2πt/P)) P²/8π²)
        constexpr double kPush_s = 0.1;
        const auto position_m = [=](double t) {
          constexpr double kPi = std::numbers::pi;
          const double u = std::clamp(t, 0.0, kPush_s);
          const double turn = 2.0 * kPi * u / kPush_s;
          const double within_m =
              0.25 * u * u - (1.0 - std::cos(turn)) * kPush_s * kPush_s / (8.0 * kPi * kPi);
          return most_m_s2 * (within_m + 0.5 * kPush_s * std::max(0.0, t - kPush_s));
        };
        std::mt19937_64 random(9);
        std::normal_distribution<double> normal(0.0, 0.0003);
        HeadFilter filter;
        const int end = static_cast<int>((5.0 + kPush_s + 0.05) * rate_hz);
        for (int i = 0; i <= end; ++i) {
          const double x = normal(random), y = normal(random), z = normal(random);
          filter.add(i / rate_hz, at(glm::dvec3(x + position_m((i + phase) / rate_hz - 5.0), y, z)));
        }
        const double truth_m_s = 0.5 * most_m_s2 * kPush_s;
        EXPECT_TRUE(std::abs(filter.at(end / rate_hz).celerity_m_s.x - truth_m_s) < 0.1 * truth_m_s + 0.03)
            << filter.at(end / rate_hz).celerity_m_s.x << " for " << truth_m_s << " m/s at " << rate_hz
            << " Hz, " << most_m_s2 << " m/s², phase " << phase;
      }
    }
  }
}

constexpr double kSettling_m_s = 0.02;  // while celerity is estimated anew; a raw difference is 0.025

// The tracker jumps and stays there: not travel, and the pose comes over at a bounded speed.
TEST(HeadFilter, AJumpToANewPlaceIsNotTravel) {
  for (const double jump_m : {0.25, 1.0, 5.0}) {
    Walker walker([jump_m](double t) { return stand(t) + glm::dvec3(t > 2.01 ? jump_m : 0.0, 0, 0); });
    glm::dvec3 shown = stand(0);
    int used = 0;
    for (int i = 0; i < 60 * 10; ++i) {
      used += walker.sample(i * kFrame_s) == SampleUse::used;
      const HeadEstimate head = walker.filter.at(i * kFrame_s);
      ASSERT_TRUE(i < 30 || glm::length(head.celerity_m_s) < kSettling_m_s) << jump_m << " m, frame " << i;
      ASSERT_TRUE(i < 30 || glm::distance(head.pose.position_m, shown) < kSlew_m_s * kFrame_s + 0.001)
          << jump_m << " m, frame " << i;
      shown = head.pose.position_m;
    }
    EXPECT_GE(used, 60 * 10 - 20);
    EXPECT_NEAR(shown.x, jump_m, 0.001);
  }
}

// While walking, some samples are elsewhere: the walk goes on.
TEST(HeadFilter, ABurstOfGlitchesIsBridged) {
  for (const int burst : {1, 3, 6, 12}) {
    Walker walker(moveUnseen);
    walker.sample(0, 180);
    for (int i = 180; i < 180 + burst; ++i) {
      EXPECT_EQ(walker.filter.add(i * kFrame_s, at({-1.0, 1.0, 2.0})), SampleUse::glitch) << i;
    }
    walker.sample(180 + burst, 300);
    const HeadEstimate head = walker.filter.at(299 * kFrame_s);
    EXPECT_NEAR(head.celerity_m_s.x, 1.0, 0.02) << burst;
    EXPECT_NEAR(head.pose.position_m.x, 299 * kFrame_s, 0.001) << burst;
  }
}

TEST(HeadFilter, NonsenseIsNeverTakenForAPlace) {
  Walker walker(stand);
  walker.sample(0, 120);
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> uniform(-50.0, 50.0);
  for (int i = 120; i < 400; ++i) {
    const double x = uniform(random), y = uniform(random), z = uniform(random);
    EXPECT_EQ(walker.filter.add(i * kFrame_s, at({x, y, z})), SampleUse::glitch) << i;
  }
  const HeadEstimate head = walker.filter.at(400 * kFrame_s);
  EXPECT_EQ(head.known, Known::lost);
  EXPECT_TRUE(glm::distance(head.pose.position_m, stand(0)) < 0.01);
}

TEST(HeadFilter, TheSameSamplesGiveTheSameBits) {
  SimulatedTracker tracker({.seed = 17});
  std::vector<TrackerSample> samples;
  tracker.poll(20.0, samples);
  HeadFilter one, other;
  for (const TrackerSample& sample : samples) {
    one.add(sample.time_s, sample.pose);
    other.add(sample.time_s, sample.pose);
    other.at(sample.time_s + 0.01);  // asking changes nothing
  }
  const HeadEstimate a = one.at(20.03), b = other.at(20.03);
  EXPECT_EQ(a.pose.position_m, b.pose.position_m);
  EXPECT_EQ(a.pose.orientation, b.pose.orientation);
  EXPECT_EQ(a.celerity_m_s, b.celerity_m_s);
  EXPECT_EQ(a.sigma_m_s, b.sigma_m_s);
}

// From the first sample on, also over losses and jumps.
TEST(HeadFilter, AllocatesNothing) {
  std::mt19937_64 random(23);
  std::normal_distribution<double> normal(0.0, 0.0003);
  const std::size_t before = test::allocationCount();
  HeadFilter filter;
  double sum_m_s = 0.0;
  for (int i = 0; i < 3000; ++i) {
    if (i % 700 > 650) continue;
    const double time_s = i / 120.0;
    const double jump_m = i % 500 == 0 ? 0.05 : i > 1500 ? 0.2 : 0.0;
    const double x_m = 0.3 * std::sin(2.0 * time_s) + jump_m + normal(random);
    filter.add(time_s, {{x_m, 1.7, normal(random)}, glm::dquat(1, 0, 0, 0)});
    sum_m_s += filter.at(time_s + 0.01).celerity_m_s.x;
  }
  EXPECT_EQ(test::allocationCount() - before, 0U);
  EXPECT_TRUE(std::isfinite(sum_m_s));
}

// The session's way from a sensor to the eyes: a sensor that turns on the spot carries the eyes about, and
// the celerity is ω × lever arm.
TEST(HeadFilter, TurningAboutTheSensorMovesTheEyes) {
  const Pose sensorFromEyes{{0.0, -0.06, -0.12}, glm::dquat(1.0, 0.0, 0.0, 0.0)};
  const glm::dvec3 turn_rad_s(0.0, 1.2, 0.0);
  HeadFilter filter;
  Pose eyes;
  for (int i = 0; i < 240; ++i) {
    const Pose sensor{{0.3, 1.7, 0.1}, glm::angleAxis(turn_rad_s.y * i * kFrame_s, glm::dvec3(0, 1, 0))};
    eyes = sensor * sensorFromEyes;
    ASSERT_EQ(filter.add(i * kFrame_s, eyes), SampleUse::used);
  }
  const glm::dvec3 lever_m = eyes.position_m - glm::dvec3(0.3, 1.7, 0.1);
  const glm::dvec3 expected_m_s = glm::cross(turn_rad_s, lever_m);
  // It circles: the stated lag at an acceleration of ω² × 0.12 m, and a bias as of even motion.
  const HeadEstimate head = filter.at(239 * kFrame_s);
  const double late_m_s = head.lag_s * 1.2 * 1.2 * 0.12;
  EXPECT_TRUE(glm::distance(head.celerity_m_s, expected_m_s) < late_m_s + 0.0025)
      << glm::distance(head.celerity_m_s, expected_m_s) << " m/s, of which late " << late_m_s;
  EXPECT_LT(late_m_s, 0.004);
  EXPECT_NEAR(glm::length(expected_m_s), 0.144, 1e-9);
}

// Noise of rotation at the end of a lever arm is noise of position: still, the head is still, and the noise
// is known for what it is.
TEST(HeadFilter, NoiseOfRotationThroughTheLeverArmIsKnown) {
  const double noise_rad = 0.003, lever_m = 0.15, noise_m = 0.0003;
  const Pose sensorFromEyes{{0.0, 0.0, -lever_m}, glm::dquat(1.0, 0.0, 0.0, 0.0)};
  std::mt19937_64 random(61);
  std::normal_distribution<double> normal;
  HeadFilter filter;
  double square = 0.0;
  int count = 0;
  for (int i = 0; i < 60 * 60; ++i) {
    const double x = normal(random), y = normal(random), z = normal(random);
    const double a = normal(random), b = normal(random), c = normal(random);
    const glm::dvec3 turn_rad = noise_rad * glm::dvec3(a, b, c);
    const Pose sensor{noise_m * glm::dvec3(x, y, z), glm::normalize(glm::dquat(1.0, 0.5 * turn_rad))};
    filter.add(i * kFrame_s, sensor * sensorFromEyes);
    if (i < 600) continue;
    const glm::dvec3 celerity_m_s = filter.at(i * kFrame_s).celerity_m_s;
    square += glm::dot(celerity_m_s, celerity_m_s) / 3.0;
    ++count;
  }
  // Two of the three coordinates of the eyes swing with the sensor.
  const double expected_m =
      std::sqrt(noise_m * noise_m + 2.0 / 3.0 * lever_m * lever_m * noise_rad * noise_rad);
  EXPECT_NEAR(filter.trackerSigma_m() / expected_m, 1.0, 0.15);
  EXPECT_LT(std::sqrt(square / count), 0.001);  // m/s: what is asked of a still head with less noise
}

// The same samples on several threads at once, asked in other frames: the same bits.
TEST(HeadFilter, ThreadsAndFramesDoNotMatter) {
  SimulatedTracker tracker({.seed = 18});
  std::vector<TrackerSample> samples;
  tracker.poll(20.0, samples);
  const auto played = [&samples](double frame_s) {
    RecordedTracker recorded(samples);
    HeadFilter filter;
    std::vector<TrackerSample> polled;
    for (double now_s = 0.0; now_s < 19.9; now_s += frame_s) {
      polled.clear();
      recorded.poll(now_s, polled);
      for (const TrackerSample& sample : polled) filter.add(sample.time_s, sample.pose);
      filter.at(now_s);
    }
    polled.clear();
    recorded.poll(19.9, polled);
    for (const TrackerSample& sample : polled) filter.add(sample.time_s, sample.pose);
    return filter.at(20.0);
  };
  const HeadEstimate expected = played(kFrame_s);
  for (const int threads : {1, 2, 4, 8}) {
    std::vector<HeadEstimate> found(threads);
    {
      std::vector<std::jthread> running;
      for (int i = 0; i < threads; ++i) {
        running.emplace_back([&found, &played, i] { found[i] = played((1.0 + 0.37 * i) / 90.0); });
      }
    }
    for (const HeadEstimate& head : found) {
      EXPECT_EQ(head.pose.position_m, expected.pose.position_m) << threads;
      EXPECT_EQ(head.pose.orientation, expected.pose.orientation) << threads;
      EXPECT_EQ(head.celerity_m_s, expected.celerity_m_s) << threads;
      EXPECT_EQ(head.celerityCovariance_m2_s2, expected.celerityCovariance_m2_s2) << threads;
      EXPECT_EQ(head.lag_s, expected.lag_s) << threads;
    }
  }
}

// Calendar time leaves only a quarter of a microsecond: no more than that is lost.
TEST(HeadFilter, WorksOnCalendarTime) {
  Walker walker(moveUnseen);
  HeadFilter calendar;
  const double epoch_s = 1.7e9;
  for (int i = 0; i < 240; ++i) {
    const glm::dvec3 position_m = moveUnseen(i * kFrame_s);
    walker.filter.add(i * kFrame_s, at(position_m));
    ASSERT_EQ(calendar.add(epoch_s + i * kFrame_s, at(position_m)), SampleUse::used);
  }
  EXPECT_TRUE(glm::distance(calendar.at(epoch_s + 4.0).celerity_m_s, walker.filter.at(4.0).celerity_m_s) <
              1e-3);
}

}  // namespace
}  // namespace carom
