// Several games in one session file, one after the other.
#include "app/journal/session_games.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "app/journal/journal.h"
#include "app/journal/session_file.h"
#include "journal_frames.h"
#include "log_lines.h"
#include "temporary_folder.h"

namespace carom {
namespace {

using namespace test;

const std::vector<Puck> kPucks{{"white", 0.03, 0.02, 0.2}, {"red", 0.03, 0.02, 0.2}};

/// The frame of a game that began with frame `first`: its events are numbered from 0.
FrameState frameOfGame(std::uint64_t first, std::uint64_t number) {
  FrameState state = frameOf(number - first);
  state.record.number = number;
  state.record.display_s = 0.1 * static_cast<double>(number);
  return state;
}

SessionFacts factsOf(int game) {
  SessionFacts facts = kFacts;
  facts.scenario = "game-" + std::to_string(game) + ".toml";
  facts.scenarioText = "title = \"" + std::to_string(game) + "\"\n";
  facts.pucks = {"white", "red"};
  facts.isAnotherGame = game > 1;
  return facts;
}

/// Writes frames `first` to `last` of a game, with a stroke in each.
void play(const std::filesystem::path& file, int game, std::uint64_t first, std::uint64_t last) {
  Journal journal(file, factsOf(game), game > 1);
  for (std::uint64_t number = first; number <= last; ++number) {
    const Stroke stroke{0, static_cast<double>(number), Vec3(0.0), {0.1, 0.1}};
    journal.add(frameOfGame(first, number), head(), {}, std::vector<HandStroke>{{stroke}});
  }
}

void expectGame(SessionFile& session, std::uint64_t first, std::uint64_t last) {
  ASSERT_TRUE(session.frames());
  EXPECT_EQ(*session.frames(), (std::pair{first, last}));
  FrameState state;
  for (std::uint64_t number = first; number <= last; ++number) {
    ASSERT_TRUE(session.next(state)) << number;
    EXPECT_TRUE(sameBits(state, frameOfGame(first, number))) << number;
  }
  EXPECT_FALSE(session.next(state));
  const std::vector<Stroke> strokes = session.strokes(kPucks);
  ASSERT_EQ(strokes.size(), last - first + 1);
  EXPECT_EQ(strokes.front().at_s, static_cast<double>(first));
  EXPECT_EQ(session.frameAt(0.1 * static_cast<double>(last) + 100.0), last);
}

class SessionGames : public testing::Test {
 protected:
  NothingIsLogged silence_;
  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_ / "day.db";
};

TEST_F(SessionGames, EachIsReadAloneAndTheNewestByDefault) {
  play(file_, 1, 0, 9);
  play(file_, 2, 25, 31);
  play(file_, 3, 32, 40);
  const std::pair<std::uint64_t, std::uint64_t> spans[]{{0, 9}, {25, 31}, {32, 40}};
  for (std::size_t game = 1; game <= 3; ++game) {
    SCOPED_TRACE(game);
    SessionFile session(file_, game);
    EXPECT_EQ(session.games().size(), 3u);
    EXPECT_EQ(session.facts().scenarioText, factsOf(static_cast<int>(game)).scenarioText);
    EXPECT_EQ(session.facts().scenario.filename(), factsOf(static_cast<int>(game)).scenario);
    expectGame(session, spans[game - 1].first, spans[game - 1].second);
    EXPECT_EQ(session.games()[game - 1].from_s, 0.1 * static_cast<double>(spans[game - 1].first));
    EXPECT_EQ(session.games()[game - 1].to_s, 0.1 * static_cast<double>(spans[game - 1].second));
  }
  EXPECT_EQ(SessionFile(file_).game(), 3u);
  EXPECT_THROW(SessionFile(file_, 0), std::runtime_error);
  EXPECT_THROW(SessionFile(file_, 4), std::runtime_error);
}

// Events are frameOf's: one in each fourth frame, from the first.
TEST_F(SessionGames, EventsOfAllAreListedWithNumbersOfTheirOwn) {
  play(file_, 1, 0, 9);
  play(file_, 2, 10, 14);
  SQLite::Database database(file_.string());
  EXPECT_EQ(column(database, "SELECT number FROM event ORDER BY number"), (Strings{"0", "1", "2", "3", "4"}));
  EXPECT_EQ(column(database, "SELECT DISTINCT event FROM turn ORDER BY event"),
            (Strings{"0", "1", "2", "3", "4"}));
  EXPECT_EQ(column(database, "SELECT first_frame || ' ' || first_event FROM game ORDER BY first_frame"),
            (Strings{"0 0", "10 3"}));
}

TEST_F(SessionGames, OneThatEndedBeforeItsFirstFrameIsNone) {
  play(file_, 1, 0, 9);
  { Journal(file_, factsOf(2), true); }
  {
    SessionFile session(file_);
    EXPECT_EQ(session.games().size(), 1u);
    expectGame(session, 0, 9);
  }
  play(file_, 3, 10, 14);
  SessionFile session(file_);
  EXPECT_EQ(session.games().size(), 2u);
  EXPECT_EQ(session.facts().scenarioText, factsOf(3).scenarioText);
  expectGame(session, 10, 14);
}

TEST_F(SessionGames, AReaderOfAGameDoesNotReadTheNextOne) {
  play(file_, 1, 0, 9);
  SessionFile session(file_);
  play(file_, 2, 10, 14);
  expectGame(session, 0, 9);
}

TEST_F(SessionGames, TheNewestGoesOn) {
  play(file_, 1, 0, 9);
  play(file_, 2, 10, 14);
  SessionFacts facts = factsOf(2);
  facts.isAnotherGame = false;
  { Journal(file_, facts, true).add(frameOfGame(10, 15), head(), {}); }
  SessionFile session(file_);
  EXPECT_EQ(session.games().size(), 2u);
  EXPECT_EQ(*session.frames(), (std::pair<std::uint64_t, std::uint64_t>(10, 15)));
}

}  // namespace
}  // namespace carom
