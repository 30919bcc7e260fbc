// What rooms of a linked game do with news from the line: invitations, silence, refusals, settings.
#include <gtest/gtest.h>

#include "app/link/linked_play.h"
#include "app/link/two_rooms.h"

namespace carom::test {
namespace {

TEST(LinkedPlay, WhoIsSilentIsGoneAndJoinsANewGame) {
  Two two(0.1);
  two.play(10.0);
  for (FakeLine& line : two.lines) line.isSilent = true;
  two.play(12.0);
  EXPECT_TRUE(two.host.has("gone") && two.joiner.has("gone"));
  EXPECT_EQ(two.host.play.state(), LinkState::alone);
  const double alone_s = two.host.board_s();
  for (FakeLine& line : two.lines) line.isSilent = false;
  two.cut();
  two.play(10.0);
  EXPECT_GT(two.host.board_s(), alone_s);
  EXPECT_EQ(two.joiner.invitations, 2);
  two.expectOneGame();
}

// A computer that sleeps for an hour: its clock stands with it, or goes on. When it wakes it joins a new
// game, or lets the other join one.
TEST(LinkedPlay, WhoSleepsForAnHourIsGoneAndPlaysANewGameWhenItWakes) {
  for (const bool isHost : {false, true}) {
    for (const bool isClockAsleep : {false, true}) {
      SCOPED_TRACE((isHost ? "the host sleeps" : "who has joined sleeps") +
                   std::string(isClockAsleep ? ", and its clock" : ""));
      Two two(0.1);
      two.play(10.0);
      Room& awake = isHost ? two.joiner : two.host;
      Room& asleep = isHost ? two.host : two.joiner;
      for (FakeLine& line : two.lines) line.isSilent = true;
      for (int second = 0; second < 3600; ++second) {
        two.now_s += 1.0;
        for (FakeLine& line : two.lines) line.look();
        awake.frame(two.now_s);
      }
      EXPECT_TRUE(awake.has("gone"));
      EXPECT_EQ(awake.play.state(), LinkState::alone);
      EXPECT_EQ(asleep.play.state(), LinkState::playing) << "it knows of nothing yet";
      const double then_s = awake.board_s();
      EXPECT_GT(then_s, 40.0) << "who is awake plays on";
      for (FakeLine& line : two.lines) line.isSilent = false;
      asleep.clockLate_s = two.lines[isHost ? 0 : 1].clockLate_s = isClockAsleep ? 3600 : 0;
      asleep.frame(two.now_s);
      two.cut();  // as a line does that nobody has served for an hour
      two.play(15.0);
      EXPECT_TRUE(isHost || two.host.board_s() > then_s);
      EXPECT_EQ(two.joiner.invitations, 2);
      EXPECT_EQ(two.host.notes.back().what, "paired") << two.host.notes.back().value;
      two.expectOneGame();
    }
  }
}

std::string refusal(Two& two) {
  two.play(3.0, true);
  for (const LinkNote& note : two.host.notes)
    if (note.what == "refused") return note.value;
  return {};
}

TEST(LinkedPlay, RefusesWhoDoesNotFit) {
  Two twin(0.1, "grenoble");
  EXPECT_NE(refusal(twin).find("both rooms are named grenoble"), std::string::npos) << refusal(twin);
  Two other(0.1, "lyon", 8);
  EXPECT_NE(refusal(other).find("the arithmetic differs"), std::string::npos);
  EXPECT_NE(refusal(other).find("0000000000000008"), std::string::npos);
  for (Two* two : {&twin, &other}) EXPECT_EQ(two->joiner.invitations, 0);
}

TEST(LinkedPlay, RefusesAThirdRoomAndASecondOfOneName) {
  for (const char* name : {"annecy", "lyon"}) {
    Two two(0.1);
    two.play(5.0);
    LinkHello hello;
    hello.arithmetic = 7;
    hello.room = name;
    hello.viewers = {"viewer"};
    two.lines[0].tell(77, hello);
    two.play(2.0);
    const bool isSaid = std::ranges::any_of(two.host.notes, [&](const LinkNote& note) {
      return note.what == "refused" &&
             note.value.find(std::string(name) == "lyon" ? "a room named lyon plays already"
                                                         : "two rooms play already") != std::string::npos;
    });
    EXPECT_TRUE(isSaid) << name;
  }
}

// A stroke from before its promise is void, and who told it is not let in again in this game.
TEST(LinkedPlay, WhoBreaksAPromiseIsRefused) {
  Two two(0.1);
  two.play(5.0);
  two.lines[1].change = [](LinkMessage& message) {
    if (auto* stroke = std::get_if<LinkStroke>(&message)) stroke->told.stroke.at_s -= 5.0;
  };
  const std::size_t heard = two.host.fromAfar;
  two.play(10.0);
  EXPECT_EQ(two.host.fromAfar, heard);
  EXPECT_TRUE(std::ranges::any_of(two.host.notes, [](const LinkNote& note) {
    return note.what == "refused" &&
           note.value.find("it broke a promise, or stood still too often, in this game") != std::string::npos;
  }));
  EXPECT_EQ(two.host.play.state(), LinkState::alone);
  EXPECT_EQ(two.joiner.play.state(), LinkState::alone);
}

TEST(LinkedPlay, WhoStrikesAsNobodyCanIsRefused) {
  Two two(0.1);
  two.host.strikes = two.joiner.strikes = false;
  two.play(5.0);
  for (int i = 0; i < 20; ++i) two.joiner.strikeNow();
  two.play(1.0);
  EXPECT_EQ(two.host.fromAfar, 20U);
  EXPECT_FALSE(two.host.has("refused"));
  two.joiner.strikeNow();
  two.play(1.0);
  const bool isSaid = std::ranges::any_of(two.host.notes, [](const LinkNote& note) {
    return note.what == "refused" && note.value.find("more than 20 times a second") != std::string::npos;
  });
  EXPECT_TRUE(isSaid || two.host.fromAfar == 21U);
  for (int i = 0; i < 30; ++i) two.joiner.strikeNow();
  two.play(1.0);
  EXPECT_LE(two.host.fromAfar, 41U);
  EXPECT_TRUE(two.host.has("refused"));
}

// Who tells the same moment again and again stops the other for a while, three times in a game at most.
TEST(LinkedPlay, WhoseTimeStandsStillIsGoneAndAfterThreeTimesNotLetInAgain) {
  Two two(0.1);
  std::optional<LinkPresent> stands;
  two.lines[1].change = [&](LinkMessage& message) {
    auto* present = std::get_if<LinkPresent>(&message);
    if (!present) return;
    if (two.host.play.state() != LinkState::playing) return stands.reset();
    if (!stands) stands = *present;
    stands->present.number = present->present.number;
    stands->present.strokes = present->present.strokes;
    *present = *stands;
  };
  two.joiner.strikes = false;
  const auto gone = [&] {
    return std::ranges::count_if(two.host.notes, [](const LinkNote& note) {
      return note.what == "gone" && note.value.find("its time stood still for 12 s") != std::string::npos;
    });
  };
  for (int i = 0; i < 120 && !two.host.has("refused"); ++i) two.play(1.0);
  EXPECT_EQ(gone(), 3) << (two.host.notes.empty() ? ""
                                                  : two.host.notes.back().what + two.host.notes.back().value);
  EXPECT_TRUE(std::ranges::any_of(two.host.notes, [](const LinkNote& note) {
    return note.what == "refused" && note.value.find("stood still too often") != std::string::npos;
  }));
  EXPECT_EQ(two.host.play.state(), LinkState::alone);
}

TEST(LinkedPlay, ATimeFarFromOursIsRefused) {
  Two two(0.1);
  two.play(5.0);
  two.lines[1].change = [](LinkMessage& message) {
    auto* present = std::get_if<LinkPresent>(&message);
    if (!present) return;
    for (PersonTold& person : present->present.persons)
      for (Event* event : {&person.promise, &person.head, &person.hand}) event->t_s += 3700.0;
  };
  two.play(1.0);
  EXPECT_TRUE(std::ranges::any_of(two.host.notes, [](const LinkNote& note) {
    return note.what == "refused" && note.value.find("within an hour") != std::string::npos;
  }));
}

TEST(LinkedPlay, MessagesOfBeforeChangeNothing) {
  Random random(9);
  Two two(0.1);
  for (FakeLine& line : two.lines) line.repeats = &random;
  two.play(20.0);
  EXPECT_GT(two.lines[0].repeated, 10000U);
  EXPECT_GT(two.lines[1].repeated, 10000U);
  EXPECT_FALSE(two.host.has("refused") || two.host.has("mismatch") || two.joiner.has("resynchronised"));
  EXPECT_EQ(two.joiner.invitations, 1);
  two.expectOneGame();
}

TEST(LinkedPlay, SpeedOfLightAndStillnessAreForBoth) {
  Two two(0.1);
  two.play(5.0);
  two.joiner.c_m_s = 2.0;
  two.play(2.0);
  EXPECT_EQ(two.host.c_m_s, 2.0);
  two.host.isFrozen = true;
  two.play(10.0);
  EXPECT_TRUE(two.joiner.isFrozen);
  EXPECT_EQ(two.host.play.state(), LinkState::playing) << "stillness is not silence";
  two.joiner.isFrozen = false;
  two.play(3.0);
  EXPECT_FALSE(two.host.isFrozen);
  two.expectOneGame();
}

TEST(LinkedPlay, RoomsStandAsFarApartAsTheLineNeeds) {
  Two near(0.02), far(1.0);
  near.play(5.0);
  far.play(20.0);
  EXPECT_EQ(near.joiner.play.apart_m(), 0.0);
  // c · 2 s / 0.6 = 4.73 m between the floors, of which 2.6 m are there: 4.6 m between the places less 1 m
  // each.
  EXPECT_NEAR(far.joiner.play.apart_m(), 2.0 * (1.42 * 2.0 / 0.6 - 2.6), 0.11);
  EXPECT_LT(static_cast<double>(far.host.waits + far.joiner.waits), 0.01 * 2.0 * 20.0 * 60.0);
}

}  // namespace
}  // namespace carom::test
