#pragma once
// What must be true of every game, checked from what `Billiard` delivers and by other methods than its own.

#include <map>
#include <string>
#include <vector>

#include "engine/billiard/billiard.h"

namespace carom::test {

struct Violation {
  std::string kind;  ///< in a word or two, for tallies
  std::string what;  ///< with the numbers
};

/// What was looked at, by name.
using Tally = std::map<std::string, std::size_t>;

/// Every invariant of one game, played until `until_s`, or until it has had twice `mostEvents`. Exceptions of
/// the engine are violations, too.
std::vector<Violation> violationsOf(const BilliardSetup& setup, double until_s, std::size_t mostEvents,
                                    Tally& tally);

}  // namespace carom::test
