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

/// Returns the rumble strength in [0, 1]: stroke energy relative to the strongest stroke. 0 unless a gamepad
/// draws the cue.
double rumbleStrength(const HandInput& hand, const HandView& view) {
  return view.pulling && hand.device == "gamepad" ? costOf(view.u) / costOf(kStrongestU) : 0.0;
}

}  // namespace

LiveSource::LiveSource(const Rig& rig, const Scenario& scenario, const World& world, const LiveStart& start)
    : rig_(rig),
      scenario_(scenario),
      world_(world),
      viewer_(rig, scenario, start.sessionStart, start.before),
      play_(scenario, rig.axes, !start.before, start.struck),
      hands_(rig.axes),
      roomBoundary_(rig.walls) {
  if (start.frames) lastFrame_ = start.firstFrame() + *start.frames - 1;
}

void LiveSource::playAnew() {
  viewer_.startIn(rig_, scenario_);
  play_ = Play(scenario_, rig_.axes, true);
  hands_.letGo();
}

/// Takes over the lesson's state for this frame and notes an answer just given.
void LiveSource::advanceLesson(const LessonState& lesson, Decision& decision) {
  const bool answered = play_.lesson.phase == LessonPhase::asks && lesson.phase != LessonPhase::asks;
  play_.lesson = lesson;
  if (!answered || !scenario_.lesson) return;
  const LessonWords& words = scenario_.lesson->words;
  decision.answers.push_back({words.title, words.question, answerText(words, lesson)});
}

/// Fills in the viewer's view: the world line continues, driven by hand, on the tour or on the way home, or
/// time is frozen.
void LiveSource::see(const OperatorSettings& settings, const FrameTimes& times, bool still,
                     Decision& decision) {
  FrameRecord& record = decision.frame.record;
  record.drive.mode = play_.driven;
  if (still && play_.frozen) {
    record.observer = viewer_.frozenView(*play_.frozen, times, settings.eyeSeparation_m);
  } else {
    const double pace = settings.lightSpeed_m_s / scenario_.billiard.lightSpeed_m_s;
    record.observer = viewer_.at(times, settings.eyeSeparation_m, pace, hands_.drive(), play_.drive);
    record.drive = play_.drive.view();
    play_.frozen = record.observer;
    const DriveMode mode = record.drive.mode;
    if (mode != play_.driven)
      decision.notes.push_back({"drive", kDriveModes[static_cast<std::size_t>(mode)]});
    play_.driven = mode;
  }
  record.boardFromRoom = viewer_.boardFromRoom();
}

/// Shows a message in the room and notes it in the decision.
void LiveSource::say(std::string_view words, Decision& decision) {
  if (words.empty()) return;
  play_.message.say(words, decision.frame.record.display_s);
  decision.notes.push_back({"notice", std::string(words)});
}

/// Processes the hand's interaction with the game in this frame.
void LiveSource::strike(bool still, const FrameTimes& times, Decision& decision) {
  FrameRecord& record = decision.frame.record;
  const HandInput hand = hands_.cue(viewer_.hand(), record.observer, viewer_.head().pose, times.display_s);
  if (const auto command = hands_.lessonCommand()) decision.commands.push_back(*command);
  const CueInteraction::Outcome outcome = play_.hands.step(hand, still, play_.game, record);
  if (outcome.stroke) decision.strokes.push_back(*outcome.stroke);
  rumble_.set(rumbleStrength(hand, record.hand));
  if (outcome.stroke && hand.device == "gamepad") rumble_.pulse();
  say(outcome.said, decision);
}

void LiveSource::next(const FrameTimes& given, const FrameInput& input, OperatorSettings& settings,
                      Decision& decision) {
  FrameTimes times = given;
  if (std::exchange(play_.isNew, false)) times.step_s = 0.0;
  FrameState& frame = decision.frame;
  FrameRecord& record = frame.record = {};
  record.number = times.number;
  record.display_s = times.display_s;
  record.lightSpeed_m_s = settings.lightSpeed_m_s;
  putInto(record, settings);
  hands_.begin(input.desk, play_.lesson.phase == LessonPhase::asks);
  advanceLesson(record.lesson = settings.lesson, decision);
  if (lastOf<StartTour>(input.commands)) play_.drive.setOut();
  // Until the question is answered time is frozen, so that nothing of the answer can be seen.
  const bool still = settings.views.frozen || play_.lesson.phase == LessonPhase::asks;
  see(settings, times, still, decision);
  strike(still, times, decision);
  say(play_.drive.news().words(), decision);
  say(roomBoundary_.look(viewer_.head().pose.position_m), decision);
  say(std::exchange(pendingMessage_, {}), decision);
  record.notice = play_.message.at(times.display_s);
  showCaption(decision);
  if (settings.views.myNow) play_.game.playToNowOf(record.observer);
  play_.game.advance(latestObservation_s(record.observer), frame);
  if (times.number % kFramesBetweenForgetting == 0)
    play_.game.forget(world_.histories, record.observer, frame);
  record.last = lastFrame_ && times.number >= *lastFrame_;
  record.tracked = viewer_.tracked();
  decision.head = viewer_.head();
  decision.samples = viewer_.samples();
  decision.alarms = viewer_.takeAlarms();
  decision.timing.sampleAge_s = sampleAge_s(times.begin_s);
}

/// Shows the scenario's caption for the observer's proper time, unless a message is shown. When a caption
/// begins, commands turn on its time views and turn off the others.
void LiveSource::showCaption(Decision& decision) {
  FrameRecord& record = decision.frame.record;
  const double own_s = record.observer.properTime_s;
  const std::vector<Caption>& captions = scenario_.captions;
  while (play_.captions < captions.size() && captions[play_.captions].from_s <= own_s) {
    const Caption& caption = captions[play_.captions++];
    for (const NamedView& view : kNamedViews)
      decision.commands.push_back(SetView{view.value, caption.views.*view.value != 0});
    decision.notes.push_back({"notice", caption.text});
  }
  if (play_.captions == 0 || !record.notice.words().empty()) return;
  const Caption& latest = captions[play_.captions - 1];
  if (own_s < latest.from_s + latest.for_s) record.notice = Notice(latest.text);
}

double LiveSource::sampleAge_s(double begin_s) {
  const SensorChoice& head = rig_.head.sensor;
  for (const TrackerSample& sample : viewer_.samples()) {
    if (sample.sensor == head.sensor) newestSample_s_ = sample.time_s - rig_.trackers[head.tracker].latency_s;
  }
  return begin_s - newestSample_s_;
}

SourceStatus LiveSource::status() const {
  SourceStatus status;
  if (lastFrame_) status.end = *lastFrame_ + 1;
  status.trackers = viewer_.trackers();
  return status;
}

}  // namespace carom
