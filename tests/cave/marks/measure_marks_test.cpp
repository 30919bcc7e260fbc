// Ruler, angles and pulses of light: where their corners are drawn, in closed form.
#include "cave/marks/measure_marks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <vector>

#include "cave/gl/view_colours.h"
#include "cave/one_eye.h"
#include "cave/plate_words.h"
#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::kC_m_s;
using test::observerAt;

bool isGlow(const MarkCorner& corner) { return corner.style < -0.5F; }
bool isPlate(const MarkCorner& corner) { return corner.style > 0.5F; }

/// The middle of the glows, which stand around one place.
Vec3 glowOf(const MarkBuffer& batch) {
  Vec3 sum(0.0);
  double weight = 0.0;
  for (const MarkCorner& corner : batch.corners()) {
    if (!isGlow(corner)) continue;
    // Two triangles of a square: with its corners' signs, the diagonal's count twice.
    const double w = corner.on.x * corner.on.y < 0.0F ? 0.5 : 1.0;
    sum += w * Vec3(corner.drawn_m);
    weight += w;
  }
  return weight > 0.0 ? sum / weight : Vec3(std::numeric_limits<double>::quiet_NaN());
}

// The glow's light left it on the eye's past cone: found by bisection in time, boosted to the head.
TEST(Pulses, GlowWhereTheEyeSeesThem) {
  test::Random random(91);
  int seen = 0;
  for (int i = 0; i < 500; ++i) {
    CASE(random, i);
    const LightPath pulse{random.in(-1.0, 1.0), {random.inBox(1.5), random.inBox(1.5), random.inBox(1.5)}};
    const Event eye{random.in(0.0, 5.0), random.inBox(2.0)};
    const Lorentz headFromBoard = Lorentz::boost(random.u(0.8), kC_m_s);
    const ObserverView observer = observerAt(eye, headFromBoard);
    const MarkContext sight{observer, observer.middle, {}, {}, 0, {}, {}, {}, {}};
    MarkBuffer batch;
    addPulses(sight, {&pulse, 1}, batch);
    const auto placeAt = [&](double t_s) { return placeAlong(pulse.path_m, kC_m_s * (t_s - pulse.start_s)); };
    const double end_s = pulse.start_s + lengthOf(pulse.path_m) / kC_m_s;
    const auto late_s = [&](double t_s) {
      return t_s + glm::distance(placeAt(t_s), eye.r_m) / kC_m_s - eye.t_s;
    };
    const bool glows = late_s(pulse.start_s) < 0.0 && late_s(end_s) > 0.0;
    const bool drawn = std::any_of(batch.corners().begin(), batch.corners().end(), isGlow);
    ASSERT_EQ(drawn, glows) << "case " << i;
    if (!glows) continue;
    ++seen;
    double from_s = pulse.start_s, to_s = end_s;
    for (int k = 0; k < 60; ++k) {
      const double middle_s = 0.5 * (from_s + to_s);
      (late_s(middle_s) < 0.0 ? from_s : to_s) = middle_s;
    }
    const Vec3 expected = (headFromBoard * (Event{from_s, placeAt(from_s)} - eye)).dr_m;
    ASSERT_LT(glm::distance(glowOf(batch), expected), 1e-5 * (1.0 + glm::length(expected))) << "case " << i;
  }
  EXPECT_GT(seen, 100);
}

TEST(Pulses, WithoutRetardationAreWhereTheyAre) {
  const LightPath pulse{1.0, {{-1, 0, 0.2}, {1, 0, 0.2}}};
  const Event eye{1.5, {0.0, -2.0, 1.0}};
  const ObserverView observer = observerAt(eye, Lorentz(kC_m_s));
  const MarkContext sight{observer, observer.middle, {0, 1, 1}, {}, 0, {}, {}, {}, {}};
  MarkBuffer batch;
  addPulses(sight, {&pulse, 1}, batch);
  EXPECT_LT(glm::distance(eye.r_m + glowOf(batch), Vec3(-1.0 + 0.5 * kC_m_s, 0.0, 0.2)), 1e-5);
}

// The light of the ruler passes its beginning at even multiples of (1 m)/c; what the eye sees it do, a path
// laid out for it from long before says.
TEST(TheRulersLight, GoesToAndFroAtC) {
  test::Random random(92);
  const Ruler ruler{{-0.5, -0.6, 0.0}, {1, 0, 0}, {0, 1, 0}};
  for (int i = 0; i < 300; ++i) {
    CASE(random, i);
    const double c_m_s = random.in(0.3, kFastestOnRuler_m_s);
    const Event eye{random.in(-3.0, 30.0), random.inBox(3.0)};
    const ObserverView observer = observerAt(eye, Lorentz(c_m_s));
    const std::uint8_t retarded = i % 2 == 0 ? 1 : 0;
    const MarkContext sight{observer, observer.middle, {retarded, 1, 1}, {}, 0, {}, {}, {}, {}};
    LabelLayout crowd(sight);
    MarkBuffer batch;
    addRuler(sight, ruler, crowd, batch);
    const Vec3 glow_m = eye.r_m + glowOf(batch);
    const double along_m = glow_m.x + 0.5;
    ASSERT_GE(along_m, -1e-5) << "case " << i;
    ASSERT_LE(along_m, 1.0 + 1e-5) << "case " << i;
    // When its light left it there, it was so far along its way, folded onto the metre.
    const double left_m = c_m_s * eye.t_s - (retarded ? glm::distance(glow_m, eye.r_m) : 0.0);
    const double folded_m = std::abs(std::remainder(left_m, 2.0));
    ASSERT_NEAR(along_m, folded_m, 1e-4) << "case " << i << ", c = " << c_m_s << ", t = " << eye.t_s;
  }
}

