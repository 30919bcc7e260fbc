// Points of bodies that bounce up to twenty times, often again before the signal of the last bounce has
// reached them: what must hold for each of a hundred thousand of them, so that an eye sees one image of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/gtc/quaternion.hpp>

#include "engine/light/point_history.h"
#include "engine/light/ring_view.h"
#include "engine/meshes.h"
#include "engine/spacetime/observers.h"
#include "reference/ray_reference.h"

namespace carom {
namespace {

using test::kC_m_s, test::kHistoryRounding_m, test::placeAt;

std::vector<reference::Leg> referenceLegs(const WorldLine& line) {
  std::vector<reference::Leg> legs;
  for (const Knot& knot : line.knots()) {
    legs.push_back({{kC_m_s * knot.turn.t_s, knot.turn.r_m},
                    knot.u / std::sqrt(1.0 + glm::dot(knot.u, knot.u)),
                    {kC_m_s * knot.signal.t_s, knot.signal.r_m},
                    0.0});
  }
  return legs;
}

/// Every piece is slower than light and ends where the next begins. Returns the longest jump (metres).
double longestJump_m(const std::vector<VertexPiece>& history) {
  double longest_m = 0.0;
  for (std::size_t k = 0; k + 1 < history.size(); ++k) {
    const Event& end = history[k + 1].start;
    if (!(glm::length(betaFromU(history[k].u)) < 1.0)) return INFINITY;
    if (k > 0 && !(end.t_s >= history[k].start.t_s - 1e-12)) return INFINITY;
    const double jump_m = glm::length(carom::placeAt(history[k], end.t_s, kC_m_s) - end.r_m);
    longest_m = std::isnan(jump_m) ? INFINITY : std::max(longest_m, jump_m);
  }
  return longest_m;
}

TEST(BounceChain, HundredThousandWorldLinesAreContinuousSlowerThanLightAndSeenOnce) {
  constexpr int kLines = 2000, kPoints = 50;
  constexpr std::size_t kTimes = 12;
  test::Random random(71);
  double longestJump = 0.0, fastest = 0.0, worst_m = 0.0;
  long points = 0, catchingUp = 0;
  for (int i = 0; i < kLines; ++i) {
    CASE(random, i);
    const double radius_m = random.in(0.02, 0.3);
    const int bounces = static_cast<int>(random.in(1, 21));
    const WorldLine line = randomWorldLine(random, kC_m_s, radius_m, bounces, random.in(0.02, 1.0), 0.9);
    const std::vector<reference::Leg> legs = referenceLegs(line);
    const double first_s = line.knots().front().turn.t_s, last_s = line.knots().back().turn.t_s;
    for (int k = 0; k < kPoints; ++k, ++points) {
      const Vec3 offset_m = random.inBall(radius_m);
      const Event eye{random.in(first_s, last_s + 2.0), random.inBox(2.0)};
      SCOPED_TRACE(testing::Message()
                   << "world line " << i << " with " << bounces << " bounces, point " << k);
      const auto history = vertexHistory(line, offset_m);
      const double jump_m = longestJump_m(history);
      ASSERT_LT(jump_m, kHistoryRounding_m);
      longestJump = std::max(longestJump, jump_m);

      // f(t) = c (t_o − t) − |r_o − r(t)| at any times: falls strictly, and so has one root.
      std::array<double, kTimes> times_s;
      for (double& t_s : times_s) t_s = random.in(first_s - 0.5, last_s + 1.0);
      std::sort(times_s.begin(), times_s.end());
      const auto f = [&](double t_s) {
        return kC_m_s * (eye.t_s - t_s) - glm::length(eye.r_m - placeAt(history, t_s));
      };
      for (std::size_t n = 1; n < kTimes; ++n) {
        const double dt_s = times_s[n] - times_s[n - 1];
        if (dt_s < 1e-9) continue;  // shorter than rounding
        const Vec3 way_m = placeAt(history, times_s[n]) - placeAt(history, times_s[n - 1]);
        const double speed = glm::length(way_m) / (kC_m_s * dt_s);
        ASSERT_LT(speed, 1.0);
        ASSERT_LT(f(times_s[n]), f(times_s[n - 1])) << "at " << times_s[n] << " s";
        fastest = std::max(fastest, speed);
      }
      const Event seen = eventOnPastCone(history, eye, kC_m_s);
      ASSERT_LT(std::abs(f(seen.t_s)), 1e-9);
      ASSERT_LT(glm::length(placeAt(history, seen.t_s) - seen.r_m), kHistoryRounding_m * 20);

      if (k % 10 != 0) continue;  // the slow way, with boosts of its own
      const reference::PointLine slow(legs, offset_m);
      for (const double t_s : times_s) {
        const double off_m = glm::length(slow.at(kC_m_s * t_s) - placeAt(history, t_s));
        ASSERT_LT(off_m, 1e-9) << "at " << t_s << " s";
        worst_m = std::max(worst_m, off_m);
        catchingUp += slow.catchingUpAt(kC_m_s * t_s) ? 1 : 0;
      }
      const reference::Event emission = slow.emission({kC_m_s * eye.t_s, eye.r_m});
      ASSERT_LT(std::abs(emission.t - kC_m_s * seen.t_s), 1e-8);
      ASSERT_LT(glm::length(emission.r - seen.r_m), 1e-8);
    }
  }
  std::printf("%ld points: jumps up to %.1g m, chords up to %.4f c, off the slow way by %.1g m\n", points,
              longestJump, fastest, worst_m);
  EXPECT_EQ(points, 100000);
  EXPECT_GT(catchingUp, 10000);
}

// ---- eyes whose board time steps back -------------------------------------------------------------------

/// A person who walks fast and turns their head faster than anyone can: (γβ/c)·offset of an eye then changes
/// by more than a frame.
class TurningHead {
 public:
  TurningHead() : observer_(Lorentz(kC_m_s), {0.5, Vec3(0.0, -0.8, 0.0)}, head()) {}

