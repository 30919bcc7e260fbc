#pragma once
// Whether every node draws from the same numbers.

#include <array>
#include <cstdint>
#include <string>

#include "cave/frame/frame_state.h"

namespace carom {

/// What a node draws a frame from, field by field, as digests: the same on every node, or something is wrong.
struct FrameDigest {
  static constexpr std::array<const char*, 9> kFields = {"frame number", "display time",   "observer",
                                                         "switches",     "tracked places", "new knots",
                                                         "new events",   "histories",      "events"};
  std::array<std::uint64_t, kFields.size()> fields{};

  bool operator==(const FrameDigest&) const = default;
};

FrameDigest digestOf(const FrameState& state, const World& world);

/// A body's history, field by field: tells where two histories part.
struct HistoryDigest {
  static constexpr std::array<const char*, 5> kFields = {"number of knots", "turns", "velocities",
                                                         "proper times", "signal"};
  std::array<std::uint64_t, kFields.size()> fields{};

  bool operator==(const HistoryDigest&) const = default;
};

HistoryDigest digestOf(const WorldLine& history);

}  // namespace carom
