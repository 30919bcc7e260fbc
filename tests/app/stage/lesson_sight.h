#pragma once
// A lesson as it is drawn on the wall of a desk, and where on that wall its things ought to be, by other
// equations than the code's: light's travel time by bisection, aberration by its angle, the observer's "now"
// by the Lorentz transform, and the wall by similar triangles.

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/live/live_source.h"
#include "app/operator/room_languages.h"
#include "app/operator/visitor_choices.h"
#include "app/scenario/starting_histories.h"
#include "app/session/director.h"
#include "app/session/game_settings.h"
#include "app/stage/scenario_scene.h"
#include "cave/display/display_walls.h"
#include "cave/gl/graphics.h"
#include "cave/overlay/band_layout.h"
#include "cave/pictures/image.h"
#include "places.h"

namespace carom::test {

inline constexpr double kEyes_m = 1.7;  // of a person who stands

/// The record of a lesson's moment: while it explains, or as it is shown for the first velocity.
class LessonMoment {
 public:
  LessonMoment(const Rig& rig, const std::string& lesson, LessonPhase wanted)
      : phase(wanted), scenario(readScenario(fileOfGame(lesson))) {
    world.histories = startingHistories(scenario);
    Beginning beginning;
    beginning.lesson = phase;
    beginning.languages = std::make_shared<const SessionLanguages>(languagesOf(rig, nullptr, ""));
    OperatorSettings settings = settingsOf(rig, scenario, fileOfGame(lesson), beginning);
    settings.lesson.phase = LessonPhase::explains;  // which goes to the moment at once
    observer = settings.lessonObserver;
    LiveSource source(rig, scenario, world, {});
    FrameLeader leader(source, KeysOf::session, settings,
                       [](const WindowInput&, bool) { return DeskInput{}; });
    SimulatedClock clock;
    Pacer pacer(clock, 60.0, 0.0, false, 0);
    Decision decision;
    leader.decide(pacer.next(), {}, decision);
    applyFrame(decision.frame, world);
    record = decision.frame.record;
    record.lesson.phase = phase;
  }

  const LessonPlan& plan() const { return scenario.lesson->plan; }
  double c_m_s() const { return scenario.billiard.lightSpeed_m_s; }
  double moment_s() const {
    return plan().interval.keepsClocks ? plan().interval.from_s : plan().interval.moment_s;
  }
  std::size_t bodyNamed(const std::string& name) const {
    const auto& pucks = scenario.billiard.pucks;
    for (std::size_t i = 0; i < pucks.size(); ++i)
      if (pucks[i].name == name) return 1 + i;
    for (std::size_t i = 0; i < scenario.bodies.size(); ++i)
      if (scenario.bodies[i].name == name) return 1 + pucks.size() + i;
    throw std::out_of_range(name);
  }
  const WorldLine& line(const std::string& name) const { return world.histories.at(bodyNamed(name)); }
  Event flash(const std::string& name) const {
    for (const Flash& flash : scenario.billiard.flashes)
      if (flash.name == name) return flash.at;
    throw std::out_of_range(name);
  }

  LessonPhase phase;
  std::size_t observer = 0;
  Scenario scenario;
  World world;
  FrameRecord record;
};

/// The eye at the lesson's moment, and its wall.
class LessonEye {
 public:
  LessonEye(const LessonMoment& moment, const Wall& wall) : c_m_s_(moment.c_m_s()), wall_(wall) {
    const LessonPlan& plan = moment.plan();
    const ObserverStart& start = moment.scenario.observer;
    at_ = {moment.moment_s(), start.position_m + Vec3(0, 0, kEyes_m)};
    facing_rad_ = start.facing_rad;
    beta_ = start.beta;
    if (moment.observer < plan.observers.size()) {
      beta_ = plan.observers[moment.observer].beta;
      // Turned with what is seen ahead, unless the lesson is about the present there.
      if (moment.scenario.lesson->views.myNow == 0) {
        const Vec3 ahead = aberrated({std::cos(facing_rad_), std::sin(facing_rad_), 0.0});
        facing_rad_ = std::atan2(ahead.y, ahead.x);
      }
    } else {
      at_.r_m += beta_ * (c_m_s_ * at_.t_s);
    }
  }
  const Event& at() const { return at_; }
  const Vec3& beta() const { return beta_; }
  double c_m_s() const { return c_m_s_; }
  double gamma() const { return 1.0 / std::sqrt(1.0 - glm::dot(beta_, beta_)); }

  /// cos θ' = (cos θ + β)/(1 + β cos θ), with θ between the motion and the way to the light.
  Vec3 aberrated(const Vec3& way) const {
    const double speed = glm::length(beta_);
    const Vec3 from = glm::normalize(way);
    if (speed == 0.0) return from;
    const Vec3 ahead = beta_ / speed;
    const double cosine = glm::dot(from, ahead), sine = glm::length(from - cosine * ahead);
    const Vec3 across = sine > 0.0 ? (from - cosine * ahead) / sine : Vec3(0.0);
    const double seen = (cosine + speed) / (1.0 + speed * cosine);
    return seen * ahead + std::sqrt(std::max(0.0, 1.0 - seen * seen)) * across;
  }

