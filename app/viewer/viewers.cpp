#include "app/viewer/viewers.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace carom {
namespace {

/// Returns times one period before the first frame is shown; a continued session keeps its clock.
FrameTimes firstTimes(const Rig& rig, const std::optional<FrameRecord>& before) {
  const double begin_s = before ? before->display_s : 0.0;
  return {0, begin_s, begin_s + 1.0 / rig.display_hz + rig.displayLatency_s, 0.0};
}

std::vector<std::unique_ptr<HeadTracking>> trackingsOf(const Rig& rig, SharedTrackers& shared) {
  std::vector<std::unique_ptr<HeadTracking>> trackings;
  for (const ViewerSetup& viewer : rig.viewers)
    trackings.push_back(std::make_unique<HeadTracking>(rig, viewer, shared));
  return trackings;
}

}  // namespace

Viewers::Viewers(const Rig& rig, const Scenario& scenario, SharedTrackers trackers,
                 const std::optional<FrameRecord>& before)
    : shared_(std::move(trackers)),
      trackings_(trackingsOf(rig, shared_)),
      observers_((track(firstTimes(rig, before)), startOf(rig, scenario, before))) {
  for (std::size_t i = 0; i < rig.viewers.size(); ++i) {
    names_.push_back(rig.viewers[i].name);
    eyeSeparations_m_[i] = rig.viewers[i].head.eyeSeparation_m;
    trackers_[i] = rig.viewers[i].head.sensor.tracker;
  }
}

void Viewers::track(const FrameTimes& times) {
  for (std::size_t i = 0; i < trackings_.size(); ++i) {
    heads_[i] = trackings_[i]->at(times);
    if (!held_) continue;
    heads_[i].pose = (*held_)[i];
    heads_[i].celerity_m_s = Vec3(0.0);
  }
}

void Viewers::hold(bool on) {
  held_.reset();
  if (!on) return;
  held_.emplace();
  for (std::size_t i = 0; i < trackings_.size(); ++i) (*held_)[i] = heads_[i].pose;
}

Viewers::Heads Viewers::heads() const {
  Heads heads;
  for (std::size_t i = 0; i < trackings_.size(); ++i) heads[i] = {heads_[i].pose, heads_[i].celerity_m_s};
  return heads;
}

Viewers::Heads Viewers::headsAtRest() const {
  Heads heads;
  for (std::size_t i = 0; i < trackings_.size(); ++i) heads[i] = {heads_[i].pose, Vec3(0.0)};
  return heads;
}

Observers Viewers::startOf(const Rig& rig, const Scenario& scenario,
                           const std::optional<FrameRecord>& before) const {
  const Heads now = heads();
  if (!before) {
    const Lorentz room = startingRoom(scenario.observer, rig.axes, scenario.billiard.lightSpeed_m_s);
    return Observers(room, {0.0, scenario.observer.position_m}, used(now));
  }
  std::array<OneObserver, kMostViewers> observers;
  for (std::size_t i = 0; i < trackings_.size(); ++i) {
    const ObserverView& last = before->viewers[i].observer;
    observers[i] = {last.middle.observation, before->viewers[i].placeInRoom_m, now[i], last.properTime_s};
  }
  return Observers(before->boardFromRoom, before->room_s, std::span(observers).first(trackings_.size()));
}

void Viewers::startIn(const Rig& rig, const Scenario& scenario) { observers_ = startOf(rig, scenario, {}); }

void Viewers::startAt(const Rig& rig, const Scenario& scenario, const ObserverStart& start, double board_s) {
  const Lorentz room = startingRoom(start, rig.axes, scenario.billiard.lightSpeed_m_s);
  const Heads now = heads();
  observers_ = Observers(room, {0.0, start.position_m}, used(now));
  // Board time runs γ times as fast as time in the room: dt = γ dT for a head at rest there.
  observers_.moveUnseen((board_s - observers_.headEvent().t_s) / gammaFromU(room.u()), used(now));
}

const HeadsetState& Viewers::putOn(const std::optional<HeadsetFrame>& headset) {
  if (headset && headset->isTracked) {
    const Pose head = headBetween(headset->eyes);
    if (!worn_m_ && observers_.properTime_s() == 0.0) observers_.moveUnseen(0.0, Head{head, Vec3(0.0)});
    worn_m_ = {headset->eyes[0].roomFromEye.position_m - head.position_m,
               headset->eyes[1].roomFromEye.position_m - head.position_m};
  }
  if (headset) worn_.eyes = headset->eyes;
  const std::optional<Vec3> velocity_m_s = headset ? headset->runtimeVelocity_m_s : std::nullopt;
  worn_.isWorn = worn_m_ ? 1 : 0;
  worn_.velocityKnown = velocity_m_s ? 1 : 0;
  worn_.runtimeVelocity_m_s = velocity_m_s.value_or(Vec3(0.0));
  return worn_;
}

ObserverViews Viewers::viewsOf(const Observers& observers, double eyeSeparation_m) const {
  ObserverViews views;
  const double share = eyeSeparations_m_[0] > 0.0 ? eyeSeparation_m / eyeSeparations_m_[0] : 1.0;
  views[0] = worn_m_ ? observers.view((*worn_m_)[0], (*worn_m_)[1]) : observers.view(eyeSeparation_m);
  for (std::size_t i = 1; i < size(); ++i) views[i] = observers.view(share * eyeSeparations_m_[i], i);
  return views;
}

