#pragma once
// The parts of violationsOf (game_invariants.h), each with one subject.

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "engine/game_invariants.h"
#include "engine/game_record.h"

namespace carom::test {

class Findings {
 public:
  explicit Findings(Tally& counted) : tally(counted) {}
  /// Notes a violation unless `holds`; NaN does not.
  template <class... Parts>
  void expect(bool holds, const char* kind, const Parts&... parts) {
    if (holds) return;
    std::ostringstream what;
    what.precision(17);
    (what << ... << parts);
    all.push_back({kind, what.str()});
  }
  Tally& tally;
  std::vector<Violation> all;
};

/// Energy and momentum, at every moment of the game as it is played until `until_s`; plays it.
void checkLedger(Billiard& billiard, const BilliardSetup& setup, double until_s, std::size_t mostEvents,
                 Findings& found);
/// Continuous, slower than light, one clock each, none outside the table, every turn told as an event.
void checkWorldLines(const GameRecord& game, Findings& found);
/// Each collision: momentum, heat, restitution; where it was; causes before effects.
void checkCollisions(const GameRecord& game, Findings& found);
/// No puck collides without end in no time.
void checkProgress(const GameRecord& game, Findings& found);
/// No contact missing from the list.
void checkNoneMissed(const GameRecord& game, Findings& found);
/// The same bits for mirror images, half turns, any order in the file, any steps, and strokes told late.
void checkSameBits(const BilliardSetup& setup, double until_s, Findings& found);

}  // namespace carom::test
