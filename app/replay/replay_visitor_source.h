#pragma once
// Decides the frames of a recorded game seen by a new visitor, with another head and another motion.

#include <chrono>
#include <filesystem>
#include <optional>

#include "app/live/frame_source.h"
#include "app/replay/read_only_notice.h"
#include "app/replay/recorded_source.h"
#include "app/rig/rig.h"
#include "app/scenario/scenario.h"
#include "app/viewer/viewers.h"

namespace carom {

/// A visitor of a recorded game: head motion and initial state.
struct Visitor {
  /// Trace of the head in the room; without it, the rig's tracker is used.
  std::optional<std::filesystem::path> trace;
  std::optional<Vec3> beta;  ///< v/c of the visitor's room on the board; without it, as in the scenario
  /// If true, the visitor's time stops where the recorded game ends, and they may go back. If false, the
  /// frames end there.
  bool mayStay = false;
  /// The initial position of the room's floor origin on the board, and the initial direction of its forward
  /// axis, anticlockwise from +x. Without them, as in the scenario.
  std::optional<Vec3> from_m = {};
  std::optional<double> facing_rad = {};
};

class ReplayVisitorSource : public FrameSource {
 public:
  /// Starts a visit. The first frame brings the complete game, because the visitor's board time is
  /// independent of the recorded one. The frames end with the trace, or before the visitor would see more
  /// than was recorded. `start` is where the clock of the frames' times reads zero. Throws InputError if the
  /// trace is invalid.
  ReplayVisitorSource(const Rig& rig, const Scenario& scenario, const Visitor& visitor, RecordedGame game,
                      std::chrono::steady_clock::time_point start);

  /// Decides the frame. Display times advance even if the operator pauses or changes the rate of the game. At
  /// any rate other than the visitor's own, the head's motion has no relativistic effect: it could exceed the
  /// speed of light.
  void next(const FrameTimes& times, const FrameInput& input, OperatorSettings& settings,
            Decision& decision) override;

 private:
  ObserverView look(const OperatorSettings& settings, const FrameTimes& times);
  ObserverView goOn(const Playback& playback, const FrameTimes& times);
  double roomTimeOf_s(const ObserverView& view) const;
  double latestSeen_s(const ObserverView& view) const;
  bool isLast(const FrameTimes& times, const ObserverView& view);

  Viewers viewers_;
  Lorentz roomFromBoard_;
  Event origin_;  ///< of the room at room time 0
  double eyeSeparation_m_;
  double lightSpeed_m_s_;
  std::optional<double> end_s_;  ///< duration of the trace
  bool mayStay_;
  bool hasTracedHeadset_;  ///< the walls hang on the head of a trace
  RecordedGame game_;
  /// The previous frame.
  struct Previous {
    double roomTime_s = 0.0;  ///< of the head
    double display_s = 0.0;
    bool heldBack = false;              ///< it would have shown more than was recorded
    std::optional<double> seen_s;       ///< latest board time seen
    std::optional<ObserverView> sight;  ///< kept for freezing
  };
  Previous previous_;
  std::optional<double> goTo_s_;  ///< time the operator seeks, session clock
  ReadOnlyNotice readOnly_;
};

}  // namespace carom
