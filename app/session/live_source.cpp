#include "app/session/live_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "app/operator/lesson.h"
#include "engine/base/limits.h"

namespace carom {
namespace {

constexpr std::uint64_t kFramesBetweenForgetting = 600;  // ten seconds at 60 Hz
constexpr std::array<const char*, 4> kDriveModes{"as steered", "braking", "home", "tour"};

/// What a stroke costs, of the strongest one's, as the gamepad that draws it back makes felt.
double felt(const HandInput& hand, const HandView& view) {
  return view.pulling && hand.device == "gamepad" ? costOf(view.u) / costOf(kStrongestU) : 0.0;
}

std::uint64_t firstFrame(const LiveStart& start) { return start.before ? start.before->number + 1 : 0; }

}  // namespace

LiveSource::LiveSource(const Rig& rig, const Scenario& scenario, const World& world, LiveStart start)
    : rig_(rig),
      scenario_(scenario),
      world_(world),
      clock_(std::move(start.clock)),
      pacer_(*clock_, rig.display_hz, rig.displayLatency_s, start.swapsWait, firstFrame(start)),
      viewer_(rig, scenario, start.sessionStart, start.before),
      platformMotion_(scenario, rig.axes, !start.before),
      game_(scenario, start.struck),
      hands_(rig.axes),
      cueInteraction_(scenario),
      roomBoundary_(rig.walls) {
  if (start.frames) lastFrame_ = firstFrame(start) + *start.frames - 1;
}

void LiveSource::keep(std::unique_ptr<Journal> journal) {
  if (journal_) journal_->close();
  onLeaving_.reset();
  journal_ = std::move(journal);
  if (journal_) onLeaving_.emplace([this] { journal_->close(); });
}

void LiveSource::playAnew(std::unique_ptr<Journal> journal) {
  keep(std::move(journal));
  viewer_.startIn(rig_, scenario_);
  platformMotion_ = PlatformMotion(scenario_, rig_.axes, true);
  driven_ = DriveMode::free;
  game_ = Game(scenario_);
  cueInteraction_ = CueInteraction(scenario_);
  struck_.reset();
  frozen_.reset();
  lesson_ = {};
  tours_.reset();
  hands_.letGo();
  desk_ = {};
  spoken_ = {};
  begins_ = true;
}

/// Where the lesson is with this frame: buttons of hands count as keys do.
LessonState LiveSource::lessonAt(const Controls& controls, std::uint64_t number) {
  const LessonState lesson =
      advance(controls.lesson, controls.lessonAnswers, hands_.answer(), hands_.onwards());
  if (!journal_ || !scenario_.lesson) return lesson;
  if (lesson != controls.lesson) {
    Controls now = controls;
    now.lesson = lesson;
    for (const ControlChange& change : changesOf(controls, now))
      journal_->addInput(number, change.what, change.value);
  }
  if (lesson_.phase == LessonPhase::asks && lesson.phase != LessonPhase::asks) {
    const LessonWords& words = scenario_.lesson->words;
    journal_->addAnswer(number, words.title, words.question, answerText(words, lesson));
  }
  return lesson;
}

/// Lives on, driven as hands, the tour or the way home have it.
ObserverView LiveSource::lived(const Controls& controls, const FrameTimes& times, double pace) {
  const ObserverView view =
      viewer_.at(times, controls.eyeSeparation_m, pace, hands_.drive(), platformMotion_);
  const DriveMode mode = platformMotion_.view().mode;
  if (journal_ && mode != driven_)
    journal_->addInput(times.number, "drive", kDriveModes[static_cast<std::size_t>(mode)]);
  driven_ = mode;
  return view;
}

/// To the person in the room, whatever it is that has to be told.
void LiveSource::say(std::string_view words, const FrameTimes& times) {
  if (words.empty()) return;
  spoken_.say(words, times.display_s);
  if (journal_) journal_->addInput(times.number, "notice", std::string(words));
}

/// What the hand does to the game in this frame.
void LiveSource::play(bool still, const FrameTimes& times, FrameRecord& record) {
  const HandInput hand = hands_.cue(viewer_.hand(), record.observer, viewer_.head().pose, times.display_s);
  const CueInteraction::Outcome outcome = cueInteraction_.step(hand, still, game_, record);
  struck_ = outcome.stroke;
  rumble_.set(felt(hand, record.hand));
  if (struck_ && hand.device == "gamepad") rumble_.pulse();
  say(outcome.said, times);
}

void LiveSource::next(const Controls& controls, FrameState& state) {
  FrameTimes times = pacer_.next();
  if (std::exchange(begins_, false)) times.step_s = 0.0;  // nobody lives while a game is loaded
  const auto begun = std::chrono::steady_clock::now();
  FrameRecord& record = state.record = {};
  const double pace = controls.lightSpeed_m_s / scenario_.billiard.lightSpeed_m_s;
  hands_.begin(desk_, lesson_.phase == LessonPhase::asks);
  record.lesson = lesson_ = lessonAt(controls, times.number);
  // Before the question is answered, nothing of the answer is to be seen: time stands still.
  const bool still = controls.views.frozen || lesson_.phase == LessonPhase::asks;
  if (tours_.value_or(controls.tours) != controls.tours) platformMotion_.setOut();
  tours_ = controls.tours;
  record.drive.mode = driven_;
  if (still && frozen_) {
    record.observer = viewer_.frozenView(*frozen_, times, controls.eyeSeparation_m);
  } else {
    record.observer = lived(controls, times, pace);
    record.drive = platformMotion_.view();
    frozen_ = record.observer;
  }
  record.boardFromRoom = viewer_.boardFromRoom();
  record.lightSpeed_m_s = controls.lightSpeed_m_s;
  record.switches = controls.switches;
  play(still, times, record);
  say(platformMotion_.news().words(), times);
  say(roomBoundary_.look(viewer_.head().pose.position_m), times);
  say(std::exchange(told_, {}), times);
  record.notice = spoken_.at(times.display_s);
  if (controls.views.myNow) game_.playToNowOf(record.observer);
  game_.advance(latestObservation_s(record.observer), state);
  if (times.number % kFramesBetweenForgetting == 0) game_.forget(world_.histories, record.observer, state);
  record.number = times.number;
  record.display_s = times.display_s;
  record.last = lastFrame_ && times.number >= *lastFrame_;
  record.controls = controls.walls;
  record.views = controls.views;
  record.tracked = viewer_.tracked();
  noteDeciding(times.begin_s, begun);
}

void LiveSource::noteDeciding(double begin_s, std::chrono::steady_clock::time_point begun) {
  const SensorChoice& head = rig_.head.sensor;
  for (const TrackerSample& sample : viewer_.samples()) {
    if (sample.sensor == head.sensor) newestSample_s_ = sample.time_s - rig_.trackers[head.tracker].latency_s;
  }
  deciding_.sampleAge_s = begin_s - newestSample_s_;
  deciding_.took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

std::optional<std::uint64_t> LiveSource::end() const {
  return lastFrame_ ? std::optional(*lastFrame_ + 1) : std::nullopt;
}

void LiveSource::drawn() { pacer_.drawn(); }

void LiveSource::shown(const FrameState& state) {
  pacer_.swapped();
  if (!journal_) return;
  const auto strokes = struck_ ? std::span<const Stroke>(&*struck_, 1) : std::span<const Stroke>();
  journal_->add(state, viewer_.head(), viewer_.samples(), strokes);
}

void LiveSource::changed(std::uint64_t number, const ControlChange& change) {
  if (journal_) journal_->addInput(number + 1, change.what, change.value);
}

void LiveSource::measured(std::span<const LatencyRow> rows) {
  if (journal_) journal_->add(rows);
}

}  // namespace carom
