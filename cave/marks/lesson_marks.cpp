#include "cave/marks/lesson_marks.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cave/frame/lesson_readings.h"
#include "cave/gl/view_colours.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

/// Computes where the events of a line of simultaneity are drawn: where ghosts show the observer's now, at
/// their places in that frame, and otherwise at the places of the board as it is seen.
class OnSimultaneity {
 public:
  OnSimultaneity(const MarkContext& sight, const Event& with, const Vec3& beta)
      : drawnFromBoard_(
            ViewFrame(sight.observer.headFromBoard, sight.switches, ViewTime::myNow).seenFromBoard),
        seen_(sight),
        atGhosts_(sight.views.myNow != 0),
        eye_(sight.eye.observation),
        with_(with),
        beta_(beta) {}
  /// Returns the board time of the simultaneous event at this place of the board.
  double at_s(const Vec3& place_m) const {
    return simultaneousAt_s(with_, place_m, beta_, drawnFromBoard_.lightSpeed_m_s());
  }
  glm::dvec3 operator()(const Vec3& place_m) const {
    if (!atGhosts_) return seen_(place_m);
    return (drawnFromBoard_ * (Event{at_s(place_m), place_m} - eye_)).dr_m;
  }

 private:
  Lorentz drawnFromBoard_;
  Resting seen_;
  bool atGhosts_;
  Event eye_, with_;
  Vec3 beta_;
};

/// Adds a straight strip on the cloth.
template <typename Draw>
void addStripe(MarkBuffer& batch, const Draw& draw, const Vec3& from_m, const Vec3& to_m, double half_m,
               const glm::vec4& colour) {
  constexpr std::size_t kPoints = 17;  // aberration bends straight lines
  const Vec3 way = glm::normalize(to_m - from_m);
  const Vec3 aside_m = half_m * Vec3(-way.y, way.x, 0.0), up_m(0.0, 0.0, kOnCloth_m);
  std::array<glm::dvec3, kPoints> left, right;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const Vec3 place_m = up_m + glm::mix(from_m, to_m, static_cast<double>(i) / (kPoints - 1));
    left[i] = draw(place_m + aside_m);
    right[i] = draw(place_m - aside_m);
  }
  batch.addStrip(left, right, colour);
}

/// Adds a plate on a thin stem above a place of the board.
template <typename Draw>
void addStandingPlate(MarkBuffer& batch, const MarkContext& sight, const Draw& draw, const PlateText& text,
                      PlateShape shape, const Vec3& foot_m, const glm::vec4& colour, LabelLayout& crowd) {
  constexpr double kStem_m = 0.07;
  StandingPlate plate = standingPlate(sight, text, shape, foot_m + Vec3(0.0, 0.0, kStem_m));
  plate.scale *= 1.25;
  plate.foot_m.z += crowd.raise_m(plate);
  const std::array<glm::dvec3, 2> stem{draw(foot_m), draw(plate.foot_m)};
  batch.addLine(stem, colour, 0.0014);
  addPlate(batch, sight, plate, colour, [&](const Vec3& offset_m) { return draw(plate.foot_m + offset_m); });
}

/// Returns the colour of a frame's clocks: that of "now" in the frame.
glm::vec4 colourOf(const Vec3& beta) {
  return glm::vec4(beta == Vec3(0.0) ? kBoardNowColour : kMyNowColour, 1.0F);
}

void addSimultaneity(const MarkContext& sight, const SimultaneityLine& line, LabelLayout& crowd,
                     MarkBuffer& batch) {
  constexpr int kClocks = 5;
  const Vec3 beta = line.beta.value_or(betaFromU(sight.boardFromRoom.u()));
  const OnSimultaneity draw(sight, line.with, beta);
  const glm::vec4 colour = colourOf(beta);
  const auto at = [&](double x_m) { return Vec3(x_m, line.with.r_m.y, 0.0); };
  addStripe(batch, draw, at(line.from_m), at(line.to_m), 0.006, colour);
  for (int i = 0; i < kClocks; ++i) {
    const Vec3 place_m = at(glm::mix(line.from_m, line.to_m, static_cast<double>(i) / (kClocks - 1)));
    addStandingPlate(batch, sight, draw, hundredthsOf(draw.at_s(place_m)), PlateShape::clock, place_m, colour,
                     crowd);
  }
}

/// Returns where the eye sees the top of a body, `top_m` above its centre.
Vec3 topSeen_m(const MarkContext& sight, std::size_t body, double top_m) {
  const Event& between = sight.observer.middle.observation;
  return centreSeen(sight.histories[body], between, sight.switches).event.r_m + Vec3(0.0, 0.0, top_m);
}

void addCounter(const MarkContext& sight, const Resting& draw, const TickCounter& counter, double top_m,
                LabelLayout& crowd, MarkBuffer& batch) {
  addStandingPlate(batch, sight, draw, wholeNumber(seenTicks(sight, counter)), PlateShape::box,
                   topSeen_m(sight, counter.body, top_m), glm::vec4(kFlashColour, 1.0F), crowd);
}

