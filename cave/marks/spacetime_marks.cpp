#include "cave/marks/spacetime_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <vtk_glew.h>
#include <glm/geometric.hpp>

#include "cave/frame/event_mark.h"
#include "cave/gl/gl_state_guard.h"
#include "cave/gl/view_colours.h"
#include "cave/marks/measure_marks.h"
#include "cave/marks/travelling_light.h"
#include "cave/scene/person_model.h"
#include "engine/linked/told.h"

namespace carom {
namespace {

/// Adds an arc of the light's sphere: around the vertical at one height, or over the top at one azimuth.
template <typename Direction>
void addArc(MarkBuffer& batch, const Resting& draw, const Vec3& middle_m, double radius_m,
            const glm::vec4& colour, const Direction& direction) {
  constexpr double kHalfWidth_rad = 0.0009;
  std::array<glm::dvec3, kAround + 1> arc;
  for (std::size_t i = 0; i <= kAround; ++i)
    arc[i] = draw(middle_m + radius_m * direction(static_cast<double>(i) / kAround));
  batch.addLine(arc, colour, kHalfWidth_rad);
}

/// Adds the light of a flash on its way: the part of its sphere above the cloth, as hoops, and the ring on
/// the cloth.
void addSphere(MarkBuffer& batch, const Resting& draw, const Event& flash, double radius_m,
               const glm::vec3& colour) {
  const double left = std::clamp(1.0 - radius_m / kSphere_m, 0.0, 1.0);
  const glm::vec4 faint(colour, static_cast<float>(0.55 * left));
  constexpr double kPi = std::numbers::pi;
  for (int i = 0; i < 6; ++i) {
    const double azimuth_rad = kPi * i / 6.0;
    addArc(batch, draw, flash.r_m, radius_m, faint, [&](double share) {
      const double rise_rad = kPi * share;
      return Vec3(std::cos(azimuth_rad) * std::cos(rise_rad), std::sin(azimuth_rad) * std::cos(rise_rad),
                  std::sin(rise_rad));
    });
  }
  for (const double rise_rad : {kPi / 8.0, kPi / 4.0, 3.0 * kPi / 8.0}) {
    addArc(batch, draw, flash.r_m, radius_m, faint, [&](double share) {
      const double azimuth_rad = 2.0 * kPi * share;
      return Vec3(std::cos(rise_rad) * std::cos(azimuth_rad), std::cos(rise_rad) * std::sin(azimuth_rad),
                  std::sin(rise_rad));
    });
  }
  const double rise_m = flash.r_m.z - kOnCloth_m;
  if (!(radius_m > std::abs(rise_m))) return;
  const double onCloth_m = std::sqrt((radius_m - rise_m) * (radius_m + rise_m));
  const double half_m = std::min(0.008, 0.5 * onCloth_m);
  addClothRing(batch, draw, {flash.r_m.x, flash.r_m.y, kOnCloth_m}, onCloth_m - half_m, onCloth_m + half_m,
               glm::vec4(colour, static_cast<float>(0.4 + 0.6 * left)));
}

/// Returns the colour of a flash: that of the puck in which it happens, or that of flashes.
glm::vec3 flashColour(const MarkContext& sight, std::span<const glm::vec3> colours, const Event& flash) {
  for (std::size_t body = 1; body <= sight.pucks && body < colours.size(); ++body) {
    const WorldLine& line = sight.histories[body];
    if (glm::distance(line.at(flash.t_s).event.r_m, flash.r_m) < line.radius_m() + 0.02)
      return lightOf(colours[body]);
  }
  return kFlashColour;
}

/// Adds a ring around the place and, on a pin, a flag with the text. The event has been seen for `age_s`.
void addMarker(MarkBuffer& batch, const MarkContext& sight, const Resting& draw, const GameEvent& event,
               const PlateText& text, double age_s, float shown, const glm::vec3& flashing,
               LabelLayout& crowd) {
  const bool flash = event.kind == EventKind::flash;
  const glm::vec4 colour(flash ? flashing : kEventColour, shown);
  const Vec3& at_m = event.at.r_m;
  addClothRing(batch, draw, {at_m.x, at_m.y, kOnCloth_m}, 0.018, 0.026, colour);
  constexpr double kPin_m = 0.10;
  StandingPlate flag = standingPlate(sight, text, PlateShape::flag, at_m + Vec3(0.0, 0.0, kPin_m));
  flag.scale *= 0.8;
  flag.foot_m.z += crowd.raise_m(flag);
  const std::array<glm::dvec3, 2> pin{draw(at_m), draw(flag.foot_m)};
  batch.addLine(pin, colour, 0.001);
  addPlate(batch, sight, flag, colour, [&](const Vec3& offset_m) { return draw(flag.foot_m + offset_m); });
  const double glowing = 1.0 - age_s / kFlashSeen_s;
  if (glowing <= 0.0) return;
  const glm::vec4 light(flashing, static_cast<float>(glowing));
  // The flash is drawn nearer than everything that could cut it: it is dazzle, not an object on the table.
  constexpr double kNearer = 0.6;
  batch.addGlow(kNearer * draw(at_m), kNearer * (flash ? 0.3 : 0.08), light);
}

/// Selects the events that the eye has seen last, the latest first.
class Latest {
 public:
  struct Seen {
    const GameEvent* event = nullptr;
    double age_s = 0.0;
  };
  void add(const Seen& seen) {
    std::size_t at = count_ < seen_.size() ? count_++ : seen_.size();
    for (; at > 0 && seen.age_s < seen_[at - 1].age_s; --at) {
      if (at < seen_.size()) seen_[at] = seen_[at - 1];
    }
    if (at < seen_.size()) seen_[at] = seen;
  }
  std::span<const Seen> seen() const { return std::span(seen_).first(count_); }

