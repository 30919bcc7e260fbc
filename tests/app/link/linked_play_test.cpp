// Two rooms of a linked game in one process, with a line in simulated time: joining, cuts, and games that
// differ.
#include "app/link/linked_play.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

#include "app/link/two_rooms.h"

namespace carom::test {
namespace {

TEST(LinkedPlay, TwoRoomsPlayOneGame) {
  for (const double late_s : {0.0, 0.1, 0.5}) {
    SCOPED_TRACE(late_s);
    Two two(late_s);
    two.play(30.0);
    EXPECT_GT(two.host.made, 5U);
    EXPECT_GT(two.joiner.made, 5U);
    EXPECT_TRUE(two.host.has("paired") && two.joiner.has("paired"));
    two.expectOneGame();
    EXPECT_EQ(two.joiner.invitations, 1);
  }
}

TEST(LinkedPlay, WhoJoinsLateKnowsTheWholeGame) {
  Two two(0.2);
  two.play(20.0, false);
  EXPECT_GT(two.host.made, 5U);
  EXPECT_EQ(two.host.play.state(), LinkState::alone);
  two.play(15.0);
  EXPECT_GT(two.joiner.board_s(), 30.0);
  two.expectOneGame();
}

TEST(LinkedPlay, AGameGoesOnAfterACut) {
  Two two(0.1);
  two.play(10.0);
  two.cut();
  two.play(2.0, false);
  EXPECT_EQ(two.host.play.state(), LinkState::playing);
  two.play(10.0);
  EXPECT_TRUE(two.host.has("back") && two.joiner.has("back"));
  EXPECT_EQ(two.joiner.invitations, 1);
  two.expectOneGame();
}

// Whose operator leaves the game plays alone, however often the other calls, until they let it play again.
TEST(LinkedPlay, WhoseOperatorLeavesPlaysAloneUntilTheyComeBack) {
  for (const bool isHost : {false, true}) {
    SCOPED_TRACE(isHost);
    Two two(0.1);
    two.play(10.0);
    Room& leaves = isHost ? two.host : two.joiner;
    const double then_s = two.host.board_s();
    leaves.play.stayOut(true);
    two.play(10.0);
    for (const Room* room : {&two.host, &two.joiner}) {
      EXPECT_EQ(room->play.state(), LinkState::alone);
      EXPECT_TRUE(room->has("gone"));
      EXPECT_GT(room->board_s(), then_s + 8.0) << "both play on";
    }
    EXPECT_EQ(two.joiner.invitations, 1);
    leaves.play.stayOut(false);
    two.play(10.0);
    EXPECT_EQ(two.joiner.invitations, 2);
    two.expectOneGame();
  }
}

TEST(LinkedPlay, WhoIsLeftAlonePlaysOn) {
  Two two(0.1);
  two.play(10.0);
  two.lines[1].isSilent = true;  // the joiner has died; the line is closed
  two.cut();
  for (int i = 0; i < 600; ++i) two.host.frame(two.now_s += kFrame_s);
  EXPECT_EQ(two.host.play.state(), LinkState::alone);
  EXPECT_TRUE(two.host.has("gone"));
  const double then_s = two.host.board_s();
  for (int i = 0; i < 60; ++i) two.host.frame(two.now_s += kFrame_s);
  EXPECT_NEAR(two.host.board_s(), then_s + 1.0, 0.3);
}

TEST(LinkedPlay, AGameThatIsComputedOtherwiseIsNamed) {
  Two two(0.1);
  two.play(5.0);
  two.lines[1].change = [](LinkMessage& message) {
    if (auto* digest = std::get_if<LinkDigest>(&message); digest && digest->second == 9) ++digest->digest;
  };
  two.play(10.0);
  EXPECT_TRUE(std::ranges::any_of(two.host.notes, [](const LinkNote& note) {
    return note.what == "mismatch" && note.value.find("board second 8") != std::string::npos;
  }));
  EXPECT_NE(two.host.play.state(), LinkState::playing);
}

// One bit of one turn, as another compiler might compute it: in the game of the joiner, before it is told.
TEST(LinkedPlay, TheFirstTurnThatDiffersIsNamedByBothRooms) {
  Two two(0.1);
  two.play(2.0);
  two.joiner.bend = 4.0;
  two.play(20.0);
  const double bent_s = two.joiner.bent_s;
  ASSERT_GT(bent_s, 0.0);
  const std::string words =
      fmt::format("the games differ in board second {:.0f}, first in turn ", std::floor(bent_s));
  const std::string at = fmt::format(" of {} at {:.6f} s", two.joiner.bentName, bent_s);
  for (const Room* room : {&two.host, &two.joiner}) {
    EXPECT_TRUE(std::ranges::any_of(room->notes,
                                    [&](const LinkNote& note) {
                                      return note.what == "mismatch" &&
                                             note.value.find(words) != std::string::npos &&
                                             note.value.find(at) != std::string::npos;
                                    }))
        << words << at << (room->notes.empty() ? "" : room->notes.back().value);
    EXPECT_EQ(room->play.state(), LinkState::alone);
    EXPECT_FALSE(room->has("resynchronised"));
  }
}

// A stroke that one room keeps for itself: the game of who has joined is built anew from the host's.
TEST(LinkedPlay, AGameThatLacksAStrokeIsBuiltAnew) {
  for (const std::size_t keeper : {0U, 1U}) {
    SCOPED_TRACE(keeper);
    Two two(0.1);
    two.play(6.0);
    bool isKept = false;
    two.lines[keeper].change = [&](LinkMessage& message) {
      if (two.host.has("resynchronised")) return;
      if (auto* present = std::get_if<LinkPresent>(&message)) present->present.strokes -= isKept ? 1 : 0;
      if (!std::holds_alternative<LinkStroke>(message) || isKept) return;
      message = LinkPing{};
      isKept = true;
      two.host.strikes = two.joiner.strikes = false;
    };
    two.play(8.0);
    ASSERT_TRUE(isKept);
    EXPECT_TRUE(two.host.has("resynchronised") && two.joiner.has("resynchronised"));
    EXPECT_TRUE(two.host.has("mismatch"));
    EXPECT_EQ(two.joiner.invitations, 2);
    two.lines[keeper].change = {};
    two.host.strikes = two.joiner.strikes = true;
    two.play(10.0);
    two.expectOneGame();
  }
}

TEST(LinkedPlay, TheNextGameOfTheHostComesToBoth) {
  Two two(0.1);
  two.play(5.0);
  LinkedGame game;
  game.scenario = "another";
  game.billiard = table();
  game.start = place();
  two.host.observers.reset();
  two.host.game.emplace(table());
  two.host.play.play(game);
  two.play(10.0);
  EXPECT_EQ(two.joiner.invitations, 2);
  two.expectOneGame();
}

}  // namespace
}  // namespace carom::test
