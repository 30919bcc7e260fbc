#pragma once
// The sources of rank 0's frames: a live game, a recorded one, or test patterns.

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "app/input/desk_input.h"
#include "app/live/decision.h"
#include "app/live/linked_room.h"
#include "cave/frame/pacer.h"
#include "devices/monitor/tracker_report.h"

namespace carom {

/// How long the walls take to go dark before another game, and to come out of black with it.
inline constexpr double kFade_s = 0.5;

/// The operator's and players' input since the previous frame.
struct FrameInput {
  std::span<const Command> commands;  ///< settings changes already applied, and one-time orders
  DeskInput desk;
};

/// The state of a source, for the console and the progress display.
struct SourceStatus {
  std::optional<std::uint64_t> end;  ///< number of the last frame plus one, if known
  std::optional<std::pair<double, double>>
      span_s;  ///< session clock: the range that can be played through; empty if it cannot be controlled
  std::vector<TrackerReport> trackers;
  std::optional<LinkReport> link{};  ///< of another room
};

class FrameSource {
 public:
  virtual ~FrameSource() = default;

  /// Decides the frame for `times` and marks its record if it is the last. `settings` includes all commands
  /// so far. A recorded source writes the recorded settings into it, except those that the operator has
  /// changed since.
  virtual void next(const FrameTimes& times, const FrameInput& input, OperatorSettings& settings,
                    Decision& decision) = 0;

  /// Returns the state of the source. May allocate.
  virtual SourceStatus status() const { return {}; }
};

}  // namespace carom
