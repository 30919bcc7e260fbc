// Several games in one session file, one after the other.
#include "app/journal/session_games.h"

#include <gtest/gtest.h>

#include <SQLiteCpp/SQLiteCpp.h>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/journal/journal.h"
#include "app/journal/session_file.h"
#include "app/journal_frames.h"
#include "app/temporary_folder.h"
#include "log_lines.h"

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

/// What is said of a session file of two games after a change to it.
std::string saidAfter(const std::filesystem::path& file, const std::string& change) {
  SQLite::Database(file.string(), SQLite::OPEN_READWRITE).exec(change);
  try {
    SessionFile session(file);
    return session.games().front().startedUtc;
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(AlteredSession, IsRefusedOrCleanedBeforeAnybodyPlaysIt) {
  const TemporaryFolder folder;
  const auto file = folder / "game.db", altered = folder / "altered.db";
  play(file, 1, 0, 3);
  play(file, 2, 4, 6);
  const std::vector<std::pair<const char*, const char*>> changes{
      {"UPDATE game SET light_speed_m_s = 0", "light_speed_m_s is 0, expected a number above 0 up to 1e+09"},
      {"UPDATE game SET light_speed_m_s = 1e-320", "light_speed_m_s is "},
      {"UPDATE game SET light_speed_m_s = 1e300", "light_speed_m_s is 1e+300, expected"},
      {"UPDATE game SET light_speed_m_s = 'fast'", "light_speed_m_s is 0, expected"},
      {"UPDATE session SET value = 0 WHERE key = 'light_speed_m_s'", "light_speed_m_s is 0, expected"},
      {"CREATE VIEW endless AS SELECT 1", "it has views or triggers"},
      {"CREATE TRIGGER more AFTER INSERT ON frame BEGIN SELECT 1; END", "it has views or triggers"},
      {"UPDATE game SET started_utc = '2026' || char(27) || '[31m' || char(10) || char(155)", "2026?[31m??"}};
  for (const auto& [change, said] : changes) {
    std::filesystem::copy_file(file, altered, std::filesystem::copy_options::overwrite_existing);
    const std::string what = saidAfter(altered, change);
    EXPECT_NE(what.find(said), std::string::npos) << change << ": " << what;
  }
}

TEST(AlteredSession, HasTheLightSpeedOfItsScenario) {
  const TemporaryFolder folder;
  const auto file = folder / "game.db";
  SessionFacts facts = factsOf(1);
  facts.scenarioText = "light_speed_m_s = 1.42\n";
  { Journal(file, facts, false).add(frameOf(0), head(), {}); }
  EXPECT_EQ(SessionFile(file).scenario().billiard.lightSpeed_m_s, 1.42);
  SQLite::Database(file.string(), SQLite::OPEN_READWRITE).exec("UPDATE game SET light_speed_m_s = 2");
  try {
    SessionFile(file).scenario();
    FAIL() << "was taken";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("light_speed_m_s is 2, expected 1.42 as in its scenario"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace carom
