#include "app/live/lesson_run.h"

#include <cmath>
#include <utility>

#include "app/operator/lesson.h"
#include "engine/spacetime/lorentz.h"

namespace carom {
namespace {

/// Returns the direction, anticlockwise from +x, in which an observer with this velocity sees what one at
/// rest sees in the direction `facing_rad`: that of the light's displacement back from the eye, in the
/// observer's frame.
double seenFacing_rad(double facing_rad, const Vec3& beta) {
  constexpr double kLight = 1.0;
  const Displacement back{-1.0, {std::cos(facing_rad), std::sin(facing_rad), 0.0}};
  const Vec3 seen = (Lorentz::boost(uFromBeta(beta), kLight).inverse() * back).dr_m;
  return std::atan2(seen.y, seen.x);
}

/// Returns where the platform is at board time 0 and how it moves, with this velocity of the lesson: at the
/// lesson's moment it passes the scenario's position, and the view ahead of an observer at rest stays ahead,
/// unless the lesson is about the present there, which no motion turns.
ObserverStart startOf(const Scenario& scenario, std::size_t observer) {
  ObserverStart start = scenario.observer;
  const LessonPlan& plan = scenario.lesson->plan;
  if (observer >= plan.observers.size()) return start;
  start.beta = plan.observers[observer].beta;
  if (scenario.lesson->views.myNow == 0) start.facing_rad = seenFacing_rad(start.facing_rad, start.beta);
  start.position_m -= start.beta * (scenario.billiard.lightSpeed_m_s * plan.interval.moment_s);
  return start;
}

}  // namespace

void LessonRun::begin(RoomMotion& room) {
  if (scenario_->lesson) beginPass(0, room);
}

/// Starts the observer, with this velocity of the lesson, where the lesson begins. The game stays: pucks
/// cannot be struck in a lesson, so it is the same in every pass.
void LessonRun::beginPass(std::size_t observer, RoomMotion& room) {
  room.startAt(startOf(*scenario_, observer), scenario_->lesson->plan.interval.from_s);
  passEnded_s_.reset();
}

void LessonRun::take(const LessonState& state, std::size_t answeredBy, Decision& decision) {
  const bool answered = asks() && state.phase != LessonPhase::asks;
  state_ = state;
  if (!answered || !scenario_->lesson) return;
  const LessonWords& words = scenario_->lesson->words;
  decision.answers.push_back({words.title, words.question, answerText(words, state), answeredBy});
}

ObserverViews LessonRun::move(const OperatorSettings& settings, const RoomStep& step, RoomMotion& room) {
  constexpr double kStay_s = 1.5;
  const LessonInterval& interval = scenario_->lesson->plan.interval;
  const double now_s = step.times.display_s;
  const bool explains = settings.lesson.phase == LessonPhase::explains;
  const bool isOver = !explains && passEnded_s_ && now_s - *passEnded_s_ >= kStay_s;
  const bool changes = std::exchange(observer_, settings.lessonObserver) != settings.lessonObserver;
  const bool goesTo = explains ? !interval.keepsClocks : explained_;
  if (changes || isOver || (goesTo && explains != explained_)) {
    beginPass(settings.lessonObserver, room);
    if (explains && !interval.keepsClocks) room.runTo(interval.moment_s);
    room.takeNotice();  // of a way that was not shown
  }
  explained_ = explains;
  if (!explains && !passEnded_s_ && room.viewers().board_s() >= interval.until_s) passEnded_s_ = now_s;
  if (isHeld()) return room.stand(step);
  return interval.slowness == 1.0 ? room.advance(step)
                                  : room.advanceSlowly(step, step.times.step_s / interval.slowness);
}

}  // namespace carom
