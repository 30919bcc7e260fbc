#pragma once
// A lesson as it runs: its passes, the moment that is held while it explains, and the velocities that it
// offers.

#include <cstddef>
#include <optional>

#include "app/live/decision.h"
#include "app/operator/operator_settings.h"
#include "app/scenario/scenario.h"
#include "app/viewer/room_motion.h"

namespace carom {

class LessonRun {
 public:
  /// `scenario` must outlive this object.
  explicit LessonRun(const Scenario& scenario) : scenario_(&scenario) {}

  /// Begins the first pass; does nothing in a game without a lesson.
  void begin(RoomMotion& room);

  /// Takes over the lesson's state for this frame, and notes an answer that was just given, by viewer
  /// `answeredBy`.
  void take(const LessonState& state, std::size_t answeredBy, Decision& decision);

  /// Returns whether the lesson waits for an answer: until then time is frozen, so that nothing of it can be
  /// seen.
  bool asks() const { return state_.phase == LessonPhase::asks; }

  /// Moves the room, and returns the view. While the lesson shows, the game passes from the beginning of its
  /// interval to the end, slowly, stays there for a moment and begins again. While it explains, its moment is
  /// held.
  ObserverViews move(const OperatorSettings& settings, const RoomStep& step, RoomMotion& room);

  /// Returns whether time stood still in the last frame: at the lesson's moment, or at the end of a pass.
  bool isHeld() const { return explained_ || passEnded_s_.has_value(); }

 private:
  void beginPass(std::size_t observer, RoomMotion& room);

  const Scenario* scenario_;
  LessonState state_;                  ///< in the previous frame
  std::size_t observer_ = 0;           ///< the lesson's velocity in the previous frame
  bool explained_ = false;             ///< its moment was held in the previous frame
  std::optional<double> passEnded_s_;  ///< display time at which a pass ended
};

}  // namespace carom
