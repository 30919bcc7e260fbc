#pragma once
// The viewer in the room: the tracked head and its world line.

#include <chrono>
#include <optional>
#include <span>

#include "app/files/rig.h"
#include "app/files/scenario.h"
#include "app/viewer/head_tracking.h"
#include "app/viewer/platform_motion.h"
#include "cave/frame/frame_state.h"
#include "cave/frame/pacer.h"
#include "engine/spacetime/observer.h"

namespace carom {

class Viewer {
 public:
  /// Starts at the scenario's initial state or, with `before`, at the observation event of an earlier
  /// session's last frame. `sessionStart` is where the session clock reads zero. Throws InputError if a
  /// recorded trace is invalid.
  Viewer(const Rig& rig, const Scenario& scenario, std::chrono::steady_clock::time_point sessionStart,
         const std::optional<FrameRecord>& before = {});

  /// Restarts in the initial state of another scenario, with proper time zero. The tracker continues.
  void startIn(const Rig& rig, const Scenario& scenario);

  /// Restarts at board time `board_s` on the way of a room that moves as `start` says and is there at board
  /// time 0, with proper time zero. The tracker continues.
  void startAt(const Rig& rig, const Scenario& scenario, const ObserverStart& start, double board_s);

  /// Advances the world line to the frame's display time and returns the eyes there, `eyeSeparation_m` apart.
  /// `pace` is the number of game seconds per second of the viewer.
  ObserverView at(const FrameTimes& times, double eyeSeparation_m, double pace = 1.0);
  /// Does the same on a platform that is driven.
  ObserverView at(const FrameTimes& times, double eyeSeparation_m, double pace, const DriveWish& wish,
                  PlatformMotion& drive);

  /// Returns the view after `step_s` of the viewer's proper time, however long the frame takes. The head's
  /// motion has no relativistic effect meanwhile (Observer::moveUnseen).
  ObserverView slowView(const FrameTimes& times, double eyeSeparation_m, double pace, double step_s,
                        const DriveWish& wish, PlatformMotion& drive);

  /// Lives on until board time `board_s`, with the head at rest in the room.
  void runTo(double board_s, PlatformMotion& drive);

  /// Frozen mode: the view stays at one observation event while the head moves. `sight` is the view at that
  /// event.
  ObserverView frozenView(const ObserverView& sight, const FrameTimes& times, double eyeSeparation_m);

  /// Returns the view when the room's time is advanced, or set back, by `roomTime_s`. The head's motion has
  /// no relativistic effect meanwhile (Observer::moveUnseen).
  ObserverView freeView(const FrameTimes& times, double eyeSeparation_m, double roomTime_s);

  /// The head at that display time, and the tracker data for it.
  const HeadEstimate& head() const { return head_; }
  double board_s() const { return observer_.headEvent().t_s; }
  Tracked tracked() const { return tracking_.tracked(); }
  const HandDevices& hand() const { return tracking_.hand(); }
  std::vector<TrackerReport> trackers() const { return tracking_.reports(head_); }
  std::vector<std::string> takeAlarms() { return tracking_.takeAlarms(); }
  const Lorentz& boardFromRoom() const { return observer_.boardFromRoom(); }
  std::span<const TrackerSample> samples() const { return tracking_.samples(); }

 private:
  HeadTracking tracking_;
  HeadEstimate head_;
  Observer observer_;
};

}  // namespace carom
