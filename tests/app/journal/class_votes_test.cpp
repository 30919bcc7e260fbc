// The votes of a class in a session file: kept once they have counted, also over a full disk, and read again.
#include <gtest/gtest.h>

#include <SQLiteCpp/SQLiteCpp.h>
#include <string>
#include <vector>

#include "app/journal/journal.h"
#include "app/journal/session_file.h"
#include "app/journal_frames.h"
#include "app/temporary_folder.h"
#include "log_lines.h"

namespace carom {
namespace {

using namespace test;

SessionFacts factsOfClass() {
  SessionFacts facts = kFacts;
  facts.hasClass = true;
  return facts;
}

const ClassVote kFirst{1, "Twins", "Who is older?", "00ff", "Who flew", 3, 7.25, "γ <b>"};
const ClassVote kSecond{2, "Twins", "Who is older?", "00ff", "At home", 0, 2.5, ""};

TEST(ClassVotes, AreKeptAndReadAgain) {
  const TemporaryFolder folder;
  const auto file = folder / "class.db";
  {
    Journal journal(file, factsOfClass(), false);
    for (const std::uint64_t number : {0, 1, 2, 3}) {
      if (number == 0) journal.addInput(number, "class", "idle");
      if (number == 1) journal.addVote(number, kFirst);
      if (number == 2) journal.addVote(number, kSecond);
      if (number == 3) journal.addInput(number, "class", "closed 2");
      journal.add(frameOf(number), head(), {});
    }
  }
  const SessionFile session(file);
  const std::vector<CountedVote> votes = session.votes();
  ASSERT_EQ(votes.size(), 2U);
  EXPECT_EQ(votes[0].vote, kFirst);
  EXPECT_EQ(votes[0].frame, 1U);
  EXPECT_EQ(votes[0].game, 0U);
  EXPECT_EQ(votes[1].vote, kSecond);
  const ClassLeft left = session.classLeft();
  EXPECT_EQ(left.phase, "closed");
  EXPECT_EQ(left.round, 2);
  EXPECT_EQ(left.tokens, (std::vector<std::string>{"00ff", "00ff"}));
  EXPECT_EQ(left.votes, (std::vector{kFirst, kSecond}));
  SQLite::Database database(file.string());
  EXPECT_EQ(column(database, "SELECT name FROM pragma_table_info('vote')"),
            (std::vector<std::string>{"frame", "round", "lesson", "question", "token", "answer", "confidence",
                                      "seconds", "reason"}));
  EXPECT_EQ(column(database, "SELECT typeof(confidence) FROM vote"),
            (std::vector<std::string>{"integer", "null"}));
}

TEST(ClassVotes, OfAnEarlierQuestionAreNotThoseOfTheOneAtHand) {
  const TemporaryFolder folder;
  const auto file = folder / "class.db";
  {
    Journal journal(file, factsOfClass(), false);
    journal.addVote(0, kFirst);
    journal.add(frameOf(0), head(), {});
    journal.addInput(1, "class", "idle");
    journal.addInput(1, "class", "vote 1");
    journal.add(frameOf(1), head(), {});
  }
  const ClassLeft left = SessionFile(file).classLeft();
  EXPECT_EQ(left.phase, "vote");
  EXPECT_EQ(left.round, 1);
  EXPECT_EQ(left.tokens, std::vector<std::string>{"00ff"});
  EXPECT_TRUE(left.votes.empty());
}

TEST(ClassVotes, HaveNoTableWithoutAClass) {
  const TemporaryFolder folder;
  const auto file = folder / "game.db";
  { Journal(file, kFacts, false).add(frameOf(0), head(), {}); }
  SQLite::Database database(file.string());
  EXPECT_FALSE(database.tableExists("vote"));
  EXPECT_TRUE(SessionFile(file).votes().empty());
  EXPECT_EQ(SessionFile(file).classLeft().phase, "");
  { Journal(file, factsOfClass(), true).addVote(1, kFirst); }
  EXPECT_EQ(SessionFile(file).votes().size(), 1U) << "a class that comes when the session goes on";
}

TEST(ClassVotes, WaitWhileTheDiskIsFull) {
  const TemporaryFolder folder;
  const auto file = folder / "class.db";
  { Journal(file, factsOfClass(), false).add(frameOf(0), head(), {}); }
  SQLite::Database other(file.string(), SQLite::OPEN_READWRITE, 2000);
  other.exec("CREATE TRIGGER full BEFORE INSERT ON vote BEGIN SELECT RAISE(ABORT, 'full'); END");
  const LogLines lines;
  {
    Journal journal(file, factsOfClass(), true);
    journal.addVote(1, kFirst);
    journal.add(frameOf(1), head(), {});
    lines.waitFor(1);
    other.exec("DROP TRIGGER full");
    lines.waitFor(2);
  }
  EXPECT_EQ(SessionFile(file).votes().size(), 1U);
}

}  // namespace
}  // namespace carom