std::optional<ObserverViews> Viewers::atOneOf(std::span<const double> paces,
                                              const std::function<bool(const ObserverViews&)>& isAllowed,
                                              const FrameTimes& times, double eyeSeparation_m,
                                              const DriveWish& wish, PlatformMotion& drive,
                                              std::size_t steering) {
  track(times);
  const Observers before = observers_;
  const PlatformMotion driven = drive;
  for (const double pace : paces) {
    drive.advance(wish, times.step_s, pace, used(heads()), observers_, steering);
    const ObserverViews lived = views(eyeSeparation_m);
    if (isAllowed(lived)) return lived;
    observers_ = before;
    drive = driven;
  }
  return std::nullopt;
}

ObserverViews Viewers::standingView(const ObserverViews& sight, double eyeSeparation_m) const {
  Observers moved = observers_;
  moved.moveUnseen(0.0, used(heads()));
  ObserverViews now = viewsOf(moved, eyeSeparation_m);
  for (std::size_t i = 0; i < size(); ++i) now[i] = frozenViewAt(sight[i], now[i]);
  return now;
}

ObserverViews Viewers::at(const FrameTimes& times, double eyeSeparation_m, double pace) {
  track(times);
  observers_.beginFrame();
  observers_.step(times.step_s, used(heads()), pace);
  return views(eyeSeparation_m);
}

ObserverViews Viewers::at(const FrameTimes& times, double eyeSeparation_m, double pace, const DriveWish& wish,
                          PlatformMotion& drive, std::size_t steering) {
  track(times);
  drive.advance(wish, times.step_s, pace, used(heads()), observers_, steering);
  return views(eyeSeparation_m);
}

ObserverViews Viewers::slowView(const FrameTimes& times, double eyeSeparation_m, double pace, double step_s,
                                const DriveWish& wish, PlatformMotion& drive, std::size_t steering) {
  const Heads before = headsAtRest();
  track(times);
  drive.advance(wish, step_s, pace, used(before), observers_, steering);
  observers_.moveUnseen(0.0, used(heads()));
  return views(eyeSeparation_m);
}

void Viewers::runTo(double board_s, PlatformMotion& drive) {
  constexpr double kStep_s = 1.0 / 60.0, kThere_s = 1e-9;
  const Heads heads = headsAtRest();
  for (double left_s = board_s - this->board_s(); left_s > kThere_s; left_s = board_s - this->board_s()) {
    const double step_s = std::min(kStep_s, left_s / gammaFromU(observers_.boardFromRoom().u()));
    drive.advance({}, step_s, 1.0, used(heads), observers_);
  }
}

ObserverViews Viewers::frozenView(const ObserverViews& sight, const FrameTimes& times,
                                  double eyeSeparation_m) {
  track(times);
  observers_.beginFrame();
  observers_.step(0.0, used(heads()));
  ObserverViews now = views(eyeSeparation_m);
  for (std::size_t i = 0; i < size(); ++i) now[i] = frozenViewAt(sight[i], now[i]);
  return now;
}

ObserverViews Viewers::freeView(const FrameTimes& times, double eyeSeparation_m, double roomTime_s) {
  track(times);
  observers_.moveUnseen(roomTime_s, used(heads()));
  return views(eyeSeparation_m);
}

void Viewers::samplesInto(std::vector<TrackerSamples>& samples) const {
  for (std::size_t i = 0; i < size(); ++i) {
    const auto taken =
        std::find(trackers_.begin(), trackers_.begin() + static_cast<std::ptrdiff_t>(i), trackers_[i]);
    if (taken == trackers_.begin() + static_cast<std::ptrdiff_t>(i))
      samples.push_back({trackers_[i], this->samples(i)});
  }
}

std::vector<TrackerReport> Viewers::trackers() const {
  std::vector<TrackerReport> reports;
  for (std::size_t i = 0; i < size(); ++i) {
    std::vector<TrackerReport> ofOne = trackings_[i]->reports(heads_[i]);
    for (TrackerReport& report : ofOne) {
      if (size() > 1) report.use = names_[i] + ": " + report.use;
    }
    std::move(ofOne.begin(), ofOne.end(), std::back_inserter(reports));
  }
  return reports;
}

std::vector<std::string> Viewers::takeAlarms() {
  std::vector<std::string> alarms;
  for (const auto& tracking : trackings_) {
    std::vector<std::string> ofOne = tracking->takeAlarms();
    std::move(ofOne.begin(), ofOne.end(), std::back_inserter(alarms));
  }
  return alarms;
}

void Viewers::putInto(FrameRecord& record) const {
  record.viewerCount = size();
  record.boardFromRoom = observers_.boardFromRoom();
  record.room_s = observers_.room_s();
  for (std::size_t i = 0; i < size(); ++i) {
    ViewerState& viewer = record.viewers[i];
    viewer.tracked = tracked(i);
    viewer.placeInRoom_m = observers_[i].placeInRoom_m;
    viewer.lapse = observers_[i].lapse;
  }
}

}  // namespace carom
