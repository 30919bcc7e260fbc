#include "app/live_source.h"

#include <fmt/format.h>

#include <algorithm>

namespace carom {
namespace {

constexpr std::uint64_t kFramesBetweenForgetting = 600;  // ten seconds at 60 Hz

/// The latest board time at which an eye receives light.
double latestObservation_s(const ObserverView& observer) {
  double latest_s = observer.eyes.front().observation.t_s;
  for (const EyeView& eye : observer.eyes) latest_s = std::max(latest_s, eye.observation.t_s);
  return latest_s;
}

std::uint64_t firstFrame(const LiveStart& start) { return start.before ? start.before->number + 1 : 0; }

}  // namespace

LiveSource::LiveSource(const Stage& stage, LiveStart start)
    : stage_(stage),
      clock_(std::move(start.clock)),
      pacer_(*clock_, stage.rig.display_hz, stage.rig.displayLatency_s, start.swapsWait, firstFrame(start)),
      person_(stage.rig, stage.scenario, start.sessionStart, start.before),
      game_(stage.scenario) {
  if (start.frames) lastFrame_ = firstFrame(start) + *start.frames - 1;
}

void LiveSource::next(const Controls& controls, FrameState& state) {
  const FrameTimes times = pacer_.next();
  const auto begun = std::chrono::steady_clock::now();
  FrameRecord& record = state.record = {};
  const double pace = controls.lightSpeed_m_s / stage_.scenario.billiard.lightSpeed_m_s;
  if (controls.views.frozen && frozen_) {
    record.observer = person_.round(*frozen_, times, controls.eyeSeparation_m);
  } else {
    record.observer = person_.at(times, controls.eyeSeparation_m, pace);
    frozen_ = record.observer;
  }
  record.boardFromRoom = person_.boardFromRoom();
  if (controls.views.myNow) game_.playToNowOf(record.observer);
  game_.advance(latestObservation_s(record.observer), state);
  if (times.number % kFramesBetweenForgetting == 0) game_.forget(stage_.world.histories, record.observer, state);
  record.number = times.number;
  record.display_s = times.display_s;
  record.lightSpeed_m_s = controls.lightSpeed_m_s;
  record.last = lastFrame_ && times.number >= *lastFrame_;
  record.switches = controls.switches;
  record.controls = controls.walls;
  record.views = controls.views;
  record.tracked = person_.tracked();
  noteDeciding(times.begin_s, begun);
}

void LiveSource::noteDeciding(double begin_s, std::chrono::steady_clock::time_point begun) {
  const SensorChoice& head = stage_.rig.head.sensor;
  for (const TrackerSample& sample : person_.samples()) {
    if (sample.sensor == head.sensor) newestSample_s_ = sample.time_s - stage_.rig.trackers[head.tracker].latency_s;
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
  if (journal_) journal_->add(state, person_.head(), person_.samples());
}

void LiveSource::changed(std::uint64_t number, const ControlChange& change) {
  if (journal_) journal_->addInput(number + 1, change.what, change.value);
}

void LiveSource::measured(std::span<const LatencyRow> rows) {
  if (journal_) journal_->add(rows);
}

}  // namespace carom