  ObserverView next(test::Random& random) {
    constexpr double kFrame_s = 1.0 / 60.0, kCelerity_m_s = 2.5;
    angle_rad_ += random.in(-1.5, 1.5);
    direction_rad_ += random.in(0.0, 0.2);  // in a circle, so as not to walk away
    celerity_m_s_ = kCelerity_m_s * Vec3(std::cos(direction_rad_), std::sin(direction_rad_), 0.0);
    position_m_ += celerity_m_s_ * kFrame_s;
    observer_.step(kFrame_s, head());
    return observer_.view(0.064);
  }

 private:
  Head head() const {
    Head head;
    head.roomFromHead.position_m = position_m_;
    head.roomFromHead.orientation = glm::angleAxis(angle_rad_, Vec3(0.0, 0.0, 1.0));
    head.celerity_m_s = celerity_m_s_;
    return head;
  }

  double angle_rad_ = 0.0, direction_rad_ = 0.0;
  Vec3 position_m_{0.0}, celerity_m_s_{0.0};
  Observers observer_;
};

/// The same flight as samples: what a ring keeps.
VertexRing sampled(const WorldLine& line, const test::Cloud& cloud) {
  constexpr int kSamples = 1500;
  constexpr double kStep_s = 1.0 / 150.0;
  std::vector<std::vector<VertexPiece>> histories;
  for (std::size_t k = 0; k < cloud.x.size(); ++k) histories.push_back(vertexHistory(line, cloud.at(k)));
  VertexRing ring(cloud.x.size(), kSamples, kC_m_s);
  std::vector<float> t(cloud.x.size()), x(t), y(t), z(t);
  for (int sample = 0; sample < kSamples; ++sample) {
    const double t_s = -3.0 + sample * kStep_s;
    const Event anchor{t_s, line.at(t_s).event.r_m};
    for (std::size_t k = 0; k < histories.size(); ++k) {
      const Vec3 from_m = placeAt(histories[k], t_s) - anchor.r_m;
      x[k] = static_cast<float>(from_m.x), y[k] = static_cast<float>(from_m.y),
      z[k] = static_cast<float>(from_m.z);
    }
    ring.append({anchor, t, x, y, z});
  }
  return ring;
}

TEST(BounceChain, EyesThatStepBackStillFindTheRoot) {
  constexpr std::size_t kPoints = 40;
  test::Random random(72);
  long stepsBack = 0, looks = 0;
  double farthestBack_s = 0.0, worst_m = 0.0;
  for (int i = 0; i < 4; ++i) {
    CASE(random, i);
    const WorldLine line = randomWorldLine(random, kC_m_s, 0.1, 20, 0.15, 0.9);
    const std::vector<reference::Leg> legs = referenceLegs(line);
    const test::Cloud cloud = test::randomCloud(random, kPoints, 0.1);
    std::vector<reference::PointLine> slow;
    for (std::size_t k = 0; k < kPoints; ++k) slow.emplace_back(legs, cloud.at(k));
    const VertexRing ring = sampled(line, cloud);
    std::array<RigidMeshView, 2> rigid{RigidMeshView(line, cloud.points()),
                                       RigidMeshView(line, cloud.points())};
    std::array<RingView, 2> kept{RingView(ring), RingView(ring)};
    std::array<double, 2> last_s{-INFINITY, -INFINITY};
    TurningHead head;
    for (int frame = 0; frame < 120; ++frame) {
      const ObserverView view = head.next(random);
      for (std::size_t side = 0; side < 2; ++side, ++looks) {
        const Event& eye = (side == 0 ? view.left : view.right).observation;
        SCOPED_TRACE(testing::Message() << "world line " << i << ", frame " << frame << ", eye " << side
                                        << " at " << eye.t_s << " s after " << last_s[side] << " s");
        if (eye.t_s < last_s[side]) {
          ++stepsBack;
          farthestBack_s = std::max(farthestBack_s, last_s[side] - eye.t_s);
        }
        last_s[side] = eye.t_s;

        rigid[side].look(eye, view.headFromBoard);
        for (std::size_t k = 0; k < kPoints; k += 5) {
          const auto seen = rigid[side].emission(k);
          ASSERT_TRUE(seen);
          const reference::Event expected = slow[k].emission({kC_m_s * eye.t_s, eye.r_m});
          const double off_m = glm::length(seen->event.r_m - expected.r);
          ASSERT_LT(off_m, 1e-8) << "point " << k;
          worst_m = std::max(worst_m, off_m);
        }
        test::SeenCloud seen(kPoints);
        ASSERT_EQ(rigid[side].see(0, seen.points()), 0U);
        // What a search finds does not depend on where the last one ended.
        RingView fresh(ring);
        kept[side].look(eye, view.headFromBoard);
        fresh.look(eye, view.headFromBoard);
        const test::SeenCloud fromKept = test::seeOnThreads(kept[side], 1);
        ASSERT_TRUE(fromKept == test::seeOnThreads(fresh, 1));
        for (std::size_t k = 0; k < kPoints; ++k) {
          // A chord of 1/150 s cuts a bounce short by less than its way at c.
          ASSERT_LT(glm::length(fromKept.at(k) - seen.at(k)), 0.05) << "point " << k;
        }
      }
    }
  }
  std::printf("%ld looks, %ld of them back in time, by %.1f ms at most; emissions off by %.1g m\n", looks,
              stepsBack, 1e3 * farthestBack_s, worst_m);
  EXPECT_GT(stepsBack, 40);
}

}  // namespace
}  // namespace carom
