#pragma once
// Where frames come from, on rank 0: a game that is played, a recorded one, patterns.

#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "app/input/desk_input.h"
#include "app/operator/controls.h"
#include "cave/frame/frame_state.h"
#include "cave/frame/frame_timing.h"
#include "devices/monitor/tracker_report.h"

namespace carom {

/// What a frame's decision took. What is not known is NaN.
struct Deciding {
  double sampleAge_s = std::numeric_limits<double>::quiet_NaN();  ///< of the head's newest, when it began
  double took_s = std::numeric_limits<double>::quiet_NaN();       ///< without the wait for its beginning
};

class FrameSource {
 public:
  virtual ~FrameSource() = default;

  /// The next frame, its record marked if it is the last. Switches, walls and views of the controls: those of
  /// the frame before, as the operator has left them.
  virtual void next(const Controls& controls, FrameState& state) = 0;
  /// Of the last `next`.
  virtual Deciding deciding() const { return {}; }
  /// The number of the last frame plus one, where it is known.
  virtual std::optional<std::uint64_t> end() const { return std::nullopt; }
  /// From when to when it can be gone through, on the session's clock; none: it goes its own way.
  virtual std::optional<std::pair<double, double>> span_s() const { return std::nullopt; }
  /// Every node has drawn it: returns when it is time to swap.
  virtual void drawn() {}
  /// It is on the walls.
  virtual void shown(const FrameState&) {}
  /// The operator has changed something: it holds from the frame after `number` on.
  virtual void changed(std::uint64_t /*number*/, const ControlChange&) {}
  /// What hands at the desk did since the frame before: before `next`.
  virtual void handled(const DeskInput& /*desk*/) {}
  /// How the trackers fare, for the console: it may allocate.
  virtual std::vector<TrackerReport> trackers() const { return {}; }
  /// Once a second, in real time: where each node's time went.
  virtual void measured(std::span<const LatencyRow>) {}
};

}  // namespace carom
