#pragma once
// The room and its viewers on their way over the board: their world lines, and the platform that carries
// them.

#include <functional>
#include <optional>
#include <span>
#include <utility>

#include "app/rig/rig.h"
#include "app/scenario/scenario.h"
#include "app/viewer/platform_motion.h"
#include "app/viewer/shared_trackers.h"
#include "app/viewer/viewers.h"

namespace carom {

/// What moves the room in a frame.
struct RoomStep {
  const FrameTimes& times;
  double eyeSeparation_m = 0.0;  ///< of the first viewer
  double pace = 1.0;             ///< game seconds per second of the viewer who moves fastest
  DriveWish wish = {};
  std::size_t steering = 0;  ///< the viewer whose wish it is
};

class RoomMotion {
 public:
  /// Starts at the scenario's initial state or, with `before`, where the last frame of an earlier session
  /// was. `rig` and `scenario` must outlive this object. Throws InputError if a recorded trace is invalid.
  RoomMotion(const Rig& rig, const Scenario& scenario, SharedTrackers trackers,
             const std::optional<FrameRecord>& before);

  /// Restarts in the scenario's initial state, after the scenario has been replaced.
  void start();

  /// Restarts at board time `board_s` on the way of a room that moves as `start` says and is there at board
  /// time 0.
  void startAt(const ObserverStart& start, double board_s);

  /// Starts the scenario's tour with the next frame.
  void setOut() { drive_.setOut(); }

  /// Advances to the frame's display time, and returns the eyes there.
  ObserverViews advance(const RoomStep& step);

  /// Advances by `own_s` of the fastest viewer's proper time, however long the frame takes
  /// (Viewers::slowView).
  ObserverViews advanceSlowly(const RoomStep& step, double own_s);

  /// Does the same at the first of these paces whose views are allowed. If none are, the people do not live
  /// on, and nothing is returned.
  std::optional<ObserverViews> advanceIf(const RoomStep& step, std::span<const double> paces,
                                         const std::function<bool(const ObserverViews&)>& isAllowed) {
    return viewers_.atOneOf(paces, isAllowed, step.times, step.eyeSeparation_m, step.wish, drive_,
                            step.steering);
  }
  /// The people do not live on; each view stays at its event in `sight` (Viewers::standingView).
  ObserverViews wait(const ObserverViews& sight, const RoomStep& step) const {
    return viewers_.standingView(sight, step.eyeSeparation_m);
  }

  /// Lets no time pass: the heads move alone, without relativistic effect.
  ObserverViews stand(const RoomStep& step) {
    return viewers_.freeView(step.times, step.eyeSeparation_m, 0.0);
  }

  /// Lets no time pass while each view stays at its event in `sight`.
  ObserverViews freeze(const ObserverViews& sight, const RoomStep& step) {
    return viewers_.frozenView(sight, step.times, step.eyeSeparation_m);
  }

  /// Advances until board time `board_s` of the first viewer, with the heads at rest in the room.
  void runTo(double board_s) { viewers_.runTo(board_s, drive_); }

  const DriveView& drive() const { return drive_.view(); }
  /// Returns and clears the platform's message since the last call.
  texts::Saying takeNotice() { return drive_.takeNotice(); }

  Viewers& viewers() { return viewers_; }
  const Viewers& viewers() const { return viewers_; }

 private:
  const Rig& rig_;
  const Scenario& scenario_;
  Viewers viewers_;
  PlatformMotion drive_;
};

}  // namespace carom