 private:
  std::array<Seen, kMostMarkers> seen_{};
  std::size_t count_ = 0;
};

}  // namespace

void addEvents(const MarkContext& sight, std::span<const glm::vec3> colours,
               std::span<const std::string> flashes, LabelLayout& crowd, MarkBuffer& batch) {
  const Resting draw(sight);
  const double c_m_s = sight.observer.headFromBoard.lightSpeed_m_s();
  Latest latest;
  for (const GameEvent& event : sight.events) {
    if (event.kind == EventKind::flash) {
      const double radius_m = c_m_s * (boardNow_s(sight) - event.at.t_s);
      if (radius_m > 0.0 && radius_m < kSphere_m)
        addSphere(batch, draw, event.at, radius_m, flashColour(sight, colours, event.at));
    }
    const double age_s = seenSince_s(sight, event.at);
    if (age_s >= 0.0 && age_s < kEventShown_s) latest.add({&event, age_s});
  }
  double rank = 0.0;
  for (const auto& [event, age_s] : latest.seen()) {
    const double byAge = std::clamp(2.0 * (1.0 - age_s / kEventShown_s), 0.0, 1.0);
    const double byRank = std::min(1.0, 1.4 * (1.0 - rank++ / static_cast<double>(kMostMarkers)));
    const glm::vec3 flashing =
        event->kind == EventKind::flash ? flashColour(sight, colours, event->at) : kFlashColour;
    const PlateText text = plateText(eventMark(*event, flashes));
    addMarker(batch, sight, draw, *event, text, age_s, static_cast<float>(byAge * byRank), flashing, crowd);
  }
}

namespace {

/// Adds clocks around the rim, `radius_m` from the centre, of a large disc that turns evenly and has met
/// nothing: each runs slow by its γ, and was set to 0 with the centre's, in the centre's rest frame. While a
/// lesson asks, they would tell the answer.
void addRimClocks(const MarkContext& sight, std::size_t body, double radius_m, double centre_s,
                  const Vec3& middle_m, const glm::vec4& colour, MarkBuffer& batch) {
  constexpr int kClocks = 6;
  constexpr double kLeast_m = 0.2, kStem_m = 0.05;
  const WorldLine& line = sight.histories[body];
  const double c_m_s = line.lightSpeed_m_s();
  const Spin& spin = line.knots().front().spin;
  const double rim = spin.omega_rad_s * radius_m / c_m_s;
  const BodyView& view = sight.bodies[body];
  if (sight.lesson.phase == LessonPhase::asks) return;
  if (line.knots().size() > 1 || rim == 0.0 || spin.slowing_1_s > 0.0 || radius_m < kLeast_m) return;
  const Resting resting(sight);
  const OnBody draw(sight, view, ViewTime::seen);
  for (int k = 0; k < kClocks; ++k) {
    const double angle_rad = 2.0 * std::numbers::pi * k / kClocks;
    const Vec3 foot_m(radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad), 0.0);
    const double rim_s =
        (centre_s + emissionIn(view, foot_m).event.x / c_m_s) * std::sqrt((1.0 - rim) * (1.0 + rim));
    const std::array<glm::dvec3, 2> stem{draw(foot_m), draw(foot_m + Vec3(0.0, 0.0, kStem_m))};
    batch.addLine(stem, colour, 0.0014);
    const StandingPlate plate = standingPlate(sight, tenthsOf(rim_s), PlateShape::clock, middle_m);
    addPlate(batch, sight, plate, colour, [&](const Vec3& offset_m) {
      return stem[1] + resting(plate.foot_m + offset_m) - resting(plate.foot_m);
    });
  }
}

}  // namespace

