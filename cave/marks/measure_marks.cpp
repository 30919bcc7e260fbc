#include "cave/marks/measure_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

#include "cave/gl/view_colours.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

/// Adds a strip on the cloth.
void addFlat(MarkBuffer& batch, const Resting& draw, const Vec3& from_m, const Vec3& to_m,
             const Vec3& halfWidth_m, const glm::vec4& colour) {
  constexpr std::size_t kPoints = 5;  // light bends straight lines
  std::array<glm::dvec3, kPoints> left, right;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const Vec3 place_m = glm::mix(from_m, to_m, static_cast<double>(i) / (kPoints - 1));
    left[i] = draw(place_m + halfWidth_m);
    right[i] = draw(place_m - halfWidth_m);
  }
  batch.addStrip(left, right, colour);
}

/// Returns how far along its path the eye sees light that started at `start_s`; without retardation, how far
/// the light has come.
double seenOrReached_m(const MarkContext& sight, double start_s, std::span<const Vec3> path_m, double ago_s) {
  const double c_m_s = sight.observer.headFromBoard.lightSpeed_m_s();
  const Event& eye = sight.eye.observation;
  if (!sight.switches.retardation) return reached_m(start_s, path_m, eye.t_s - ago_s, c_m_s);
  return seenAlong_m(start_s, path_m, {eye.t_s - ago_s, eye.r_m}, c_m_s);
}

/// Adds a pulse with its tail, as far as they are seen on the path.
void addPulse(const MarkContext& sight, const Resting& draw, double start_s, std::span<const Vec3> path_m,
              double size_m, const glm::vec3& colour, MarkBuffer& batch) {
  constexpr int kSteps = 10;
  constexpr double kHalfWidth_rad = 0.004, kLeast_rad = 0.014;
  const double length_m = lengthOf(path_m);
  const double head_m = seenOrReached_m(sight, start_s, path_m, 0.0);
  if (head_m <= 0.0) return;
  double behind_m = head_m;
  for (int i = 1; i <= kSteps; ++i) {
    const double share = static_cast<double>(i) / kSteps;
    const double next_m = seenOrReached_m(sight, start_s, path_m, share * kPulseTail_s);
    if (next_m < behind_m) {
      const std::array<glm::dvec3, 2> piece{draw(placeAlong(path_m, behind_m)),
                                            draw(placeAlong(path_m, next_m))};
      const double left = 1.0 - share + 0.5 / kSteps;
      batch.addLine(piece, glm::vec4(colour, static_cast<float>(0.8 * left * left)), kHalfWidth_rad * left);
    }
    behind_m = next_m;
  }
  if (head_m >= length_m) return;
  const glm::dvec3 drawn_m = draw(placeAlong(path_m, head_m));
  const double radius_m = std::max(size_m, kLeast_rad * glm::length(drawn_m));
  batch.addGlow(drawn_m, 2.0 * radius_m, glm::vec4(colour, 0.55F));
  batch.addGlow(drawn_m, radius_m, glm::vec4(colour, 1.0F));
}

/// Adds light that has gone to and fro between two places since board time 0. Its passes begin at k L/c; the
/// eye sees it on one of the last few, where light from its turns has just arrived.
void addToAndFro(const MarkContext& sight, const Resting& draw, const Vec3& a_m, const Vec3& b_m,
                 MarkBuffer& batch) {
  const double c_m_s = sight.observer.headFromBoard.lightSpeed_m_s();
  const Event& eye = sight.eye.observation;
  const double length_m = glm::distance(a_m, b_m);
  const double furthest_m =
      sight.switches.retardation ? std::max(glm::distance(eye.r_m, a_m), glm::distance(eye.r_m, b_m)) : 0.0;
  // Seen since at least one way's time, for any tail; at most length_m more of it than of the light itself.
  const double first = std::floor((c_m_s * (eye.t_s - kPulseTail_s) - furthest_m) / length_m) - 1.0;
  std::array<Vec3, 6> path_m;
  for (std::size_t i = 0; i < path_m.size(); ++i)
    path_m[i] = std::remainder(first + static_cast<double>(i), 2.0) == 0.0 ? a_m : b_m;
  addPulse(sight, draw, first * length_m / c_m_s, path_m, 0.012, kRulerLightColour, batch);
}

}  // namespace

