#pragma once
// Frames of a recorded game for somebody who was not there: another head, another motion.

#include <chrono>
#include <filesystem>
#include <optional>

#include "app/files/rig.h"
#include "app/files/scenario.h"
#include "app/session/frame_source.h"
#include "app/session/read_only_notice.h"
#include "app/session/recorded_source.h"
#include "app/viewer/viewer.h"

namespace carom {

/// Who visits, and where they begin.
struct Visitor {
  /// Of their head, in the room; none: the rig's tracker follows it.
  std::optional<std::filesystem::path> trace;
  std::optional<Vec3> beta;  ///< v/c of their room on the board; none: the scenario's
  /// Where the recorded game ends time stands still for them, and they may go back; else the frames end
  /// there.
  bool mayStay = false;
  /// Where the room's floor origin begins on the board, and its forward, anticlockwise from +x; none: as in
  /// the scenario.
  std::optional<Vec3> from_m = {};
  std::optional<double> facing_rad = {};
};

class ReplayVisitorSource : public FrameSource {
 public:
  /// All of the game is brought with the first frame: this person's board time is their own. The frames end
  /// when the trace does, and before the person would see what was not recorded. `start`: where the clock reads zero
  /// that the frames' times are of. Throws InputError if the trace is at fault.
  ReplayVisitorSource(const Rig& rig, const Scenario& scenario, const Visitor& visitor, RecordedGame game,
                      std::chrono::steady_clock::time_point start);

  /// Display times go on, whatever the operator does with the game's. While it runs otherwise than the
  /// person's, their own motion is not seen: it would be faster than light.
  void next(const FrameTimes& times, const FrameInput& input, OperatorSettings& settings,
            Decision& decision) override;

 private:
  ObserverView look(const OperatorSettings& settings, const FrameTimes& times);
  ObserverView goOn(const Playback& playback, const FrameTimes& times);
  double roomTimeOf_s(const ObserverView& view) const;
  double latestSeen_s(const ObserverView& view) const;
  bool isLast(const FrameTimes& times, const ObserverView& view);

  Viewer viewer_;
  Lorentz roomFromBoard_;
  Event origin_;  ///< of the room, at its time 0
  double eyeSeparation_m_;
  double lightSpeed_m_s_;
  std::optional<double> end_s_;  ///< of the trace
  bool mayStay_;
  RecordedGame game_;
  double roomTime_s_ = 0.0;       ///< of the head at the frame before
  double display_s_ = 0.0;        ///< of the frame before
  bool heldBack_ = false;         ///< the last frame would have shown what was not recorded
  std::optional<double> seen_s_;  ///< the latest board time that was seen in the frame before
  std::optional<double> goTo_s_;  ///< where the operator wants to be, on the session's clock
  ReadOnlyNotice readOnly_;
  std::optional<ObserverView> sight_;  ///< of the frame before: to be frozen
};

}  // namespace carom