void addPuckClocks(const MarkContext& sight, const MarkedBodies& marked, LabelLayout& crowd,
                   MarkBuffer& batch) {
  const Event& between = sight.observer.middle.observation;
  const Resting resting(sight);
  for (std::size_t body = 1; body <= sight.pucks; ++body) {
    const OnBody draw(sight, sight.bodies[body], ViewTime::seen);
    const Motion centre = centreSeen(sight.histories[body], sight.eye.observation, sight.switches);
    const Vec3 middle_m = centreSeen(sight.histories[body], between, sight.switches).event.r_m;
    const Vec3 above_m(0.0, 0.0, marked.reach_m[body] + 0.01);
    StandingPlate plate =
        standingPlate(sight, tenthsOf(centre.properTime_s), PlateShape::clock, middle_m + above_m);
    plate.scale *= 1.15;
    const Vec3 foot_m = above_m + Vec3(0.0, 0.0, crowd.raise_m(plate));
    const glm::vec4 colour(codeOf(glm::max(marked.colours[body], glm::vec3(0.08F))), 1.0F);
    const std::array<glm::dvec3, 2> stem{draw(Vec3(0.0)), draw(foot_m)};
    batch.addLine(stem, colour, 0.0014);
    addRimClocks(sight, body, marked.rims_m[body], centre.properTime_s, middle_m, colour, batch);
    // The plate is no object of the scene: it stands upright, as if at rest, so that it can be read at any
    // speed.
    addPlate(batch, sight, plate, colour, [&](const Vec3& offset_m) {
      return stem[1] + resting(plate.foot_m + offset_m) - resting(plate.foot_m);
    });
  }
}

void addPeopleClocks(const MarkContext& sight, std::size_t firstPerson, LabelLayout& crowd,
                     MarkBuffer& batch) {
  constexpr double kAboveEyes_m = 0.24, kBetweenPlates_m = 0.012;
  const Resting resting(sight);
  for (const ToldView& person : sight.people) {
    const std::size_t number = person.moment->person, body = firstPerson + kBodiesOfPerson * number;
    const Vec3 above_m(0.0, 0.0, kAboveEyes_m);
    StandingPlate plate =
        standingPlate(sight, tenthsOf(person.properTime_s), PlateShape::clock, person.head.r_m + above_m);
    const Vec3 foot_m = above_m + Vec3(0.0, 0.0, crowd.raise_m(plate));
    const glm::dvec3 top_m = OnBody(sight, sight.bodies[body], ViewTime::seen)(foot_m);
    const glm::vec4 colour(codeOf(glm::max(kCoatColours[number], glm::vec3(0.08F))), 1.0F);
    const auto draw = [&](const Vec3& offset_m) {
      return top_m + resting(plate.foot_m + offset_m) - resting(plate.foot_m);
    };
    addPlate(batch, sight, plate, colour, draw);
    if (person.moment->nameText() == kUnnamed) continue;
    StandingPlate name = plate;
    name.text = plateText(person.moment->nameText());
    name.shape = PlateShape::flag;
    const Vec3 higher_m(0.0, 0.0, kBetweenPlates_m + plate.height_m());
    addPlate(batch, sight, name, colour, [&](const Vec3& offset_m) { return draw(higher_m + offset_m); });
  }
}