TEST(TheRuler, IsAMetreLongAndMarksTenthsOfASecondOfLight) {
  const Ruler ruler{{-0.5, -0.6, 0.0}, {1, 0, 0}, {0, 1, 0}};
  const Event eye{5.0, {0.1, -2.0, 1.0}};
  const ObserverView observer = observerAt(eye, Lorentz(kC_m_s));
  const MarkContext sight{observer, observer.middle, {}, {}, 0, {}, {}, {}, {}};
  LabelLayout crowd(sight);
  MarkBuffer batch;
  addRuler(sight, ruler, crowd, batch);
  double left_m = 1e9, right_m = -1e9;
  std::vector<double> marks_m;
  for (const MarkCorner& corner : batch.corners()) {
    const Vec3 place_m = eye.r_m + Vec3(corner.drawn_m);
    if (corner.style != 0.0F || std::abs(place_m.z - kOnCloth_m) > 1e-5) continue;  // flat on the cloth
    if (glm::vec3(corner.colour) == kRulerLightColour) {
      marks_m.push_back(place_m.x + 0.5);
    } else {
      left_m = std::min(left_m, place_m.x);
      right_m = std::max(right_m, place_m.x);
    }
  }
  EXPECT_NEAR(left_m, -0.5, 1e-5);
  EXPECT_NEAR(right_m, 0.5, 1e-5);
  for (const double mark_m : marks_m) {
    const double step_m = 0.1 * kC_m_s;
    EXPECT_NEAR(mark_m, step_m * std::round(mark_m / step_m), 0.0021);
  }
  EXPECT_GT(*std::max_element(marks_m.begin(), marks_m.end()), 0.99) << "0.7 s: 0.994 m";
}

GameEvent meeting(double t_s, const Vec3& at_m, std::array<Vec2, 2> before, std::array<Vec2, 2> after) {
  GameEvent event;
  event.kind = EventKind::puckPuck;
  event.at = {t_s, at_m};
  for (std::size_t i = 0; i < 2; ++i) event.turns.push_back({i, event.at, before[i], after[i], 0.0});
  return event;
}

Vec2 towards(double azimuth_deg, double beta) {
  const double azimuth_rad = azimuth_deg * std::numbers::pi / 180.0;
  return beta * Vec2(std::cos(azimuth_rad), std::sin(azimuth_rad));
}

struct Angles {
  std::vector<int> degrees;  ///< in tenths, of each plate
  double furthest_m = 0.0;   ///< of flat corners, from the place
};

Angles anglesOf(const std::vector<GameEvent>& events, const Event& eye, const Vec3& place_m = Vec3(0.0)) {
  const ObserverView observer = observerAt(eye, Lorentz(kC_m_s));
  const MarkContext sight{observer, observer.middle, {}, {}, 0, {}, {}, events, {}};
  LabelLayout crowd(sight);
  MarkBuffer batch;
  addAngles(sight, crowd, batch);
  Angles angles;
  std::string last;
  for (const MarkCorner& corner : batch.corners()) {
    const std::string words = test::plateWords(corner);  // "79.0#"
    if (isPlate(corner) && words != last)
      angles.degrees.push_back(static_cast<int>(std::lround(10.0 * std::stod(words))));
    if (isPlate(corner)) last = words;
    if (!isPlate(corner)) {
      angles.furthest_m = std::max(angles.furthest_m, glm::distance(eye.r_m + Vec3(corner.drawn_m), place_m));
    }
  }
  return angles;
}

TEST(Angles, AreThoseBetweenTheWaysOnceTheContactIsSeen) {
  const Event there{1.0, {0.2, 0.1, 0.01}};
  const GameEvent event = meeting(there.t_s, there.r_m, {towards(0.0, 0.9), Vec2(0.0)},
                                  {towards(170.0, 0.5), towards(-111.0, 0.7)});
  const Vec3 eye_m(0.0, -1.5, 0.9);
  const double seen_s = there.t_s + glm::distance(eye_m, there.r_m) / kC_m_s;
  EXPECT_TRUE(anglesOf({event}, {seen_s - 1e-6, eye_m}).degrees.empty());
  const Angles seen = anglesOf({event}, {seen_s + 1e-6, eye_m}, there.r_m);
  ASSERT_EQ(seen.degrees.size(), 1u);
  EXPECT_EQ(seen.degrees[0], 790) << "across the azimuth of 180 degrees";
  EXPECT_LT(seen.furthest_m, 0.31);
  // The last one stays; not so once there is another.
  EXPECT_EQ(anglesOf({event}, {seen_s + 60.0, eye_m}).degrees.size(), 1u);
  const GameEvent later = meeting(there.t_s + 30.0, there.r_m, {towards(0.0, 0.9), towards(180.0, 0.9)},
                                  {towards(10.0, 0.5), towards(100.04, 0.7)});
  const Angles both = anglesOf({event, later}, {seen_s + 30.1, eye_m});
  ASSERT_EQ(both.degrees.size(), 1u);
  EXPECT_EQ(both.degrees[0], 900);
}

TEST(Angles, NeedTwoWays) {
  const Vec3 eye_m(0.0, -1.5, 0.9);
  const GameEvent headOn =
      meeting(1.0, Vec3(0.0), {towards(0.0, 0.5), Vec2(0.0)}, {Vec2(0.0), towards(0.0, 0.5)});
  GameEvent cushion =
      meeting(1.0, Vec3(0.0), {towards(0.0, 0.5), Vec2(0.0)}, {towards(9.0, 0.5), towards(80.0, 0.5)});
  cushion.kind = EventKind::puckCushion;
  EXPECT_TRUE(anglesOf({headOn, cushion}, {9.0, eye_m}).degrees.empty());
}

}  // namespace
}  // namespace carom
