#pragma once
// The person in the room: the tracked head and the world line that it walks.

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
  /// Stands where the scenario begins, or, with `before`, at the event at which an earlier session's last
  /// frame was seen. `sessionStart`: where the session's clock reads zero. Throws InputError if a trace is at
  /// fault.
  Viewer(const Rig& rig, const Scenario& scenario, std::chrono::steady_clock::time_point sessionStart,
         const std::optional<FrameRecord>& before = {});

  /// Is where another scenario's platform begins, and as young; the tracker goes on.
  void startIn(const Rig& rig, const Scenario& scenario);

  /// Lives on to the frame's display; the eyes then, so far apart. `pace`: how many of the game's seconds go
  /// by in one of the person's.
  ObserverView at(const FrameTimes& times, double eyeSeparation_m, double pace = 1.0);
  /// The same on a platform that is driven.
  ObserverView at(const FrameTimes& times, double eyeSeparation_m, double pace, const DriveWish& wish,
                  PlatformMotion& drive);

  /// The person's time stands still, and so does what they see: they walk round it. `sight`: at that moment.
  ObserverView frozenView(const ObserverView& sight, const FrameTimes& times, double eyeSeparation_m);

  /// Walks about in a game while so much of the room's time goes by, or is gone back: their own motion is not
  /// seen (Observer::moveUnseen).
  ObserverView freeView(const FrameTimes& times, double eyeSeparation_m, double roomTime_s);

  /// The head at that display, and what the tracker had delivered for it.
  const HeadEstimate& head() const { return head_; }
  Tracked tracked() const { return tracking_.tracked(); }
  const HandDevices& hand() const { return tracking_.hand(); }
  std::vector<TrackerReport> trackers() const { return tracking_.reports(head_); }
  const Lorentz& boardFromRoom() const { return observer_.boardFromRoom(); }
  std::span<const TrackerSample> samples() const { return tracking_.samples(); }

 private:
  HeadTracking tracking_;
  HeadEstimate head_;
  Observer observer_;
};

}  // namespace carom
