#pragma once
// A node's budget of time, over its windows: where each frame's time goes, against the display's period.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "cave/frame/frame_timing.h"

namespace carom {

/// What the overlay says.
struct LatencyView {
  std::string node;  ///< "node 1 (left)"
  std::uint64_t frame = 0;
  double display_hz = 60.0;
  LockState lock = LockState::software;
  std::string lockWhyNot;  ///< why it is no swap group though the rig asks for one; empty: nothing is missing
  std::array<PartStatistics, kFrameParts.size()> parts;
  /// Of every node, on rank 0 alone.
  struct Node {
    std::string name;
    PartStatistics late;
    LockState lock = LockState::software;
  };
  std::vector<Node> nodes;
};

/// In the upper left corner of the window, within a Gui's begin and end.
void drawLatency(const LatencyView& view);
/// The same within a window of Dear ImGui's.
void drawLatencyNumbers(const LatencyView& view);

}  // namespace carom
