#include "app/session/live_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "app/operator/lesson.h"
#include "app/operator/visitor_choices.h"
#include "app/operator/wall_commands.h"
#include "app/viewer/headset_tracker.h"
#include "cave/texts/texts.h"
#include "engine/base/limits.h"
#include "engine/spacetime/lorentz.h"

namespace carom {
namespace {

constexpr std::uint64_t kFramesBetweenForgetting = 600;  // ten seconds at 60 Hz
constexpr double kOnset_s = 0.5;
constexpr std::array<const char*, 4> kDriveModes{"as steered", "braking", "home", "tour"};

/// Returns the direction, anticlockwise from +x, in which an observer with this velocity sees what one at rest sees
/// in the direction `facing_rad`: that of the light's displacement back from the eye, in the observer's frame.
double seenFacing_rad(double facing_rad, const Vec3& beta) {
  constexpr double kLight = 1.0;
  const Displacement back{-1.0, {std::cos(facing_rad), std::sin(facing_rad), 0.0}};
  const Vec3 seen = (Lorentz::boost(uFromBeta(beta), kLight).inverse() * back).dr_m;
  return std::atan2(seen.y, seen.x);
}

/// Returns the message about effects and views that commands have just turned on or off, or nothing.
std::string changesBy(std::span<const Command> commands) {
  std::string all;
  const auto say = [&all](texts::Text name, bool on) {
    all += all.empty() ? "" : "    ";
    all += on ? fmt::format(texts::message::kTurnedOn, name) : fmt::format(texts::message::kTurnedOff, name);
  };
  for (const Command& command : commands) {
    const auto* turned = std::get_if<SetSwitch>(&command);
    if (!turned) continue;
    for (std::size_t i = 0; i < kNamedSwitches.size(); ++i) {
      if (kNamedSwitches[i].value == turned->effect)
        say(turned->beside ? texts::keys::kRightEffects[i] : texts::keys::kEffects[i], turned->on);
    }
  }
  return all;
}

/// Returns the trackers of a rig, or the headset, or those people who are moved by mouse and keys.
SharedTrackers trackersOf(const Rig& rig, const LiveStart& start, const MousePeople* people) {
  SharedTrackers trackers = carom::trackersOf(rig, start.sessionStart, start.headset);
  if (people) trackers.take(rig.viewers.front().head.sensor.tracker, people->tracker());
  return trackers;
}

/// Returns where the platform is at board time 0 and how it moves, with this velocity of the lesson: at the
/// lesson's moment it passes the scenario's position, and the view ahead of an observer at rest stays ahead, unless
/// the lesson is about the present there, which no motion turns.
ObserverStart startOf(const Scenario& scenario, std::size_t observer) {
  ObserverStart start = scenario.observer;
  const LessonPlan& plan = scenario.lesson->plan;
  if (observer >= plan.observers.size()) return start;
  start.beta = plan.observers[observer].beta;
  if (scenario.lesson->views.myNow == 0) start.facing_rad = seenFacing_rad(start.facing_rad, start.beta);
  start.position_m -= start.beta * (scenario.billiard.lightSpeed_m_s * plan.interval.moment_s);
  return start;
}

/// Returns the rumble strength in [0, 1]: stroke energy relative to the strongest stroke. 0 unless a gamepad
/// draws the cue.
double rumbleStrength(const HandInput& hand, const HandView& view) {
  return view.pulling && hand.device == texts::kGamepad ? costOf(view.u) / costOf(kStrongestU) : 0.0;
}

}  // namespace

LiveSource::LiveSource(const Rig& rig, const Scenario& scenario, const World& world, const LiveStart& start)
    : rig_(rig),
      scenario_(scenario),
      world_(world),
      headset_(start.headset),
      people_(rig.byMouse ? std::make_unique<MousePeople>(rig) : nullptr),
      viewers_(rig, scenario, trackersOf(rig, start, people_.get()), start.before),
      play_(scenario, rig.axes, !start.before, start.struck),
      hands_(rig.viewers.size(), InputDevices(rig.axes)),
      standing_(standingWalls(rig)),
      roomBoundaries_(rig.viewers.size(), RoomBoundary(standing_)) {
  for (std::size_t viewer = 0; viewer < rig.viewers.size(); ++viewer)
    presses_.emplace_back(seenBy(roomGeometryOf(rig), viewer)).play(scenario);
  if (scenario.lesson && !start.before) beginPass(0);
  if (start.before) {
    play_.captions = captionsBegunAt(start.before->observer.properTime_s);
    play_.match = Match(*start.before);
  }
  if (start.frames) lastFrame_ = start.firstFrame() + *start.frames - 1;
}

void LiveSource::playAnew() {
  fade_s_ = kFade_s;
  viewers_.startIn(rig_, scenario_);
  play_ = Play(scenario_, rig_.axes, true);
  for (InputDevices& hand : hands_) hand.letGo();
  for (WallPresses& presses : presses_) presses.play(scenario_);
  if (scenario_.lesson) beginPass(0);
}

/// Starts the observer, with this velocity of the lesson, where the lesson begins. The game stays: pucks cannot
/// be struck in a lesson, so it is the same in every pass.
void LiveSource::beginPass(std::size_t observer) {
  const LessonPlan& plan = scenario_.lesson->plan;
  viewers_.startAt(rig_, scenario_, startOf(scenario_, observer), plan.interval.from_s);
  play_.drive = PlatformMotion(scenario_, rig_.axes, true);
  play_.passEnded_s.reset();
}

/// Returns the view in a lesson. While it shows, the game passes from the beginning of its interval to the
/// end, slowly, stays there for a moment and begins again. While it explains, its moment is held.
ObserverViews LiveSource::lessonView(const OperatorSettings& settings, const FrameTimes& times) {
  constexpr double kStay_s = 1.5;
  const LessonInterval& interval = scenario_.lesson->plan.interval;
  const bool explains = settings.lesson.phase == LessonPhase::explains;
  const bool isOver = !explains && play_.passEnded_s && times.display_s - *play_.passEnded_s >= kStay_s;
  const bool changes =
      std::exchange(play_.lessonObserver, settings.lessonObserver) != settings.lessonObserver;
  const bool goesTo = explains ? !interval.keepsClocks : play_.explained;
  if (changes || isOver || (goesTo && explains != play_.explained)) {
    beginPass(settings.lessonObserver);
    if (explains && !interval.keepsClocks) viewers_.runTo(interval.moment_s, play_.drive);
    play_.drive.takeNotice();  // of a way that was not shown
  }
  play_.explained = explains;
  if (!explains && !play_.passEnded_s && viewers_.board_s() >= interval.until_s)
    play_.passEnded_s = times.display_s;
  if (explains || play_.passEnded_s) return viewers_.freeView(times, settings.eyeSeparation_m, 0.0);
  const double pace = settings.lightSpeed_m_s / scenario_.billiard.lightSpeed_m_s;
  if (interval.slowness == 1.0)
    return viewers_.at(times, settings.eyeSeparation_m, pace, wish_, play_.drive, steering_);
  return viewers_.slowView(times, settings.eyeSeparation_m, pace, times.step_s / interval.slowness, wish_,
                           play_.drive, steering_);
}

/// Takes over the lesson's state for this frame and notes an answer just given.
void LiveSource::advanceLesson(const LessonState& lesson, Decision& decision) {
  const bool answered = play_.lesson.phase == LessonPhase::asks && lesson.phase != LessonPhase::asks;
  play_.lesson = lesson;
  if (!answered || !scenario_.lesson) return;
  const LessonWords& words = scenario_.lesson->words;
  decision.answers.push_back({words.title, words.question, answerText(words, lesson), play_.answeredBy});
}

/// Fills in the viewers' views: their world lines continue, driven by hand, on the tour or on the way home, or
/// time is frozen.
void LiveSource::see(const OperatorSettings& settings, const FrameTimes& times, bool still,
                     Decision& decision) {
  FrameRecord& record = decision.frame.record;
  record.drive.mode = play_.driven;
  ObserverViews views;
  const ShotView* const shot = play_.replay.view(play_.shots, times.display_s);
  if (shot) {
    views.fill(shot->observer);
    views = viewers_.frozenView(views, times, settings.eyeSeparation_m);
    putInto(record, views);
    record.boardFromRoom = shot->boardFromRoom;
    return;
  }
  if (still && play_.frozen) {
    views = viewers_.frozenView(*play_.frozen, times, settings.eyeSeparation_m);
  } else {
    if (scenario_.lesson) {
      views = lessonView(settings, times);
    } else {
      const double pace = settings.lightSpeed_m_s / scenario_.billiard.lightSpeed_m_s;
      views = viewers_.at(times, settings.eyeSeparation_m, pace, wish_, play_.drive, steering_);
    }
    record.drive = play_.drive.view();
    if (scenario_.lesson && (play_.explained || play_.passEnded_s)) record.drive.thrust = Vec3(0.0);
    play_.frozen = views;
    const DriveMode mode = record.drive.mode;
    if (mode != play_.driven)
      decision.notes.push_back({"drive", kDriveModes[static_cast<std::size_t>(mode)]});
    play_.driven = mode;
  }
  putInto(record, views);
}

void LiveSource::putInto(FrameRecord& record, const ObserverViews& views) const {
  viewers_.putInto(record);
  for (std::size_t i = 0; i < viewers_.size(); ++i) record.viewer(i).observer = views[i];
}

/// Shows a message to everybody in the room and notes it in the decision.
void LiveSource::say(std::string_view words, Decision& decision) {
  if (words.empty()) return;
  for (StatusMessage& message : play_.messages) message.say(words, decision.frame.record.display_s);
  decision.notes.push_back({"notice", std::string(words)});
}

/// Does the same for one viewer alone.
void LiveSource::sayTo(std::size_t viewer, std::string_view words, Decision& decision) {
  if (words.empty()) return;
  play_.messages[viewer].say(words, decision.frame.record.display_s);
  decision.notes.push_back({"notice", std::string(words), viewer});
}

/// Says which effects have just been turned on or off. They change with the next frame: before a picture with other
/// effects is drawn for the first time, shaders are compiled, which may take seconds, and the message explains them.
void LiveSource::tellChanges(std::span<const Command> commands, Decision& decision) {
  FrameRecord& record = decision.frame.record;
  const std::string changes = changesBy(commands);
  if (!changes.empty() && play_.effects) {
    std::tie(record.switches, record.views.beside) = *play_.effects;
    pendingMessage_ = changes;
  } else {
    play_.effects = {record.switches, record.views.beside};
  }
}

/// Counts a carom when the one who struck sees it, and says so; tells who saw a hit first.
void LiveSource::count(Decision& decision) {
  FrameRecord& record = decision.frame.record;
  const double c_m_s = scenario_.billiard.lightSpeed_m_s;
  play_.shots.see({record.viewer(play_.striker).observer, record.boardFromRoom, record.display_s});
  if (const auto seen = play_.hit.look(world_.events, record); seen && seen->size() > 1)
    tellWhoSawFirst(*seen, decision);
  for (std::size_t viewer = 0; viewer < viewers_.size(); ++viewer) {
    const Event& eye = record.viewer(viewer).observer.middle.observation;
    const auto cushions = play_.match.look(viewer, world_.events, eye, c_m_s);
    if (!cushions) continue;
    if (viewer == play_.striker) play_.shots.carom(*cushions, record.display_s);
    if (viewers_.size() == 1) return say(fmt::format(texts::message::kCarom, *cushions), decision);
    for (std::size_t other = 0; other < viewers_.size(); ++other) {
      const std::string& name = rig_.viewers[viewer].name;
      sayTo(other,
            other == viewer ? fmt::format(texts::message::kCarom, *cushions)
                            : fmt::format(texts::message::kCaromOf, name, *cushions),
            decision);
    }
  }
}

/// Tells everybody in the room who saw a hit first, and why the others saw it later: in the room's frame its light
/// took a longer way to them.
void LiveSource::tellWhoSawFirst(std::span<const HitSeen::Seen> seen, Decision& decision) {
  for (std::size_t reader = 0; reader < viewers_.size(); ++reader) {
    const auto nameOf = [&](std::size_t viewer) {
      return viewer == reader ? std::string(texts::legend::kMe) : rig_.viewers[viewer].name;
    };
    const std::size_t first = seen.front().viewer;
    std::string words = first == reader ? std::string(texts::message::kYouSawHitFirst)
                                        : fmt::format(texts::message::kSawHitFirst, nameOf(first));
    for (const HitSeen::Seen& later : seen.subspan(1)) {
      const double later_s = later.room_s - seen.front().room_s;
      words += fmt::format(texts::message::kSawHitLater, nameOf(later.viewer), later_s,
                           later_s * scenario_.billiard.lightSpeed_m_s);
    }
    sayTo(reader, words, decision);
  }
}

/// Says whose best shot is shown again; all see it as the one who struck saw it.
void LiveSource::tellWhoseShot(bool isEnd, Decision& decision) {
  const std::size_t cushions = play_.shots.bestCushions();
  const std::string& striker = rig_.viewers[play_.striker].name;
  for (std::size_t reader = 0; reader < viewers_.size(); ++reader) {
    const bool isOwn = reader == play_.striker;
    const std::string words = isOwn ? fmt::format(texts::message::kBestShot, cushions)
                                    : fmt::format(texts::message::kBestShotOf, striker, cushions);
    sayTo(reader, isEnd ? fmt::format(texts::message::kLastShot, words) : words + texts::message::kBackToGame,
          decision);
  }
}

/// Begins to show the best shot again, or ends it; anything that the person does ends it as well.
void LiveSource::showAgain(const FrameInput& input, double now_s, Decision& decision) {
  const ShowBestShot* const asked = lastOf<ShowBestShot>(input.commands);
  const bool isAsked = asked && (!asked->isEnd || play_.shots.hasBest());
  if (play_.replay.look(play_.shots, now_s, (isAsked && !asked->isEnd) || asksForAnything(wish_))) return;
  if (isAsked && play_.shots.hasBest()) {
    play_.replay.begin(now_s, asked->isEnd);
    tellWhoseShot(asked->isEnd, decision);
  } else if (isAsked) {
    say(texts::message::kNoCarom, decision);
  }
}

/// Returns what the devices ask of the drive. The thrust sets in over kOnset_s; it ends at once.
DriveWish LiveSource::eased(double step_s) {
  DriveWish wish = hands_[steering_].drive();
  onset_ = wish.steer == Vec3(0.0) ? 0.0 : std::min(1.0, onset_ + step_s / kOnset_s);
  wish.steer *= onset_;
  return wish;
}

/// Says once why steering does nothing.
void LiveSource::sayWhyStill(const OperatorSettings& settings, Decision& decision) {
  if (!asksForAnything(hands_[steering_].drive())) {
    play_.saidStill = false;
  } else if (!std::exchange(play_.saidStill, true)) {
    say(settings.views.frozen ? texts::message::kFrozen : texts::message::kAsks, decision);
  }
}

/// Does what a button on the front wall is for: returns its command, or has the devices ask for the way home.
std::optional<Command> LiveSource::press(std::size_t viewer, const WallAction& action,
                                         const OperatorSettings& settings, Decision& decision) {
  hands_[viewer].letGo();
  if (action.kind == WallAction::Kind::home) hands_[viewer].goHome();
  const std::optional<Command> command = commandOf(action, settings);
  decision.isHandled = true;
  return command;
}

/// Gives the desk's input to the viewer over whose walls the mouse is, and settles who steers: the first who wishes it.
void LiveSource::begin(const DeskInput& desk, bool asks) {
  padStep_ = desk.padStep;
  if (desk.mouse) atDesk_ = std::min(desk.mouse->viewer, hands_.size() - 1);
  DeskInput own = desk;
  own.mouseAims = !people_;
  for (std::size_t viewer = 0; viewer < hands_.size(); ++viewer)
    hands_[viewer].begin(viewer == atDesk_ ? own : DeskInput{}, asks);
  const auto steers = std::find_if(hands_.begin(), hands_.end(),
                                   [](const InputDevices& hand) { return asksForAnything(hand.drive()); });
  if (steers != hands_.end()) steering_ = static_cast<std::size_t>(steers - hands_.begin());
}

/// Processes a viewer's interaction with the game in this frame. The record's first viewer is the one whose hand it is.
/// A press on one of the buttons of the front wall is neither a stroke nor an answer.
void LiveSource::strike(std::size_t viewer, bool still, const FrameTimes& times,
                        const OperatorSettings& settings, Decision& decision) {
  FrameRecord& record = decision.frame.record;
  InputDevices& devices = hands_[viewer];
  HandInput hand =
      devices.cue(viewers_.hand(viewer), record.observer, viewers_.head(viewer).pose, times.display_s);
  if (viewer == atDesk_) presses_[viewer].aimPad(padStep_, hand);
  const std::optional<PointedButton> pointed = presses_[viewer].at(hand);
  std::optional<Command> command = devices.lessonCommand();
  if (pointed && hand.pressed) {
    command = press(viewer, pointed->action, settings, decision);
    hand.held = false;
  }
  const bool misses = hand.pressed && !command && play_.lesson.phase == LessonPhase::asks;
  if (misses) sayTo(viewer, texts::message::kAsks, decision);
  if (command) {
    decision.handCommands.push_back({*command, viewer});
    play_.answeredBy = viewer;
    decision.isHandled = true;
  }
  const CueInteraction::Outcome outcome = play_.cues[viewer].step(hand, still, play_.game, record);
  const bool isNew = scenario_.choices && scenario_.tour.empty() && record.score.strokes == 0;
  if (isNew && !still) play_.cues[viewer].offer(0, play_.game, record);
  if (pointed && !record.hand.pulling) {
    record.hand.to_m = pointed->onWall_m;
    record.hand.target = 0;
  }
  if (outcome.stroke) {
    decision.strokes.push_back({*outcome.stroke, viewer});
    play_.match.struck(viewer, viewers_.size(), outcome.stroke->puck, outcome.arrives_s);
    play_.hit.struck(outcome.stroke->puck, outcome.arrives_s);
    play_.striker = viewer;
    play_.shots.struck();
  }
  if (viewer == atDesk_) {
    rumble_.set(rumbleStrength(hand, record.hand));
    if (outcome.stroke && hand.device == texts::kGamepad) rumble_.pulse();
  }
  sayTo(viewer, outcome.said, decision);
}

/// Discards what no viewer will see any more, not even in the best shot.
void LiveSource::forget(Decision& decision) {
  const FrameRecord& record = decision.frame.record;
  std::array<ObserverView, kMostViewers + 1> observers;
  for (std::size_t viewer = 0; viewer < record.viewers; ++viewer)
    observers[viewer] = record.viewer(viewer).observer;
  observers[record.viewers] = play_.shots.earliest(record.viewer(play_.striker).observer, record.display_s);
  play_.game.forget(world_.histories, std::span(observers).first(record.viewers + 1), decision.frame);
}

void LiveSource::next(const FrameTimes& given, const FrameInput& input, OperatorSettings& settings,
                      Decision& decision) {
  FrameTimes times = given;
  if (std::exchange(play_.isNew, false)) times.step_s = 0.0;
  FrameState& frame = decision.frame;
  for (std::size_t viewer = 0; viewer < viewers_.size(); ++viewer)
    presses_[viewer].follow(viewer == 0 ? frame.record : seenBy(frame.record, viewer));
  FrameRecord& record = frame.record = {};
  record.number = times.number;
  record.display_s = times.display_s;
  record.lightSpeed_m_s = settings.lightSpeed_m_s;
  carom::putInto(record, settings);
  tellChanges(input.commands, decision);
  begin(input.desk, offersChoices(settings));
  if (people_) people_->move(input.desk, atDesk_, times.begin_s);
  wish_ = eased(times.step_s);
  decision.isHandled = asksForAnything(wish_);
  advanceLesson(record.lesson = settings.lesson, decision);
  if (lastOf<StartTour>(input.commands)) play_.drive.setOut();
  // Until the question is answered time is frozen, so that nothing of the answer can be seen.
  const bool still = settings.views.frozen || play_.lesson.phase == LessonPhase::asks;
  showAgain(input, times.display_s, decision);
  if (headset_) record.headset = viewers_.putOn(*headset_);
  see(settings, times, still, decision);
  play_.match.putInto(record);
  const bool isShot = play_.replay.view(play_.shots, times.display_s) != nullptr;
  decision.showsShot = play_.replay.isOn();
  for (std::size_t viewer = 0; viewer < viewers_.size(); ++viewer) {
    std::swap(record.viewer(0), record.viewer(viewer));
    // A lesson plays the same game again and again.
    strike(viewer, still || isShot || scenario_.lesson, times, settings, decision);
    std::swap(record.viewer(0), record.viewer(viewer));
  }
  if (!still && !isShot) count(decision);
  play_.match.putInto(record);
  if (still) sayWhyStill(settings, decision);
  for (const Command& command : input.commands) {
    if (const auto* tells = std::get_if<TellPerson>(&command)) say(tells->words, decision);
  }
  sayTo(steering_, play_.drive.takeNotice().words(), decision);
  for (std::size_t viewer = 0; viewer < viewers_.size(); ++viewer) {
    if (const Wall* left = roomBoundaries_[viewer].look(viewers_.head(viewer).pose.position_m))
      sayTo(viewer, fmt::format(texts::message::kLeftRoom, left->name), decision);
  }
  say(std::exchange(pendingMessage_, {}), decision);
  for (std::size_t viewer = 0; viewer < viewers_.size(); ++viewer)
    record.viewer(viewer).notice = play_.messages[viewer].at(times.display_s);
  showCaption(decision);
  for (std::size_t viewer = 0; settings.views.myNow && viewer < viewers_.size(); ++viewer)
    play_.game.playToNowOf(record.viewer(viewer).observer);
  play_.game.advance(latestObservation_s(record), frame);
  if (times.number % kFramesBetweenForgetting == 0 && !scenario_.lesson) forget(decision);
  record.fade = fade_s_ / kFade_s;
  fade_s_ = std::max(0.0, fade_s_ - given.step_s);
  record.last = times.isLast || (lastFrame_ && times.number >= *lastFrame_);
  for (std::size_t i = 0; i < viewers_.size(); ++i) decision.heads[i] = viewers_.head(i);
  viewers_.samplesInto(decision.samples);
  decision.alarms = viewers_.takeAlarms();
  decision.timing.sampleAge_s = sampleAge_s(times.begin_s);
}

/// Returns how many of the scenario's captions have begun by this time of the observer's own clock.
std::size_t LiveSource::captionsBegunAt(double own_s) const {
  const auto begun = std::partition_point(scenario_.captions.begin(), scenario_.captions.end(),
                                          [&](const Caption& caption) { return caption.from_s <= own_s; });
  return static_cast<std::size_t>(begun - scenario_.captions.begin());
}

/// Shows everybody the scenario's caption for the first observer's proper time, unless a message is shown. When a caption
/// begins, commands turn on its time views and turn off those of the caption before it.
void LiveSource::showCaption(Decision& decision) {
  FrameRecord& record = decision.frame.record;
  const double own_s = record.observer.properTime_s;
  const std::vector<Caption>& captions = scenario_.captions;
  for (const std::size_t begun = captionsBegunAt(own_s); play_.captions < begun; ++play_.captions) {
    const Caption& caption = captions[play_.captions];
    const TimeViews before = play_.captions > 0 ? captions[play_.captions - 1].views : TimeViews();
    for (const NamedView& view : kNamedViews) {
      const bool on = caption.views.*view.value != 0;
      if (on || before.*view.value != 0) decision.commands.push_back(SetView{view.value, on});
    }
    decision.notes.push_back({"notice", caption.text});
  }
  if (play_.captions == 0) return;
  const Caption& latest = captions[play_.captions - 1];
  if (own_s >= latest.from_s + latest.for_s) return;
  for (std::size_t viewer = 0; viewer < viewers_.size(); ++viewer) {
    const std::string& text = rig_.viewers[viewer].hand ? latest.handText : latest.text;
    if (record.viewer(viewer).notice.words().empty()) record.viewer(viewer).notice = Notice(text);
  }
}

double LiveSource::sampleAge_s(double begin_s) {
  const SensorChoice& head = rig_.viewers.front().head.sensor;
  for (const TrackerSample& sample : viewers_.samples()) {
    if (sample.sensor == head.sensor) newestSample_s_ = sample.time_s - rig_.trackers[head.tracker].latency_s;
  }
  return begin_s - newestSample_s_;
}

SourceStatus LiveSource::status() const {
  SourceStatus status;
  if (lastFrame_) status.end = *lastFrame_ + 1;
  status.trackers = viewers_.trackers();
  return status;
}

}  // namespace carom
