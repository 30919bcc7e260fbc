#pragma once
// The person in the room: the tracked head and the world line that it walks.

#include <chrono>
#include <optional>
#include <span>

#include "app/head_tracking.h"
#include "app/rig.h"
#include "app/scenario.h"
#include "cave/frame_state.h"
#include "cave/pacer.h"
#include "engine/observer.h"

namespace carom {

class Person {
 public:
  /// Stands where the scenario begins, or, with `before`, at the event at which an earlier session's last
  /// frame was seen. `sessionStart`: where the session's clock reads zero. Throws InputError if a trace is at
  /// fault.
  Person(const Rig& rig, const Scenario& scenario, std::chrono::steady_clock::time_point sessionStart,
         const std::optional<FrameRecord>& before = {});

  /// Lives on to the frame's display; the eyes then, so far apart.
  ObserverView at(const FrameTimes& times, double eyeSeparation_m);

  /// The head at that display, and what the tracker had delivered for it.
  const HeadEstimate& head() const { return head_; }
  std::span<const TrackerSample> samples() const { return tracking_.samples(); }

 private:
  HeadTracking tracking_;
  HeadEstimate head_;
  Observer observer_;
};

}  // namespace carom
