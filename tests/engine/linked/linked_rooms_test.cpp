// Two rooms play one game over bad lines: nothing that anybody has seen changes, all that is seen of the
// others is known, and both games are the same to the bit.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "engine/game_digest.h"
#include "engine/linked/linked_game.h"

namespace carom::test {
namespace {

/// The long form, for tests/run --thorough, plays all delays and three times as many strokes.
bool isThorough() { return std::getenv("CAROM_LINKED") != nullptr; }

std::vector<double> someOf(std::vector<double> delays_s) {
  if (isThorough()) return delays_s;
  std::vector<double> some_s;
  for (std::size_t i = 1; i < delays_s.size(); i += 2) some_s.push_back(delays_s[i]);
  return some_s;
}

struct Result {
  LinkedCounts both;
  double waiting = 0.0;  ///< of the room that waits more
};

std::string words(const LinkedRules& rules) {
  const LineFaults& line = rules.line;
  return std::to_string(rules.apart_m) + " m apart, " + std::to_string(line.late_s) + " s ± " +
         std::to_string(line.jitter_s) + ", lost " + std::to_string(line.lost) +
         (line.isStream ? ", a stream" : ", datagrams") + ", seed " + std::to_string(rules.seed);
}

void expectTheSameGame(LinkedGame& game) {
  const std::uint64_t first = digestOf(game.room(0).game());
  EXPECT_EQ(digestOf(game.room(1).game()), first);
  EXPECT_EQ(digestOf(game.asKnownFromTheStart()), first);
}

/// Plays a game and expects the rule to hold in it.
Result playHolding(LinkedRules rules) {
  if (!isThorough()) rules.strokes /= 3;
  SCOPED_TRACE(words(rules));
  LinkedGame game(rules);
  game.play();
  Result result;
  for (std::size_t i : {0U, 1U}) {
    const LinkedCounts& counts = game.room(i).counts();
    EXPECT_EQ(counts.insideOthers, 0U) << "eyes inside a promise of the other room";
    EXPECT_EQ(counts.outsideOwn, 0U) << "acts outside the room's own promise";
    EXPECT_EQ(counts.unknown, 0U) << "sights of the other that are not known";
    EXPECT_EQ(counts.tooLate, 0U) << "strokes from afar whose light has reached an eye";
    EXPECT_EQ(counts.changed, 0U) << "sights that a stroke from afar has changed, of " << counts.looks;
    EXPECT_EQ(counts.broken, 0U);
    EXPECT_EQ(counts.refused, 0U);
    EXPECT_EQ(counts.fromAfar, game.room(1 - i).strokes());
    EXPECT_LE(counts.mostPace, kMostHurry);
    result.waiting = std::max(result.waiting, counts.waiting());
    result.both.strokes += counts.strokes;
    result.both.looks += counts.looks;
    result.both.withoutDelay += counts.withoutDelay;
    result.both.putOff += counts.putOff;
    result.both.nearest_m = std::min(result.both.nearest_m, counts.nearest_m);
    result.both.mostPutOff_s = std::max(result.both.mostPutOff_s, counts.mostPutOff_s);
  }
  expectTheSameGame(game);
  EXPECT_GE(result.both.strokes, rules.most_s < 400.0 ? 6U : rules.strokes);
  std::cout << words(rules) << ": waiting " << 100.0 * result.waiting << " %, put off " << result.both.putOff
            << " of " << result.both.strokes << " by " << result.both.mostPutOff_s << " s at most, looks "
            << result.both.looks << ", kicks without delay " << result.both.withoutDelay << ", nearest "
            << result.both.nearest_m << " m\n";
  return result;
}

TEST(LinkedRooms, NothingSeenChangesWhateverTheLineDoes) {
  for (const double late_s : someOf({0.0, 0.02, 0.1, 0.25, 0.5, 1.0, 2.0})) {
    LinkedRules rules;
    rules.line = {late_s, 0.1 * late_s, 0.0, true, 0.0};
    const Result result = playHolding(rules);
    EXPECT_GT(result.both.looks, 300U);
    EXPECT_LT(result.both.withoutDelay, 10U);
    if (late_s <= 0.1) {
      EXPECT_EQ(result.waiting, 0.0);
    }
    if (late_s == 0.25) {
      EXPECT_LE(result.waiting, 0.01);
    }
  }
}

TEST(LinkedRooms, NothingSeenChangesWhereMessagesAreLostRepeatedAndSwapped) {
  std::uint64_t seed = 11;
  for (const double late_s : someOf({0.02, 0.1, 0.25, 0.5, 1.0, 2.0})) {
    for (const bool isStream : {true, false}) {
      LinkedRules rules;
      rules.line = {late_s, 0.5 * late_s, 0.2, isStream, 0.1};
      rules.seed = seed++;
      rules.most_s = 200.0;  // a slow line waits
      playHolding(rules);
    }
  }
}

// Two people in each room, as near to those of the other as their walks bring them.
TEST(LinkedRooms, NothingSeenChangesWherePeopleComeNear) {
  for (const double late_s : someOf({0.02, 0.05, 0.1})) {
    for (const std::size_t viewers : {1U, 2U}) {
      LinkedRules rules;
      rules.apart_m = 1.3;
      rules.viewers = viewers;
      rules.line = {late_s, 0.1 * late_s, 0.0, true, 0.0};
      rules.seed = 30 + viewers;
      const Result result = playHolding(rules);
      EXPECT_LT(result.both.nearest_m, 0.5);
      EXPECT_GT(result.both.putOff, 3U);
    }
  }
}

TEST(LinkedRooms, NothingSeenChangesOnMovingPlatforms) {
  for (const double beta : {0.3, 0.5}) {
    LinkedRules rules;
    rules.beta = beta;
    rules.line = {0.25, 0.125, 0.1, false, 0.1};
    rules.strokes = 40;
    rules.most_s = 40.0;
    playHolding(rules);
  }
}

TEST(LinkedRooms, NothingSeenChangesUnderThrust) {
  for (const std::size_t viewers : {1U, 2U}) {
    LinkedRules rules;
    rules.thrust_m_s2 = 0.7;
    rules.viewers = viewers;
    rules.line = {0.1, 0.05, 0.1, true, 0.0};
    rules.seed = 40 + viewers;
    playHolding(rules);
  }
}

TEST(LinkedRooms, NothingSeenChangesForARoomThatJoinsLate) {
  for (const double late_s : someOf({0.02, 0.1, 0.5})) {
    LinkedRules rules;
    rules.joins_s = 60.0;
    rules.strokes = isThorough() ? 120 : 70;
    rules.line = {late_s, 0.1 * late_s, 0.0, true, 0.0};
    SCOPED_TRACE(words(rules));
    LinkedGame game(rules);
    game.play();
    EXPECT_TRUE(game.room(1).isLiving());
    EXPECT_GT(game.room(1).strokes(), 10U);
    for (std::size_t i : {0U, 1U}) {
      const LinkedCounts& counts = game.room(i).counts();
      EXPECT_EQ(counts.insideOthers + counts.outsideOwn + counts.unknown + counts.tooLate + counts.broken,
                0U);
      EXPECT_EQ(counts.refused, 0U);
    }
    expectTheSameGame(game);
  }
}

// A line of 1 s: the people walk 0.6 m around their places, which stand as far apart as seats.h says.
TEST(LinkedRooms, HardlyAnybodyWaitsAtTheDistanceOfTheLine) {
  LinkedRules rules;
  rules.line = {1.0, 0.1, 0.0, true, 0.0};
  rules.apart_m = 1.2 + distanceFor_m(2.0 * 1.1, kC_m_s);
  EXPECT_LE(playHolding(rules).waiting, 0.01);
}

// ---------------------------------------------------------------- each guard left out
LinkedCounts playWithout(Without guard, LinkedRules rules) {
  rules.without = guard;
  if (!isThorough()) rules.strokes /= 2;
  LinkedGame game(rules);
  game.play();
  LinkedCounts both = game.room(0).counts();
  const LinkedCounts& other = game.room(1).counts();
  both.tooLate += other.tooLate;
  both.changed += other.changed;
  both.unknown += other.unknown;
  both.insideOthers += other.insideOthers;
  both.outsideOwn += other.outsideOwn;
  both.broken += other.broken;
  return both;
}

LinkedRules slowLine() {
  LinkedRules rules;
  rules.line = {1.3, 0.1, 0.0, true, 0.0};
  return rules;
}

TEST(LinkedRooms, WithoutWaitingSeenThingsChange) {
  LinkedRules rules = slowLine();
  rules.line.late_s = 2.5;
  const LinkedCounts counts = playWithout(Without::waiting, rules);
  EXPECT_GT(counts.insideOthers, 0U);
  EXPECT_GT(counts.unknown, 0U);
  EXPECT_GT(counts.changed, 0U);
}

TEST(LinkedRooms, WithoutReachStrokesComeTooLate) {
  LinkedRules rules = slowLine();
  rules.isTrusting = true;
  const LinkedCounts counts = playWithout(Without::reach, rules);
  EXPECT_GT(counts.broken, 0U);
  EXPECT_GT(counts.tooLate, 0U);
}

// With hands that promise no reach every stroke is put off, and none is too late.
TEST(LinkedRooms, WithoutPuttingOffStrokesComeTooLate) {
  LinkedRules rules = slowLine();
  rules.reach_m = 0.0;
  EXPECT_GT(playHolding(rules).both.putOff, 25U);
  rules.isTrusting = true;
  const LinkedCounts counts = playWithout(Without::puttingOff, rules);
  EXPECT_GT(counts.broken, 0U);
  EXPECT_GT(counts.tooLate, 0U);
}

TEST(LinkedRooms, WithoutTheNumberOfStrokesAPromiseCountsTooSoon) {
  LinkedRules rules;
  rules.line = {0.5, 0.25, 0.5, false, 0.0};  // strokes come long after presents that knew them
  rules.isTrusting = true;
  const LinkedCounts counts = playWithout(Without::count, rules);
  EXPECT_GT(counts.broken, 0U);
  EXPECT_GT(counts.changed, 0U);
}

TEST(LinkedRooms, APromiseThatGoesBackwardsIsNoticed) {
  LinkedRules rules;
  rules.apart_m = 1.3;
  rules.line = {0.3, 0.0, 0.3, true,
                0.0};  // news come in bursts: a head is suddenly farther, and the reach longer
  const LinkedCounts counts = playWithout(Without::keptPromises, rules);
  EXPECT_GT(counts.outsideOwn, 0U);
  EXPECT_GT(counts.broken, 0U);
}

TEST(LinkedRooms, AHandDrawnBeyondThePromiseIsNoticed) {
  LinkedRules rules;
  rules.apart_m = 1.3;
  rules.line = {0.1, 0.0, 0.0, true, 0.0};
  const LinkedCounts counts = playWithout(Without::drawnHand, rules);
  EXPECT_GT(counts.outsideOwn, 0U);
  EXPECT_GT(counts.broken, 0U);
}

// The room that is told of it plays none of it: nothing that it has seen changes.
TEST(LinkedRooms, APeerThatBreaksAPromiseChangesNothingSeen) {
  for (const Without guard :
       {Without::reach, Without::puttingOff, Without::count, Without::keptPromises, Without::drawnHand}) {
    LinkedRules rules;
    rules.apart_m = 1.3;
    rules.seed = 31;
    rules.line = {0.1, 0.0, 0.3, guard != Without::count, 0.0};
    rules.most_s = 120.0;
    const LinkedCounts counts = playWithout(guard, rules);
    EXPECT_GT(counts.broken, 0U) << static_cast<int>(guard);
    EXPECT_EQ(counts.tooLate, 0U) << static_cast<int>(guard);
    EXPECT_EQ(counts.changed, 0U) << static_cast<int>(guard);
  }
}

TEST(LinkedRooms, AreTheSameEveryRun) {
  LinkedRules rules;
  rules.line = {0.25, 0.1, 0.2, false, 0.2};
  rules.strokes = 20;
  LinkedGame first(rules), second(rules);
  first.play();
  second.play();
  EXPECT_EQ(digestOf(first.room(0).game()), digestOf(second.room(0).game()));
  EXPECT_EQ(first.room(1).counts().looks, second.room(1).counts().looks);
}

}  // namespace
}  // namespace carom::test
