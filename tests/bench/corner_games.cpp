// Random games of discs and bodies with corners until there have been so many collisions: what must be true
// of them.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "engine/corner_games.h"

namespace {

using namespace carom;
using namespace carom::test;

constexpr double kUntil_s = 6.0;

/// The game in the reverse order of the file, played in steps: its bits.
void checkOrder(const BilliardSetup& setup, const std::string& name, CornerTally& tally) {
  BilliardSetup other = setup;
  std::reverse(other.pucks.begin(), other.pucks.end());
  Billiard game(setup), again(other);
  game.advanceTo(kUntil_s);
  for (double t_s = 0.25; t_s <= kUntil_s; t_s += 0.25) again.advanceTo(t_s);
  const std::string differs = otherBits(game, again, kUntil_s);
  if (!differs.empty()) tally.faults.push_back(name + ": other bits in the reverse order: " + differs);
}

void checkMirrors(const BilliardSetup& setup, const std::string& name, CornerTally& tally) {
  Billiard game(setup);
  game.advanceTo(kUntil_s);
  for (const Vec2 signs : {Vec2{1.0, -1.0}, Vec2{-1.0, 1.0}}) {
    Billiard image(mirrored(setup, signs));
    image.advanceTo(kUntil_s);
    if (eventDigits(game, {1.0, 1.0}) != eventDigits(image, signs))
      tally.faults.push_back(name + ": other bits in a mirror");
  }
}

}  // namespace

int main(int count, char** words) {
  const std::size_t wanted = count > 1 ? std::strtoull(words[1], nullptr, 10) : 100'000;
  unsigned seed = count > 2 ? static_cast<unsigned>(std::strtoul(words[2], nullptr, 10)) : 1;
  CornerTally tally;
  std::size_t games = 0, reported = 0;
  for (; tally.collisions < wanted; ++seed, ++games) {
    const BilliardSetup setup = cornerGame(seed);
    const std::string name = "seed " + std::to_string(seed);
    checkCornerGame(setup, kUntil_s, name, tally);
    if (games % 10 == 0) checkOrder(setup, name, tally), checkMirrors(setup, name, tally);
    for (; reported < tally.faults.size(); ++reported) std::printf("%s\n", tally.faults[reported].c_str());
    std::fflush(stdout);
  }
  std::printf(
      "%zu games, %zu collisions, of which %zu without delay, and %zu turns in jams. Missing of the energy "
      "at most "
      "%.1e, of momentum %.1e. Of %zu pairs that touched when both had turned, %zu of which had not parted "
      "since they "
      "met, %zu went on, the fastest at %.2g c.\n",
      games, tally.collisions, tally.withoutDelay, tally.jams, tally.worstEnergy, tally.worstMomentum,
      tally.touching, tally.inEachOther, tally.approaching, tally.fastestApproach);
  return tally.faults.empty() && tally.approaching == 0 ? 0 : 1;
}