void addRuler(const MarkContext& sight, const Ruler& ruler, LabelLayout& crowd, MarkBuffer& batch) {
  constexpr double kHalfBar_m = 0.014, kGap_m = 0.006, kMark_m = 0.018, kHalfLine_m = 0.002;
  const Resting draw(sight);
  const double c_m_s = sight.observer.headFromBoard.lightSpeed_m_s();
  const Vec3 up(0.0, 0.0, 1.0);
  const auto at = [&](double along_m, double aside_m) {
    return ruler.from_m + along_m * ruler.along + aside_m * ruler.aside + kOnCloth_m * up;
  };
  for (int i = 0; i < 10; ++i) {
    const float grey = i % 2 == 0 ? 0.93F : 0.10F;
    addFlat(batch, draw, at(0.1 * i, 0.0), at(0.1 * (i + 1), 0.0), kHalfBar_m * ruler.aside,
            glm::vec4(glm::vec3(grey), 1.0F));
  }
  StandingPlate plate = standingPlate(sight, measured(texts::plate::kLength, kRuler_m), PlateShape::box,
                                      at(kRuler_m + 0.08, 0.0));
  plate.foot_m.z += crowd.raise_m(plate);
  addPlate(batch, sight, plate, glm::vec4(0.93F, 0.93F, 0.93F, 1.0F),
           [&](const Vec3& offset_m) { return draw(plate.foot_m + offset_m); });
  if (c_m_s > kFastestOnRuler_m_s) return;
  const double nearSide_m = kHalfBar_m + kGap_m;
  for (int tenths = 0; 0.1 * tenths * c_m_s <= kRuler_m; ++tenths) {
    const double along_m = 0.1 * tenths * c_m_s, size_m = tenths % 5 == 0 ? 2.0 * kMark_m : kMark_m;
    addFlat(batch, draw, at(along_m, nearSide_m), at(along_m, nearSide_m + size_m), kHalfLine_m * ruler.along,
            glm::vec4(kRulerLightColour, 1.0F));
  }
  addToAndFro(sight, draw, at(0.0, nearSide_m) + 0.01 * up, at(kRuler_m, nearSide_m) + 0.01 * up, batch);
}

namespace {

/// Returns whether a puck moves, so that its path has a direction.
bool hasWay(const Vec2& beta) { return glm::length(beta) > 1e-6; }

double azimuthOf(const Vec2& way) { return std::atan2(way.y, way.x); }

/// Adds an arc on the cloth, from one azimuth on by `turn_rad`; `half_m` is half its width.
void addArc(MarkBuffer& batch, const Resting& draw, const Vec3& middle_m, double from_rad, double turn_rad,
            double radius_m, double half_m, const glm::vec4& colour) {
  constexpr std::size_t kPoints = 33;
  std::array<glm::dvec3, kPoints> inner, outer;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double azimuth_rad = from_rad + turn_rad * static_cast<double>(i) / (kPoints - 1);
    const Vec3 way(std::cos(azimuth_rad), std::sin(azimuth_rad), 0.0);
    inner[i] = draw(middle_m + (radius_m - half_m) * way);
    outer[i] = draw(middle_m + (radius_m + half_m) * way);
  }
  batch.addStrip(inner, outer, colour);
}

/// Adds a line on the cloth from the middle in a direction, dashed or solid.
void addRay(MarkBuffer& batch, const Resting& draw, const Vec3& middle_m, double azimuth_rad, double length_m,
            int dashes, double half_m, const glm::vec4& colour) {
  const Vec3 way(std::cos(azimuth_rad), std::sin(azimuth_rad), 0.0), aside(-way.y, way.x, 0.0);
  const double step_m = length_m / (dashes > 1 ? 2 * dashes - 1 : 1);
  for (int i = 0; i < dashes; ++i) {
    const double from_m = 2.0 * i * step_m;
    addFlat(batch, draw, middle_m + from_m * way, middle_m + (from_m + step_m) * way, half_m * aside, colour);
  }
}

