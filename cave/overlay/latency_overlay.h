#pragma once
// A node's time budget, over its windows: where each frame's time goes, compared with the display's period.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cave/frame/frame_timing.h"

namespace carom {

/// The numbers that the overlay shows.
struct LatencyView {
  std::string node;  ///< "node 1 (left)"
  std::uint64_t frame = 0;
  double display_hz = 60.0;
  LockState lock = LockState::software;
  std::string lockWhyNot;  ///< why there is no swap group though the rig asks for one; otherwise empty
  std::array<PartStatistics, kFrameParts.size()> parts;
  /// One entry for every node, on rank 0 alone.
  struct Node {
    std::string name;
    PartStatistics late;
    LockState lock = LockState::software;
  };
  std::vector<Node> nodes;
};

/// What one wall's pictures take.
struct WallTime {
  const char* wall = nullptr;
  float drawn_s = 0.0F;  ///< by the graphics card; NaN while that is not known
  std::size_t triangles = 0;
};

/// Draws in the upper left corner of the window, between a Gui's begin and end.
void drawLatency(const LatencyView& view, std::span<const WallTime> walls = {});
/// Draws the same inside a window of Dear ImGui.
void drawLatencyNumbers(const LatencyView& view);

}  // namespace carom
