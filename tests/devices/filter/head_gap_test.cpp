// The head where samples are missing: celerity and place beside a filter of other models that is told the
// tracker's noise, the fade after half a second, and the way back.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "devices/filter/head_filter.h"
#include "devices/gap_score.h"
#include "devices/simulated_heads.h"
#include "devices/unturned_head.h"
#include "devices/velocity_peers.h"
#include "places.h"
#include "sanitized.h"

namespace carom {
namespace {

using test::poseAt;

constexpr double kFrame_s = 1.0 / 60.0;
constexpr double kSlew_m_s = 1.0;  // how fast the pose comes over to where samples came back

// The simulated heads, and the recorded ones.
std::vector<SimulatedHead> headsAt(int rate_hz) {
  std::vector<SimulatedHead> heads = simulatedHeads(rate_hz);
  for (const char* recording : {"optitrack_head_120hz", "tum_fr1_xyz"}) {
    const auto rows = recordedRows(std::string(CAROM_TESTS_DIR "/data/tracking/") + recording + ".csv");
    heads.push_back({recording, smoothed(rows, rate_hz, 60.0)});
  }
  heads.resize(test::casesOf(heads.size()));
  return heads;
}

// The longer the gap, the more depends on how the models expect a head to go on, which no filter knows.
TEST(HeadGap, CelerityAfterItIsThatOfModelsToldTheNoise) {
  for (const int rate_hz : test::someOf({60, 30, 120})) {
    const std::vector<SimulatedHead> heads = headsAt(rate_hz);
    for (const auto& [gap_s, limit] :
         {std::pair(0.1, 1.1), std::pair(0.2, 1.3), std::pair(0.3, 1.3), std::pair(0.5, 1.5)}) {
      for (const SimulatedHead& head : heads) {
        const GapScore own = gapScoreOf(head.path, gap_s, test::headFilter, 1);
        const GapScore peer = gapScoreOf(
            head.path, gap_s, [] { return fourSingers(kTrackerNoise_m); }, 1);
        EXPECT_LE(own.error_m_s, limit * peer.error_m_s)
            << head.name << " at " << rate_hz << " Hz, " << gap_s << " s: " << own.error_m_s << " m/s for "
            << peer.error_m_s;
      }
    }
  }
}

// A head with noise of 0.3 mm at 60 Hz that is watched at each frame, also where samples are missing.
struct Watched {
  double missing_s = 0.0;  // time since the last sample
  double back_s = 1e9;     // time since samples are back
  glm::dvec3 truth_m{0.0}, velocity_m_s{0.0};
  HeadEstimate head;
};

void watch(const Path& path, double gap_s, const std::function<void(const Watched&)>& each) {
  std::mt19937_64 random(5);
  HeadFilter filter;
  Watched now;
  double last_s = path.times_s.front();
  for (std::size_t i = 0; i < path.times_s.size(); ++i) {
    const double time_s = path.times_s[i], since_s = time_s - path.times_s.front() - 3.0;
    const double into_s = since_s < 0.0 ? 1e9 : std::fmod(since_s, gap_s + 2.0);
    const glm::dvec3 sample_m = path.positions_m[i] + trackerNoise(random);
    if (into_s >= gap_s) {
      filter.add(time_s, poseAt(sample_m));
      last_s = time_s;
    }
    now = {time_s - last_s, into_s - gap_s, path.positions_m[i], path.velocities_m_s[i], filter.at(time_s)};
    each(now);
  }
}

// The place goes on through the gap, and comes over at the slide's speed and no faster.
TEST(HeadGap, ThePlaceGoesOnAndNeverJumps) {
  for (const double gap_s : {0.1, 0.2, 0.3, 0.5, 0.8, 1.5}) {
    double coasted = 0.0, held = 0.0;
    for (const SimulatedHead& head : headsAt(60)) {
      double late_m = 0.0;
      glm::dvec3 before_m(0.0), estimated_m_s(0.0), lastMeasured_m(0.0);
      bool first = true;
      watch(head.path, gap_s, [&](const Watched& now) {
        const glm::dvec3 place_m = now.head.pose.position_m, off_m = place_m - now.truth_m;
        if (now.missing_s == 0.0) lastMeasured_m = now.truth_m;
        if (now.missing_s > 0.0 && now.missing_s <= 0.5) {
          coasted += glm::dot(off_m, off_m);
          held += glm::dot(lastMeasured_m - now.truth_m, lastMeasured_m - now.truth_m);
        }
        // The way of the head, as it was or is estimated, and the slide; noise moves the place by less than 2
        // mm.
        const double fastest_m_s = std::max({glm::length(now.head.celerity_m_s), glm::length(estimated_m_s),
                                             glm::length(now.velocity_m_s)}) +
                                   kSlew_m_s;
        if (!first && now.back_s < 1.0) {
          EXPECT_TRUE(glm::distance(place_m, before_m) <= fastest_m_s * kFrame_s + 0.006)
              << head.name << ", " << gap_s << " s, " << now.back_s << ": "
              << glm::distance(place_m, before_m) << " at " << fastest_m_s << " m/s";
        }
        if (now.back_s >= 0.3 && now.back_s < 0.5 && gap_s <= 0.3)
          late_m = std::max(late_m, glm::length(off_m));
        first = false;
        before_m = place_m;
        estimated_m_s = now.head.celerity_m_s;
      });
      // 0.3 s of sliding are 0.3 m; the rest is noise.
      EXPECT_LT(late_m, 0.005) << head.name << ", " << gap_s << " s";
    }
    // Two thirds as far off as a head that is held, of all heads. (One that turns quickly about its neck does
    // not go on.)
    EXPECT_LT(coasted, 0.45 * held) << gap_s << " s";
  }
}

// Walking evenly at 1 m/s: nothing changes for half a second, then the celerity falls smoothly, is zero after
// a second, and grows smoothly when samples return. Nothing jumps.
TEST(HeadGap, AfterHalfASecondTheHeadComesToRest) {
  const simulated_heads::Course walk = [](double time_s) { return glm::dvec3(time_s, 0.0, 0.0); };
  for (const double gap_s : {0.17, 0.3, 0.5, 0.7, 0.9, 1.0, 5.0}) {
    double celerity_m_s = 0.0, slope_m_s2 = 0.0, place_m = 0.0, missingBefore_s = 0.0;
    int frames = 0;
    watch(simulated_heads::sampled(walk, 60.0), gap_s, [&](const Watched& now) {
      const double x_m_s = now.head.celerity_m_s.x, x_m = now.head.pose.position_m.x;
      const double change_m_s = x_m_s - celerity_m_s;
      const bool fades = now.missing_s > 0.0;
      if (fades && now.missing_s <= 0.5) {
        EXPECT_NEAR(x_m_s, 1.0, 0.03) << gap_s << " " << now.missing_s;
      }
      if (fades && now.missing_s >= 1.0) {
        EXPECT_EQ(now.head.celerity_m_s, glm::dvec3(0.0)) << now.missing_s;
      }
      if (fades && now.missing_s > 0.6) {
        EXPECT_LT(x_m_s, 0.95) << gap_s << " " << now.missing_s;
      }
      if (frames > 60) {
        // 1 − u²(3 − 2u) over 0.5 s: at most 1.5/0.5 s a second, and its slope changes by 6/0.5² s² at most.
        // Back over 0.2 s.
        EXPECT_TRUE(std::abs(change_m_s) < (fades ? 3.0 : 5.0) * kFrame_s + 0.03)
            << gap_s << " " << now.missing_s << " " << now.back_s;
        if (fades && missingBefore_s > 0.0) {
          EXPECT_LT(std::abs(change_m_s / kFrame_s - slope_m_s2), 24.0 * kFrame_s + 0.05) << now.missing_s;
        }
        const double step_m = x_m - place_m;
        EXPECT_TRUE(step_m > -0.001 && step_m < (1.0 + kSlew_m_s + 0.3) * kFrame_s) << gap_s << " " << step_m;
      }
      if (now.back_s > 1.5 && frames > 60) {
        EXPECT_NEAR(x_m_s, 1.0, 0.02) << gap_s;
      }
      slope_m_s2 = change_m_s / kFrame_s;
      celerity_m_s = x_m_s;
      place_m = x_m;
      missingBefore_s = now.missing_s;
      ++frames;
    });
  }
}

// The stated error covers the gap: RMS of errors beside that of the stated ones.
TEST(HeadGap, TheErrorIsStated) {
  for (const double gap_s : {0.2, 0.5, 0.9}) {
    double square = 0.0, stated = 0.0;
    for (const SimulatedHead& head : headsAt(60)) {
      watch(head.path, gap_s, [&](const Watched& now) {
        if (now.missing_s <= 0.1) return;
        const glm::dvec3 off_m_s = now.head.celerity_m_s - now.velocity_m_s;
        square += glm::dot(off_m_s, off_m_s) / 3.0;
        stated += now.head.sigma_m_s * now.head.sigma_m_s;
      });
    }
    EXPECT_LT(square, 1.3 * 1.3 * stated) << gap_s << " s";
    EXPECT_GT(square, 0.3 * 0.3 * stated) << gap_s << " s";
  }
}

// Each sample of a tracker of 5 Hz is overdue when it comes: after a loss the walk is seen again all the
// same.
TEST(HeadGap, ASlowTrackerReturnsToo) {
  HeadFilter filter;
  for (int i = 0; i < 60; ++i) {
    if (i < 20 || i >= 30) filter.add(0.2 * i, poseAt({0.2 * i, 1.7, 0.0}));
  }
  EXPECT_NEAR(filter.at(0.2 * 59).celerity_m_s.x, 1.0, 0.03);
}

// Gathering way when samples stop: the celerity is that of the place 0.1 s before, by the difference of
// places.
TEST(HeadGap, TheCelerityGoesOnAsThePlaceDoes) {
  std::mt19937_64 random(10);
  HeadFilter filter;
  const auto place_m = [](double time_s) {
    const double since_s = std::max(0.0, time_s - 2.0);
    return glm::dvec3(0.5 * since_s * since_s, 1.7, 0.0);  // 1 m/s²
  };
  for (int i = 0; i < 180; ++i)
    filter.add(i * kFrame_s, poseAt(place_m(i * kFrame_s) + trackerNoise(random)));
  const double last_s = 179 * kFrame_s, last_m_s = filter.at(last_s).celerity_m_s.x;
  constexpr double kStep_s = 1e-4;
  for (double ahead_s = 0.12; ahead_s < 0.5; ahead_s += 0.05) {
    const double then_s = last_s + ahead_s - 0.1;
    const glm::dvec3 way_m =
        filter.at(then_s + kStep_s).pose.position_m - filter.at(then_s - kStep_s).pose.position_m;
    const glm::dvec3 celerity_m_s = filter.at(last_s + ahead_s).celerity_m_s;
    EXPECT_TRUE(glm::distance(celerity_m_s, way_m / (2.0 * kStep_s)) < 1e-6) << ahead_s;
    if (ahead_s > 0.3) {
      EXPECT_GT(celerity_m_s.x, last_m_s + 0.05) << ahead_s;
    }
  }
}

TEST(HeadGap, TheErrorOfAFadingCelerityIsStated) {
  std::mt19937_64 random(11);
  HeadFilter filter;
  for (int i = 0; i < 180; ++i)
    filter.add(i * kFrame_s, poseAt(glm::dvec3(i * kFrame_s, 1.7, 0.0) + trackerNoise(random)));
  for (const double after_s : {0.12, 0.6, 0.75, 0.9, 0.98, 1.5}) {
    const HeadEstimate head = filter.at(179 * kFrame_s + after_s);
    EXPECT_GT(head.sigma_m_s, 0.9 * std::abs(1.0 - head.celerity_m_s.x)) << after_s;
  }
}

// A tracker that comes back a metre beside the course was set up anew: no head gets there. Nobody has moved.
TEST(HeadGap, ATrackerThatReturnsElsewhereIsNoMotion) {
  for (const double gap_s : {0.4, 0.8, 2.0}) {
    std::mt19937_64 random(8);
    HeadFilter filter;
    double fastest_m_s = 0.0;
    for (int i = 0; i < 600; ++i) {
      const double time_s = i * kFrame_s;
      if (time_s >= 5.0 && time_s < 5.0 + gap_s) continue;
      const glm::dvec3 place_m(time_s < 5.0 ? 0.0 : 1.0, 1.7, 0.0);
      EXPECT_EQ(filter.add(time_s, poseAt(place_m + trackerNoise(random))), SampleUse::used);
      if (time_s > 4.0) fastest_m_s = std::max(fastest_m_s, glm::length(filter.at(time_s).celerity_m_s));
    }
    EXPECT_LT(fastest_m_s, 0.02) << gap_s;  // a raw difference of noise is 0.025
    EXPECT_NEAR(filter.at(10.0).pose.position_m.x, 1.0, 0.001) << gap_s;
  }
}

// The same beneath someone who walks: the walk goes on as it was until it is known anew.
TEST(HeadGap, ATrackerThatReturnsElsewhereLeavesTheWalk) {
  std::mt19937_64 random(8);
  HeadFilter filter;
  for (int i = 0; i < 600; ++i) {
    const double time_s = i * kFrame_s;
    if (time_s >= 5.0 && time_s < 5.4) continue;
    filter.add(time_s, poseAt(glm::dvec3(time_s, 1.7, time_s < 5.0 ? 0.0 : 2.0) + trackerNoise(random)));
    if (time_s < 4.0) continue;
    EXPECT_TRUE(glm::distance(filter.at(time_s).celerity_m_s, glm::dvec3(1.0, 0.0, 0.0)) < 0.1)
        << time_s << ": " << filter.at(time_s).celerity_m_s.x;
  }
}

}  // namespace
}  // namespace carom
