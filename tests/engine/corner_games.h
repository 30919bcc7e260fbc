#pragma once
// Games of discs and bodies with corners drawn at random, and what must be true of them.

#include <cstddef>
#include <string>
#include <vector>

#include "engine/billiard/billiard.h"

namespace carom::test {

/// Returns a rectangle around the centre.
std::vector<Vec2> rectangle(double length_m, double width_m);
/// Returns a puck with these corners; without any, a disc of which the radius is missing.
Puck bodyOf(const std::string& name, const std::vector<Vec2>& outline_m);

/// Returns a game of up to `most` discs, bars, regular polygons and U shapes on a table: with spins up to the
/// speed of light at the rim, up to 0.95 c, masses 1 : 100, with and without friction, elastic and not, both
/// conventions.
BilliardSetup cornerGame(unsigned seed, int most = 13);
/// Returns the game as a mirror along an axis shows it: one of the signs, of x and y, is −1.
BilliardSetup mirrored(const BilliardSetup& setup, const Vec2& signs);

/// Returns all numbers of a game's events, as a mirror with these signs shows them.
std::vector<double> eventDigits(const Billiard& game, const Vec2& signs);

struct CornerTally {
  std::size_t collisions = 0, jams = 0, withoutDelay = 0;
  std::size_t touching = 0;  ///< pairs that touch or overlap when both have turned
  /// Of these, those that have not parted since they met: light told them when they were in each other.
  std::size_t inEachOther = 0;
  /// Pairs that go on approaching, above 1e-6, for longer than light needs to tell their centres: they go
  /// deeper, and the law of the kick would push them apart.
  std::size_t approaching = 0;
  double fastestApproach = 0.0;                   ///< of them, over c
  double worstEnergy = 0.0, worstMomentum = 0.0;  ///< that is missing, over the energy at the start
  std::vector<std::string> faults;                ///< in words, with the seed
};

/// Plays a game and adds what it finds: four-momentum with heat to 1e-10, no heat below 0, every centre on
/// the table, and what pairs in contact do in the frame of their equal speeds once both have turned.
void checkCornerGame(const BilliardSetup& setup, double until_s, const std::string& name, CornerTally& tally);

/// Returns what differs between two games that should have the same bits in another order of pucks; empty if
/// nothing.
std::string otherBits(const Billiard& game, const Billiard& reversed, double until_s);

}  // namespace carom::test