/// Adds an arrow that comes from above on the right, in the plane that faces the person, and ends at `tip_m`.
void addArrow(const MarkContext& sight, const Resting& draw, const Vec3& tip_m, MarkBuffer& batch) {
  constexpr double kLength_m = 0.17, kHead_m = 0.06, kHalfHead_m = 0.032, kHalfShaft_m = 0.011;
  constexpr double kBorder_m = 0.006;
  const double scale = standingPlate(sight, {}, PlateShape::box, tip_m).scale;
  const Vec3 right = rightOf(sight, tip_m), up(0.0, 0.0, 1.0);
  const Vec3 back = glm::normalize(0.6 * right + up), aside = glm::normalize(right - 0.6 * up);
  const auto at = [&](double back_m, double aside_m) {
    return draw(tip_m + scale * (back_m * back + aside_m * aside));
  };
  // First larger and dark, as its border.
  for (const double border_m : {kBorder_m, 0.0}) {
    const glm::vec4 colour(border_m > 0.0 ? glm::vec3(0.02F) : kFlashColour, 1.0F);
    const double tip = -2.0 * border_m, shoulder = kHead_m + border_m, end = kLength_m + border_m;
    const double head = kHalfHead_m + 2.0 * border_m, shaft = kHalfShaft_m + border_m;
    const auto side = [&](double way) {
      return std::array{at(tip, 0.0), at(shoulder, way * head), at(shoulder, way * shaft),
                        at(end, way * shaft)};
    };
    batch.addStrip(side(-1.0), side(1.0), colour);
  }
}

/// Adds an arrow that ends a little above its body or its place.
void addArrow(const MarkContext& sight, const Resting& draw, const LessonArrow& arrow,
              std::span<const double> tops_m, MarkBuffer& batch) {
  constexpr double kAbove_m = 0.015;
  const Vec3 at_m = arrow.body ? topSeen_m(sight, *arrow.body, tops_m[*arrow.body]) : arrow.at_m;
  addArrow(sight, draw, at_m + Vec3(0.0, 0.0, kAbove_m), batch);
}

/// Adds a plate above a body with a quantity of it; none if it is less than `least`.
void addGauge(const MarkContext& sight, const Resting& draw, const Gauge& gauge, double top_m, double least,
              LabelLayout& crowd, MarkBuffer& batch) {
  const Motion seen =
      centreSeen(sight.histories[gauge.body], sight.observer.middle.observation, sight.switches);
  const double value =
      gauged(gauge.quantity, seen, {sight.observer, sight.boardFromRoom, sight.lesson.phase, sight.switches});
  if (!(value >= least)) return;
  addStandingPlate(
      batch, sight, draw, measured(texts::plate::kGauges[static_cast<std::size_t>(gauge.quantity)], value),
      PlateShape::box, seen.event.r_m + Vec3(0.0, 0.0, top_m), glm::vec4(kFlashColour, 1.0F), crowd);
}

}  // namespace

void addSeenSpeeds(const MarkContext& sight, std::span<const double> tops_m, LabelLayout& crowd,
                   MarkBuffer& batch) {
  constexpr double kAtRest = 5e-3;  // of c: half of the plate's last digit
  const Resting draw(sight);
  for (std::size_t body = 1; body <= sight.pucks; ++body)
    addGauge(sight, draw, {body, GaugeQuantity::apparentSpeed}, tops_m[body], kAtRest, crowd, batch);
}

std::size_t seenTicks(const MarkContext& sight, const TickCounter& counter) {
  return static_cast<std::size_t>(
      std::count_if(counter.ticks.begin(), counter.ticks.end(),
                    [&](const Event& tick) { return seenSince_s(sight, tick) >= 0.0; }));
}

void addLessonMarks(const MarkContext& sight, const LessonPlan& plan, std::span<const double> tops_m,
                    LabelLayout& crowd, MarkBuffer& batch) {
  if (sight.lesson.phase == LessonPhase::none) return;
  const Resting draw(sight);
  for (const ClothLine& line : plan.lines)
    addStripe(batch, draw, line.from_m, line.to_m, 0.006, glm::vec4(kFlashColour, 1.0F));
  for (const LessonLabel& label : plan.labels) {
    if (label.explains && sight.lesson.phase != LessonPhase::explains) continue;
    addStandingPlate(batch, sight, draw, plateText(label.words), PlateShape::box, label.at_m,
                     glm::vec4(kFlashColour, 1.0F), crowd);
  }
  if (sight.lesson.phase == LessonPhase::asks) return;
  for (const TickCounter& counter : plan.counters)
    addCounter(sight, draw, counter, tops_m[counter.body], crowd, batch);
  for (const Gauge& gauge : plan.gauges) addGauge(sight, draw, gauge, tops_m[gauge.body], 0.0, crowd, batch);
  for (const Stopwatch& watch : plan.stopwatches) {
    if (!watch.stands_m) continue;
    addStandingPlate(
        batch, sight, draw,
        hundredthsOf(reading_s(watch, {sight.observer, sight.boardFromRoom, sight.lesson.phase})),
        PlateShape::clock, *watch.stands_m, colourOf(watch.beta), crowd);
  }
  const bool explains = sight.lesson.phase == LessonPhase::explains;
  if (explains)
    for (const SimultaneityLine& line : plan.simultaneous) addSimultaneity(sight, line, crowd, batch);
  for (const LessonArrow& arrow : plan.arrows)
    if (arrow.explains == explains) addArrow(sight, draw, arrow, tops_m, batch);
}

}  // namespace carom
