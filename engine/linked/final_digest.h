#pragma once
// Digests by which rooms find out whether they have computed the same game, and programs whether they
// compute alike. Theory: app/doc/physics.md, Linked rooms.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/spacetime/world_line.h"

namespace carom {

/// A turn as it is digested: the number of the puck among the names in their order, then of its knot the
/// time, place, u, own time, spin and angle.
using FinalTurn = std::array<double, 9>;

/// The digest of all turns of a game before a board second that nothing can change any more: before all
/// promises of all rooms (promise.h). Each second's is made of the one before and of the second's turns, so
/// turns can be forgotten once they are in it.
class FinalDigest {
 public:
  /// Pucks count in the order of their names.
  explicit FinalDigest(std::span<const std::string> names);

  /// Adds the whole seconds before `final_s`. `pucks` are in the order of the names given.
  void add(std::span<const WorldLine> pucks, double final_s);

  std::uint32_t second() const { return second_; }  ///< the second before which all is in `value`
  std::uint64_t value() const { return value_; }
  std::span<const FinalTurn> turns() const { return turns_; }  ///< of the last second that was added

 private:
  std::vector<std::size_t> order_;  ///< of the pucks
  std::vector<FinalTurn> turns_;    ///< of a second
  std::uint32_t second_ = 0;
  std::uint64_t value_ = 0;
};

/// Where two games of one second differ.
struct TurnDifference {
  std::size_t puck = 0;  ///< its number among the names in their order
  std::size_t turn = 1;  ///< counts the puck's turns in that second from 1
  double t_s = 0.0;      ///< board time of the turn, in the game that has it earlier
};
/// Returns the first turn in the order of time that two games do not have to the bit alike; nothing if they
/// are the same. Turns of each puck stand in the order of their times.
std::optional<TurnDifference> firstDifference(std::span<const FinalTurn> here,
                                              std::span<const FinalTurn> there);

/// Returns a fingerprint of the program's arithmetic: that of two games of twenty seconds with friction,
/// spin, corners and strokes. Programs whose fingerprints are equal compute the same games to the bit, as far
/// as these two can tell.
std::uint64_t arithmeticFingerprint();

}  // namespace carom
