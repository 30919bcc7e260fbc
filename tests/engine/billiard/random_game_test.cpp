// What must be true of every game, on games drawn at random from everything that can be played. For longer:
// the bench random_games_bench (tests/bench/README.md).

#include "engine/random_game.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "engine/game_invariants.h"
#include "sanitized.h"

namespace carom::test {
namespace {

constexpr std::uint64_t kGames =
    kSanitized ? 16 : 100;  // enough to meet with everything that is counted below
constexpr std::uint64_t kFirst = 1;
constexpr std::size_t kMostEvents = 120;
constexpr GameLimits kGameLimits{kMostEvents, 20};

// CAROM_GAME=SEED plays that one game.
TEST(RandomGames, keepEveryInvariant) {
  const char* one = std::getenv("CAROM_GAME");
  const std::uint64_t first = one ? std::strtoull(one, nullptr, 10) : kFirst, games = one ? 1 : kGames;
  Tally tally;
  for (std::uint64_t seed = first; seed < first + games; ++seed) {
    const RandomGame game = randomGame(seed, kGameLimits);
    for (const Violation& violation : violationsOf(game.setup, game.until_s, kMostEvents, tally)) {
      ADD_FAILURE() << "seed " << seed << " (" << game.kind << "), played until " << game.until_s
                    << " s: " << violation.kind << ": " << violation.what << "\n\n"
                    << scenarioText(game.setup) << "\nThis game alone: CAROM_GAME=" << seed
                    << " random_game_test";
      break;
    }
  }
  if (one) return;
  // They are games in which something happens.
  EXPECT_GT(tally["collisions"] + tally["bounces"], 20 * games);
  EXPECT_GT(tally["without delay"], games / 8);
}

}  // namespace
}  // namespace carom::test
