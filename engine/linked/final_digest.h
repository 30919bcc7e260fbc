#pragma once
// Digests by which rooms find out whether they have computed the same game, and programs whether they
// compute alike. Theory: app/doc/physics.md, Linked rooms.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/spacetime/world_line.h"

namespace carom {

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

 private:
  std::vector<std::size_t> order_;  ///< of the pucks
  std::vector<double> numbers_;     ///< of a second; kept for its memory
  std::uint32_t second_ = 0;
  std::uint64_t value_ = 0;
};

/// Returns a fingerprint of the program's arithmetic: that of two games of twenty seconds with friction,
/// spin, corners and strokes. Programs whose fingerprints are equal compute the same games to the bit, as far
/// as these two can tell.
std::uint64_t arithmeticFingerprint();

}  // namespace carom
