#pragma once
// The operator's choices for all walls of a room.

#include <cstdint>

namespace carom {

enum class Shown : std::uint8_t { session, calibrationPattern, alignmentPattern };

struct WallControls {
  Shown shown = Shown::session;
  std::uint8_t blank = 0;         ///< 1: every wall is black
  std::uint8_t eyesSwapped = 0;   ///< 1: each eye gets the other's picture
  std::uint8_t trackerCross = 0;  ///< 1: a cross is drawn at each tracked sensor
  std::uint8_t latency = 0;       ///< 1: every node shows in its windows how it spends its time

  std::uint8_t comfort = 0;  ///< 1: while the room moves, the edges of sight darken and a frame rests

  bool operator==(const WallControls&) const = default;
};

}  // namespace carom
