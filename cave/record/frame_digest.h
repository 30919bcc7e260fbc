#pragma once
// Digests that tell whether all nodes draw from the same numbers.

#include <array>
#include <cstdint>
#include <string>

#include "cave/record/frame_state.h"

namespace carom {

/// Digests of the data from which a node draws a frame, one for each section of the record and for each list.
/// If they differ between nodes, something is wrong.
struct FrameDigest {
  static constexpr std::array<const char*, 10> kFields = {
      "frame number", "display time", "observer",  "switches", "tracked places",
      "new knots",    "new events",   "histories", "events",   "soft rows"};
  std::array<std::uint64_t, kFields.size()> fields{};

  bool operator==(const FrameDigest&) const = default;
};

FrameDigest digestOf(const FrameState& state, const World& world);

/// Digests of a body's history, one for each field. They tell in which field two histories differ.
struct HistoryDigest {
  static constexpr std::array<const char*, 5> kFields = {"number of knots", "turns", "velocities",
                                                         "proper times", "signal"};
  std::array<std::uint64_t, kFields.size()> fields{};

  bool operator==(const HistoryDigest&) const = default;
};

HistoryDigest digestOf(const WorldLine& history);

}  // namespace carom
