#include "app/live/live_source.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/operator/lesson.h"
#include "cave/scene/scene.h"
#include "cave/texts/texts.h"
#include "engine/sculpture/sculpture_reach.h"

namespace carom {
namespace {

constexpr std::uint64_t kFramesBetweenForgetting = 600;  // ten seconds at 60 Hz
constexpr std::array<const char*, 4> kDriveModes{"as steered", "braking", "home", "tour"};

}  // namespace

LiveSource::LiveSource(const Rig& rig, const Scenario& scenario, const World& world, const LiveStart& start)
    : rig_(rig),
      scenario_(scenario),
      world_(world),
      inputs_(rig, start.sessionStart),
      room_(rig, scenario, inputs_.trackers(rig, start.sessionStart), start.before),
      lesson_(scenario),
      game_(scenario, start.struck),
      players_(rig, scenario, start.before),
      announcements_(rig, scenario, start.before),
      link_(start.link),
      isNew_(!start.before) {
  inputs_.play(scenario);
  if (!start.before) lesson_.begin(room_);
  if (start.frames) lastFrame_ = start.firstFrame() + *start.frames - 1;
}

void LiveSource::playAnew() {
  fade_s_ = kFade_s;
  inputs_.play(scenario_);
  room_.start();
  lesson_ = LessonRun(scenario_);
  game_ = link_ ? Game(scenario_, link_->strokesBefore()) : Game(scenario_);
  players_ = Players(rig_, scenario_, {});
  announcements_.play();
  frozen_.reset();
  previous_.drive = DriveMode::free;
  isNew_ = true;
  lesson_.begin(room_);
}

void LiveSource::next(const FrameTimes& given, const FrameInput& input, OperatorSettings& settings,
                      Decision& decision) {
  hear(input.commands, decision);
  const FrameTimes times = begin(given, settings, decision.frame.record);
  const DriveWish wish = steer(input, settings, times, decision);
  lesson_.take(settings.lesson, players_.answeredBy(), decision);
  const ShotView* const shot = shotAt(times, input.commands, decision);
  if (lastOf<StartTour>(input.commands)) room_.setOut();
  const bool stands = settings.views.frozen || lesson_.asks();
  const double pace = settings.lightSpeed_m_s / scenario_.billiard.lightSpeed_m_s;
  const bool still = move({times, settings.eyeSeparation_m, pace, wish, inputs_.steering()}, settings, stands,
                          shot, decision);
  const bool timePasses = !still && !shot;
  act(settings, timePasses, decision);
  if (link_)
    link_->tellWaiting(still && !stands, times.step_s, world_, decision.frame.record, announcements_);
  tell(input.commands, settings, stands, decision);
  playGame(settings, decision.frame);
  if (link_) link_->tell(room_, game_, settings, !timePasses, decision);
  finish(given, decision);
}

/// Takes over the last frame's record, and what another room says.
void LiveSource::hear(std::span<const Command> commands, Decision& decision) {
  inputs_.follow(decision.frame.record);
  if (!link_) return;
  if (const auto* linked = lastOf<SetLinked>(commands)) link_->stay(linked->on);
  link_->hear(game_, announcements_, decision);
}

/// Takes what the players' hands and the desk ask for, and returns how the platform is to be driven.
DriveWish LiveSource::steer(const FrameInput& input, const OperatorSettings& settings,
                            const FrameTimes& times, Decision& decision) {
  announcements_.tellEffects(input.commands, decision);
  const DriveWish wish = inputs_.take(input.desk, offersChoices(settings), times);
  decision.isHandled = asksForAnything(wish);
  return wish;
}

/// Begins the frame's record, and returns its times: none passes for the viewer in a game's first frame.
FrameTimes LiveSource::begin(const FrameTimes& given, const OperatorSettings& settings, FrameRecord& record) {
  record = {};
  record.number = given.number;
  record.display_s = given.display_s;
  record.lightSpeed_m_s = settings.lightSpeed_m_s;
  record.lesson = settings.lesson;
  putInto(record, settings);
  FrameTimes times = given;
  if (std::exchange(isNew_, false)) times.step_s = 0.0;
  return times;
}

/// Returns the view of the best shot while it is shown again, which a game that another room plays never is:
/// then says so if it is asked for.
const ShotView* LiveSource::shotAt(const FrameTimes& times, std::span<const Command> commands,
                                   Decision& decision) {
  if (!link_ || !link_->isShared())
    players_.showBestShot(commands, decision.isHandled, announcements_, decision);
  else if (lastOf<ShowBestShot>(commands))
    announcements_.say(texts::message::kLinkNoShot, decision);
  return players_.shot(times.display_s);
}

/// Moves the room and fills in the viewers' views: their world lines continue, driven by hand, on the tour or
/// on the way home; or time is frozen, or the best shot is shown again. Returns whether all stand still.
bool LiveSource::move(const RoomStep& step, const OperatorSettings& settings, bool still,
                      const ShotView* shot, Decision& decision) {
  FrameRecord& record = decision.frame.record;
  record.headset = room_.viewers().putOn(step.times.headset);
  record.drive.mode = previous_.drive;
  if (shot) {
    ObserverViews seen;
    seen.fill(shot->observer);
    put(room_.freeze(seen, step), record);
    record.boardFromRoom = shot->boardFromRoom;
    return still;
  }
  if (still && frozen_) {
    put(room_.freeze(*frozen_, step), record);
    return true;
  }
  if (link_) {
    const std::optional<ObserverViews> lived = link_->move(scenario_, room_, step);
    if (!lived) {
      if (!frozen_ || !link_->isLiving()) frozen_ = room_.viewers().now(step.eyeSeparation_m);
      put(room_.wait(*frozen_, step), record);
      return true;
    }
    frozen_ = lived;
  } else {
    frozen_ = scenario_.lesson ? lesson_.move(settings, step, room_) : room_.advance(step);
  }
  put(*frozen_, record);
  record.drive = room_.drive();
  if (lesson_.isHeld()) record.drive.thrust = Vec3(0.0);
  const DriveMode mode = record.drive.mode;
  if (std::exchange(previous_.drive, mode) != mode)
    decision.notes.push_back({"drive", kDriveModes[static_cast<std::size_t>(mode)]});
  return still;
}

/// Lets the players act on the game, and see what has become of it if time passes for them.
void LiveSource::act(const OperatorSettings& settings, bool timePasses, Decision& decision) {
  players_.placeSculpture(decision.frame.record);
  const HandRules rules{settings, lesson_.asks(), timePasses && !scenario_.lesson, &world_, link_};
  if (timePasses) Players::feel(world_, inputs_, decision.frame.record);
  players_.act(rules, room_.viewers(), inputs_, game_, announcements_, decision);
  if (timePasses) players_.see(world_, settings, announcements_, decision);
}

/// Tells the people in the room what they should know.
void LiveSource::tell(std::span<const Command> commands, const OperatorSettings& settings, bool still,
                      Decision& decision) {
  if (still) announcements_.tellWhyStill(inputs_.asksToSteer(), settings.views.frozen, decision);
  for (const Command& command : commands) {
    if (const auto* tells = std::get_if<TellPerson>(&command)) announcements_.say(tells->words, decision);
  }
  announcements_.sayTo(inputs_.steering(), room_.takeNotice(), decision);
  announcements_.tellWhoLeft(room_.viewers(), decision);
  announcements_.putInto(decision);
}

/// Calls `take` with the view from each place of the room for which there is a picture by direction.
void LiveSource::seeFromPlaces(const FrameRecord& record,
                               const std::function<void(const ObserverView&)>& take) const {
  for (const Wall& wall : rig_.walls) {
    if (!wall.sky || !wall.sky->from_m) continue;
    take(viewOf(*wall.sky, record.viewers[wall.viewer].observer, record.boardFromRoom, record.room_s));
  }
}

namespace {

/// Returns the board time from which on histories are kept for the sculpture of spacetime, which shows more
/// of them than any eye sees: also while it is not shown, in games with so few pucks that it can show them
/// all.
double keptForSculpture_s(const FrameRecord& record) {
  constexpr double kMargin_s = 12.0;  // beyond what it shows, so that the oldest part is made as ever
  if (!record.views.spacetime && record.pucks > kMostSculpted) return std::numeric_limits<double>::infinity();
  const ObserverView& first = record.viewers.front().observer;
  return first.middle.observation.t_s - kMargin_s -
         sculptureReach_s(record.sculpture.place, first.headFromBoard.lightSpeed_m_s());
}

}  // namespace

/// Plays the game on to the latest event that an eye sees. From time to time discards the past that no eye
/// will see any more, not even in the best shot.
void LiveSource::playGame(const OperatorSettings& settings, FrameState& frame) {
  FrameRecord& record = frame.record;
  for (const ViewerState& viewer : record.present()) {
    if (settings.views.myNow) game_.playToNowOf(viewer.observer);
  }
  double latest_s = latestObservation_s(record);
  seeFromPlaces(record,
                [&](const ObserverView& view) { latest_s = std::max(latest_s, latestObservation_s(view)); });
  game_.advance(latest_s, frame);
  if (record.number % kFramesBetweenForgetting != 0 || scenario_.lesson) return;
  std::vector<ObserverView> observers{players_.earliest(record)};
  for (const ViewerState& viewer : record.present()) observers.push_back(viewer.observer);
  seeFromPlaces(record, [&](const ObserverView& view) { observers.push_back(view); });
  // What another room may still ask about is kept.
  const double kept_s = link_ ? link_->final_s() - 1.0 : std::numeric_limits<double>::infinity();
  game_.forget(world_, observers, frame, std::min(kept_s, keptForSculpture_s(record)));
}

void LiveSource::finish(const FrameTimes& given, Decision& decision) {
  FrameRecord& record = decision.frame.record;
  record.fade = fade_s_ / kFade_s;
  fade_s_ = std::max(0.0, fade_s_ - given.step_s);
  record.last = given.isLast || (lastFrame_ && given.number >= *lastFrame_);
  Viewers& viewers = room_.viewers();
  for (std::size_t i = 0; i < viewers.size(); ++i) decision.heads[i] = viewers.head(i);
  viewers.samplesInto(decision.samples);
  decision.alarms = viewers.takeAlarms();
  decision.timing.sampleAge_s = sampleAge_s(given.begin_s);
}

void LiveSource::put(const ObserverViews& views, FrameRecord& record) const {
  room_.viewers().putInto(record);
  for (std::size_t i = 0; i < record.viewerCount; ++i) record.viewers[i].observer = views[i];
}

double LiveSource::sampleAge_s(double begin_s) {
  const SensorChoice& head = rig_.viewers.front().head.sensor;
  for (const TrackerSample& sample : room_.viewers().samples()) {
    if (sample.sensor == head.sensor)
      previous_.newestSample_s = sample.time_s - rig_.trackers[head.tracker].latency_s;
  }
  return begin_s - previous_.newestSample_s;
}

SourceStatus LiveSource::status() const {
  SourceStatus status;
  if (lastFrame_) status.end = *lastFrame_ + 1;
  status.trackers = room_.viewers().trackers();
  if (link_) status.link = link_->report();
  return status;
}

}  // namespace carom