namespace {

/// Adds a figure of `corners` around a place, seen from the front, between two radii.
void addFigure(MarkBuffer& batch, const glm::dvec3& drawn_m, const glm::dvec3& up_m, int corners,
               double inner_m, double outer_m, const glm::vec4& colour) {
  const glm::dvec3 across_m = glm::cross(drawn_m, up_m);
  if (!(glm::length(across_m) > 0.0)) return;
  const glm::dvec3 right = glm::normalize(across_m);
  const glm::dvec3 up = glm::normalize(glm::cross(right, drawn_m));
  std::array<glm::dvec3, kAround + 1> inner, outer;
  for (int i = 0; i <= corners; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * i / corners;
    const glm::dvec3 direction = std::sin(angle_rad) * right + std::cos(angle_rad) * up;
    inner[static_cast<std::size_t>(i)] = drawn_m + inner_m * direction;
    outer[static_cast<std::size_t>(i)] = drawn_m + outer_m * direction;
  }
  const auto count = static_cast<std::size_t>(corners) + 1;
  batch.addStrip(std::span(inner).first(count), std::span(outer).first(count), colour);
}

void addBeacon(MarkBuffer& batch, const OnBody& draw, const glm::vec3& ownColour, double top_m,
               ViewTime moment) {
  constexpr double kPin_m = 0.11, kFigure_m = 0.02, kOwn_m = 0.55 * kFigure_m;
  const bool mine = moment == ViewTime::myNow;
  const glm::vec4 colour(mine ? kMyNowColour : kBoardNowColour, 1.0F);
  const std::array<glm::dvec3, 2> pin{draw(Vec3(0.0)), draw({0.0, 0.0, top_m + kPin_m})};
  batch.addLine(pin, colour, 0.0009);
  const glm::dvec3 up_m = pin[1] - pin[0];
  const double length_m = glm::length(up_m);
  if (!(length_m > 0.0)) return;
  const glm::dvec3 middle_m = pin[1] + up_m * (kFigure_m / length_m);
  const int corners = mine ? 24 : 4;
  const double inner_m = mine ? kFigure_m : kOwn_m;  // the ring goes around the diamond
  addFigure(batch, middle_m, up_m, corners, inner_m, mine ? 1.4 * kFigure_m : kFigure_m, colour);
  addFigure(batch, middle_m, up_m, corners, 0.0, inner_m, glm::vec4(codeOf(ownColour), 1.0F));
}

}  // namespace

void addBeacons(const MarkContext& sight, std::span<const glm::vec3> colours, std::span<const double> tops_m,
                MarkBuffer& batch) {
  const auto add = [&](std::span<const BodyView> ghosts, ViewTime moment) {
    for (std::size_t body = 1; body < ghosts.size(); ++body) {
      if (ghosts[body].legs.empty()) continue;
      addBeacon(batch, OnBody(sight, ghosts[body], moment), colours[body], tops_m[body], moment);
    }
  };
  add(sight.ghosts.myNow, ViewTime::myNow);
  add(sight.ghosts.boardNow, ViewTime::boardNow);  // the same for a head at rest: within the ring
}

SpacetimeMarks::SpacetimeMarks(const Scene& scene)
    : colours_(scene.bodyCount),
      reach_m_(scene.reach_m),
      tops_m_(scene.bodyCount),
      rims_m_(rimsOf(scene)),
      ruler_(scene.ruler),
      pulses_(scene.pulses),
      lesson_(scene.lesson),
      flashes_(scene.flashes),
      firstPerson_(scene.firstPerson) {
  reach_m_.resize(scene.bodyCount);
  for (const ScenePart& part : scene.parts) {
    if (part.paint == Paint::shadow) continue;
    colours_[part.body] = part.colour;
    tops_m_[part.body] = std::max(tops_m_[part.body], part.mesh->GetBounds()[5]);  // VTK's zmax
  }
}

void SpacetimeMarks::look(const MarkContext& sight) {
  pucks_ = sight.pucks;
  pathsShown_ = sight.views.paths != 0;
  if (pathsShown_) {
    const auto pucks = sight.histories.subspan(1, pucks_);
    paths_.follow(pucks, boardNow_s(sight));
    paths_.look(pucks, sight.eye.observation, sight.switches, boardNow_s(sight));
  }
  drawnFromBoard_ =
      glm::mat4(ViewFrame(sight.observer.headFromBoard, sight.switches).drawnFromBoard.matrix());
  batch_.clear();
  LabelLayout crowd(sight);
  if (sight.views.ruler) addRuler(sight, ruler_, crowd, batch_);
  if (sight.views.clocks) addPuckClocks(sight, {colours_, reach_m_, rims_m_}, crowd, batch_);
  addPeopleClocks(sight, firstPerson_, crowd, batch_);
  if (sight.views.events) addEvents(sight, colours_, flashes_, crowd, batch_);
  if (sight.views.news) addNews(sight, colours_, batch_);
  addStrokes(sight, batch_);
  if (sight.views.speeds) addSeenSpeeds(sight, tops_m_, crowd, batch_);
  if (sight.views.angles) addAngles(sight, crowd, batch_);
  addBeacons(sight, colours_, tops_m_, batch_);
  addPulses(sight, pulses_, batch_);
  addLessonMarks(sight, lesson_.read(), tops_m_, crowd, batch_);
  marks_.upload(batch_);
}

void SpacetimeMarks::draw(const glm::mat4& clipFromDrawn, unsigned framebuffer, const glm::ivec2& size_px,
                          float cutAt) const {
  const GlStateGuard state(framebuffer, size_px);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  blendOver();
  if (pathsShown_) paths_.draw(clipFromDrawn, drawnFromBoard_, std::span(colours_).subspan(1, pucks_));
  marks_.draw(clipFromDrawn, cutAt);
}

}  // namespace carom