/// Returns the turn from one azimuth to another, the shorter way round.
double turnBetween(double from_rad, double to_rad) {
  return std::remainder(to_rad - from_rad, 2.0 * std::numbers::pi);
}

void addParting(const MarkContext& sight, const Resting& draw, const GameEvent& event, float shown,
                LabelLayout& crowd, MarkBuffer& batch) {
  constexpr double kRay_m = 0.30, kArc_m = 0.21, kHalf_m = 0.0025, kThin_m = 0.0012;
  const glm::vec4 colour(kAngleColour, shown), faint(kAngleColour, 0.8F * shown);
  const Vec3 middle_m(event.at.r_m.x, event.at.r_m.y, kOnCloth_m);
  const std::array<double, 2> ways_rad{azimuthOf(event.turns[0].betaAfter),
                                       azimuthOf(event.turns[1].betaAfter)};
  const double apart_rad = turnBetween(ways_rad[0], ways_rad[1]);
  for (const double way_rad : ways_rad) addRay(batch, draw, middle_m, way_rad, kRay_m, 1, kHalf_m, colour);
  addArc(batch, draw, middle_m, ways_rad[0], apart_rad, kArc_m, kHalf_m, colour);
  for (std::size_t rested = 0; rested < 2; ++rested) {
    const Vec2& before = event.turns[1 - rested].betaBefore;
    if (hasWay(event.turns[rested].betaBefore) || !hasWay(before)) continue;
    const double came_rad = azimuthOf(before);
    addRay(batch, draw, middle_m, came_rad, 0.8 * kRay_m, 6, kThin_m, faint);
    addArc(batch, draw, middle_m, came_rad, turnBetween(came_rad, ways_rad[1 - rested]), 0.45 * kRay_m,
           kThin_m, faint);
    addArc(batch, draw, middle_m, came_rad, turnBetween(came_rad, ways_rad[rested]), 0.35 * kRay_m, kThin_m,
           faint);
  }
  const double middle_rad = ways_rad[0] + 0.5 * apart_rad;
  const Vec3 foot_m = middle_m + (kArc_m + 0.03) * Vec3(std::cos(middle_rad), std::sin(middle_rad), 0.0);
  StandingPlate plate =
      standingPlate(sight, measured(texts::plate::kAngle, std::abs(apart_rad) * 180.0 / std::numbers::pi),
                    PlateShape::box, foot_m);
  plate.foot_m.z += crowd.raise_m(plate);
  const std::array<glm::dvec3, 2> pin{draw(foot_m), draw(plate.foot_m)};
  batch.addLine(pin, faint, 0.0008);
  addPlate(batch, sight, plate, colour, [&](const Vec3& offset_m) { return draw(plate.foot_m + offset_m); });
}

}  // namespace

void addAngles(const MarkContext& sight, LabelLayout& crowd, MarkBuffer& batch) {
  const Resting draw(sight);
  const auto parts = [](const GameEvent& event) {
    return event.kind == EventKind::puckPuck && event.turns.size() == 2 && hasWay(event.turns[0].betaAfter) &&
           hasWay(event.turns[1].betaAfter);
  };
  double newest_s = std::numeric_limits<double>::infinity();
  for (const GameEvent& event : sight.events) {
    const double age_s = seenSince_s(sight, event.at);
    if (parts(event) && age_s >= 0.0) newest_s = std::min(newest_s, age_s);
  }
  for (const GameEvent& event : sight.events) {
    const double age_s = seenSince_s(sight, event.at);
    if (!parts(event) || !(age_s >= 0.0)) continue;
    const double left = age_s == newest_s ? 1.0 : std::clamp(2.0 * (1.0 - age_s / kAngleShown_s), 0.0, 1.0);
    if (left > 0.0) addParting(sight, draw, event, static_cast<float>(left), crowd, batch);
  }
}

void addPulses(const MarkContext& sight, std::span<const LightPath> pulses, MarkBuffer& batch) {
  const Resting draw(sight);
  for (std::size_t i = 0; i < pulses.size(); ++i) {
    constexpr double kSize_m = 0.025;
    addPulse(sight, draw, pulses[i].start_s, pulses[i].path_m, kSize_m,
             kPulseColours[i % kPulseColours.size()], batch);
  }
}

}  // namespace carom
