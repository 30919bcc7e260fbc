// The kinds of events, their names, and the turns of one event.
#include "engine/game/game_event.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <stdexcept>
#include <string>

namespace carom {
namespace {

TEST(GameEvent, EachKindHasANameOfItsOwnAndIsOfPucksOrOfACushionOrOfNeither) {
  std::set<std::string> names, ofPucks, ofCushions;
  for (int kind = 0; kind <= static_cast<int>(kLastEventKind); ++kind) {
    const auto event = static_cast<EventKind>(kind);
    const std::string name(nameOf(event));
    EXPECT_FALSE(name.empty()) << kind;
    EXPECT_TRUE(names.insert(name).second) << name;
    if (isOfPucks(event)) ofPucks.insert(name);
    if (isOfCushion(event)) ofCushions.insert(name);
  }
  EXPECT_EQ(ofPucks, (std::set<std::string>{"puck-puck", "soft-soft"}));
  EXPECT_EQ(ofCushions, (std::set<std::string>{"puck-cushion", "soft-cushion"}));
  EXPECT_EQ(nameOf(Cushion::plusX), "+x");
  EXPECT_EQ(nameOf(Cushion::minusY), "-y");
}

TEST(GameEvent, HasTwoTurnsAtMost) {
  Turns turns;
  EXPECT_TRUE(turns.empty());
  Turn turn;
  for (std::size_t puck = 5; puck < 7; ++puck) {
    turn.puck = puck;
    turns.push_back(turn);
  }
  EXPECT_EQ(turns.size(), 2U);
  EXPECT_EQ(turns.front().puck, 5U);
  std::size_t sum = 0;
  for (const Turn& one : turns) sum += one.puck;
  EXPECT_EQ(sum, 11U);
  EXPECT_THROW(turns.push_back(turn), std::out_of_range);
}

}  // namespace
}  // namespace carom
