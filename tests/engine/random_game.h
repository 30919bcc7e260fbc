#pragma once
// Games drawn at random from everything that can be played, and any game as the text of a scenario file.

#include <cstdint>
#include <string>

#include "engine/billiard/billiard.h"

namespace carom::test {

struct RandomGame {
  std::uint64_t seed = 0;
  std::string kind;  ///< what it has in it, in a few words
  BilliardSetup setup;
  double until_s = 0.0;  ///< board time to which it is worth being played
};

struct GameLimits {
  std::size_t events = 300;  ///< it ends before it has had so many
  int packed = 60;           ///< pucks of a pile
};

/// The game of a seed: 2 to 100 pucks, to 0.999 c, masses 1 : 1000, restitutions 0 to 1, with and without
/// friction, both conventions, cushions or an open plane; scattered, racked, in rows and piles that touch or
/// nearly do, aimed at corners; struck at any moment, among them those between a contact and its turn, and as
/// late as after 24 h of board time. The moments of strokes are found by playing the game.
RandomGame randomGame(std::uint64_t seed, const GameLimits& limits = {});

/// As `carom simulate` reads it.
std::string scenarioText(const BilliardSetup& setup);

/// Plays on in steps until `until_s`, or until there are that many events. Returns the time reached.
double playAtMost(Billiard& billiard, const BilliardSetup& setup, double until_s, std::size_t mostEvents);

}  // namespace carom::test