  /// The pixel of the wall in this direction of the observer's frame, from its lower left corner; far outside
  /// if there is none.
  glm::dvec2 pixelIn(const Vec3& direction) const {
    const double away = std::cos(facing_rad_) * direction.x + std::sin(facing_rad_) * direction.y;
    const double right = std::sin(facing_rad_) * direction.x - std::cos(facing_rad_) * direction.y;
    if (away < 1e-6) return glm::dvec2(-1e6);
    const double distance_m = -wall_.lowerLeft_m.z;
    const glm::dvec2 on_m(distance_m * right / away - wall_.lowerLeft_m.x,
                          kEyes_m + distance_m * direction.z / away - wall_.lowerLeft_m.y);
    const glm::dvec2 size_m(wall_.lowerRight_m.x - wall_.lowerLeft_m.x,
                            wall_.upperLeft_m.y - wall_.lowerLeft_m.y);
    return on_m / size_m * glm::dvec2(wall_.pixels);
  }

  /// Where a place that rests on the board is seen.
  glm::dvec2 seen(const Vec3& place_m) const { return pixelIn(aberrated(place_m - at_.r_m)); }

  /// The motion of a body whose light arrives now: t with c (t_eye − t) = |r(t) + d − r_eye|, by bisection.
  Motion emitting(const WorldLine& line, const Vec3& offset_m = Vec3(0.0)) const {
    return bisected(line, [&](const Motion& motion) {
      return c_m_s_ * (at_.t_s - motion.event.t_s) -
             glm::distance(motion.event.r_m + contracted(motion, offset_m), at_.r_m);
    });
  }
  /// Where the point `offset_m` from a body's centre, in its rest frame, is seen, on a leg without bounce.
  glm::dvec2 seen(const WorldLine& line, const Vec3& offset_m) const {
    const Motion motion = emitting(line, offset_m);
    return seen(motion.event.r_m + contracted(motion, offset_m));
  }
  /// Where that point is now: on the board, or for the observer, by c t' = γ (c t − β·r) = 0.
  glm::dvec2 onBoardNow(const WorldLine& line, const Vec3& offset_m) const {
    const Motion motion = line.at(at_.t_s);
    return pixelIn(motion.event.r_m + contracted(motion, offset_m) - at_.r_m);
  }
  glm::dvec2 forMeNow(const WorldLine& line, const Vec3& offset_m) const {
    const Motion motion = bisected(line, [&](const Motion& there) {
      return glm::dot(beta_, there.event.r_m + contracted(there, offset_m) - at_.r_m) -
             c_m_s_ * (there.event.t_s - at_.t_s);
    });
    return pixelIn(inMyFrame({motion.event.t_s, motion.event.r_m + contracted(motion, offset_m)}));
  }
  /// r' = r + (γ − 1) (r·β̂) β̂ − γ β c t.
  Vec3 inMyFrame(const Event& event) const {
    const Vec3 way_m = event.r_m - at_.r_m;
    const double speed = glm::length(beta_);
    if (speed == 0.0) return way_m;
    const Vec3 ahead = beta_ / speed;
    return way_m + (gamma() - 1.0) * glm::dot(way_m, ahead) * ahead -
           gamma() * beta_ * (c_m_s_ * (event.t_s - at_.t_s));
  }
  /// v/c of a motion for this observer: by the relative speed, γ_rel = γ γ_v (1 − β·β_v).
  double speedOf(const Motion& motion) const {
    const double g = std::sqrt(1.0 + glm::dot(motion.u, motion.u));
    const double relative = gamma() * g * (1.0 - glm::dot(beta_, motion.u / g));
    return std::sqrt(std::max(0.0, 1.0 - 1.0 / (relative * relative)));
  }

  static Vec3 contracted(const Motion& motion, const Vec3& offset_m) {
    const double g = std::sqrt(1.0 + glm::dot(motion.u, motion.u)), speed = glm::length(motion.u);
    if (speed == 0.0) return offset_m;
    const Vec3 ahead = motion.u / speed;
    return offset_m + (1.0 / g - 1.0) * glm::dot(offset_m, ahead) * ahead;
  }

 private:
  /// `left` falls along the world line.
  Motion bisected(const WorldLine& line, const std::function<double(const Motion&)>& left) const {
    double early_s = at_.t_s - 40.0, late_s = at_.t_s + 40.0;
    for (int step = 0; step < 80; ++step) {
      const double middle_s = 0.5 * (early_s + late_s);
      (left(line.at(middle_s)) > 0.0 ? early_s : late_s) = middle_s;
    }
    return line.at(0.5 * (early_s + late_s));
  }

  double c_m_s_;
  const Wall& wall_;
  Event at_;
  Vec3 beta_{0.0};
  double facing_rad_ = 0.0;
};

/// The wall of a desk, so many pixels high, as the play rig has it.
inline Rig deskOf(int lines) {
  Rig rig = readRig(CAROM_CONFIG_DIR "/rigs/play.toml");
  rig.walls.at(0).pixels = {lines * 16 / 9, lines};
  return rig;
}

/// Draws lessons as a session does.
class LessonStage {
 public:
  LessonStage(Graphics& graphics, const Rig& rig, const Scenario& scenario)
      : graphics_(graphics),
        scene_(sceneOf(scenario, tessellationFor(rig, true))),
        walls_(graphics, scene_, scenario.billiard.lightSpeed_m_s, rig.walls, {}, false) {
    graphics_.makeCurrent();
    walls_.setRoom(roomGeometryOf(rig));
    walls_.overlays().setLesson(scenario.lesson->words, scenario.lesson->plan);
    walls_.overlays().setOffers(offersOf(scenario));
  }
  Image draw(const LessonMoment& moment) {
    walls_.draw(moment.record, moment.world);
    graphics_.makeCurrent();
    return readBack(*walls_.pictureOf("screen"));
  }

 private:
  Graphics& graphics_;
  Scene scene_;
  DisplayWalls walls_;
};

}  // namespace carom::test
