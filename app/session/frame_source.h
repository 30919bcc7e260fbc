#pragma once
// Where frames come from, on rank 0: a game that is played, a recorded one, patterns.

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "app/input/desk_input.h"
#include "app/session/decision.h"
#include "cave/frame/pacer.h"
#include "devices/monitor/tracker_report.h"

namespace carom {

/// What people have done since the frame before.
struct FrameInput {
  std::span<const Command> commands;  ///< that have changed the settings, or are orders of one moment
  DeskInput desk;
};

/// How a source fares, for the console and for who waits.
struct SourceStatus {
  std::optional<std::uint64_t> end;  ///< the number of the last frame plus one, where it is known
  std::optional<std::pair<double, double>>
      span_s;  ///< session clock: what can be gone through; none: it goes its own way
  std::vector<TrackerReport> trackers;
};

class FrameSource {
 public:
  virtual ~FrameSource() = default;

  /// Decides the frame of these times, its record marked if it is the last. `settings`: with all commands so far. A
  /// recording puts in what was recorded, under what the operator has changed since.
  virtual void next(const FrameTimes& times, const FrameInput& input, OperatorSettings& settings,
                    Decision& decision) = 0;

  /// Returns how the source fares. It may allocate.
  virtual SourceStatus status() const { return {}; }
};

}  // namespace carom
