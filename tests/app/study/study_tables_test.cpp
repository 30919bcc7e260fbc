// The tables of a study in a session file: rows are read as they were written, and belong to one study.
#include "app/study/study_tables.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "app/journal/session_games.h"
#include "app/study/study_visit.h"
#include "app/temporary_folder.h"

namespace carom {
namespace {

using test::StudyVisit;
using test::TemporaryFolder;

TEST(StudyRun, AStudyThatWasChangedAfterTheFirstParticipantIsRefusedUnlessAmended) {
  StudyVisit run;
  const std::string before = run.run_->study().sha256;
  run.enter(run.codes_[0]);
  run.send("go=next&part=yes");
  std::ofstream(run.study_, std::ios::app) << "# another one\n";
  EXPECT_THROW(run.open(), std::runtime_error);
  run.open(true);
  EXPECT_EQ(sessionValue(run.tables_->database(), "study_sha256_before"), before);
  EXPECT_EQ(sessionValue(run.tables_->database(), "study_sha256"), run.run_->study().sha256);
  EXPECT_NE(before, run.run_->study().sha256);
}

/// A session file with the tables that a journal makes, and two games.
std::filesystem::path madeSession(const TemporaryFolder& folder) {
  const auto file = folder / "day.db";
  SQLite::Database made(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  made.exec(
      "CREATE TABLE session(key TEXT PRIMARY KEY, value); CREATE TABLE game(first_frame INTEGER); "
      "INSERT INTO game VALUES(0); INSERT INTO game VALUES(700)");
  return file;
}

Study aStudy() {
  Study study;
  study.title = "T";
  study.text = "title = \"T\"";
  study.sha256 = "abc";
  return study;
}

ParticipantRow aParticipant(const std::string& code, std::size_t number) {
  return {code, "walks", number, 3, "BCA", "take-part paths", "1234", "2026-11-23", 4, 2, ""};
}

TEST(StudyTables, RowsAreReadAsTheyWereWritten) {
  const TemporaryFolder folder;
  const auto file = madeSession(folder);
  {
    SQLite::Database bare(file.string());
    EXPECT_FALSE(hasStudy(bare));
  }
  StudyTables tables(file, aStudy(), false);
  SQLite::Database& database = tables.database();
  EXPECT_TRUE(hasStudy(database));
  tables.write(aParticipant("SECOND", 2));
  tables.write(aParticipant("FIRST", 1));
  ParticipantRow changed = aParticipant("SECOND", 2);
  changed.excluded = "stopped";
  tables.write(changed);
  const auto people = participantsIn(database);
  ASSERT_EQ(people.size(), 2U);
  EXPECT_EQ(people[0].code, "FIRST") << "by their numbers";
  const ParticipantRow& second = people[1];
  EXPECT_EQ(second.code + second.arm + second.forms + second.consent + second.consentVersion +
                second.startedUtc + second.excluded,
            "SECONDwalksBCAtake-part paths12342026-11-23stopped");
  EXPECT_EQ(second.number, 2U);
  EXPECT_EQ(second.orderRow, 3U);
  EXPECT_EQ(second.step, 4);
  EXPECT_EQ(second.lesson, 2U);
  EXPECT_TRUE(second.allows("paths") && second.allows("take-part"));
  EXPECT_FALSE(second.allows("path") || second.allows("publish"));
  tables.beginLesson("FIRST", "twins", 2);
  const auto lessons = participationsIn(database);
  ASSERT_EQ(lessons.size(), 1U);
  EXPECT_EQ(lessons[0].code + lessons[0].lesson, "FIRSTtwins");
  EXPECT_EQ(lessons[0].position, 2U);
  EXPECT_EQ(lessons[0].firstFrame, 700) << "the newest game";
}

TEST(StudyTables, ALaterAnswerTakesThePlaceOfTheEarlierOneAndBothChangesStay) {
  const TemporaryFolder folder;
  StudyTables tables(madeSession(folder), aStudy(), false);
  SQLite::Database& database = tables.database();
  tables.write("A", {"pre", "B", "late", "a", 2, 10.5, 0, "", 1.25}, true);
  tables.write("A", {"pre", "B", "now", "", 0, 3.0, 0, "", 2.0}, false);
  tables.write("A", {"pre", "B", "late", "dont-know", 0, 12.5, 1, "Because", 3.5}, true);
  tables.write("B", {"pre", "C", "late", "b", 4, 1.0, 0, "", 4.0}, true);
  const auto rows = responsesOf(database, "A");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].phase + rows[0].form + rows[0].item + rows[0].answer + rows[0].reason,
            "preBlatedont-knowBecause");
  EXPECT_EQ(rows[0].confidence, 0);
  EXPECT_EQ(rows[0].changes, 1);
  EXPECT_EQ(rows[0].seconds, 12.5);
  EXPECT_EQ(rows[0].t_s, 3.5);
  EXPECT_EQ(rows[1].item, "now");
  const auto count = [&](const std::string& from) {
    return database.execAndGet("SELECT count(*) FROM " + from).getInt();
  };
  EXPECT_EQ(count("response_change WHERE code = 'A'"), 2);
  EXPECT_EQ(count("response WHERE confidence IS NULL"), 2) << "no confidence is none, not 0";
  tables.write(aParticipant("A", 1));
  tables.write(aParticipant("B", 2));
  tables.forget("A");
  for (const char* table : kStudyTables)
    EXPECT_EQ(count(std::string(table) + " WHERE code = 'A'"), 0) << table;
  EXPECT_EQ(responsesOf(database, "B").size(), 1U);
  EXPECT_EQ(participantsIn(database).size(), 1U);
}

TEST(StudyTables, OneSessionHasThemAtATime) {
  const TemporaryFolder folder;
  const auto file = madeSession(folder);
  {
    const StudyTables first(file, aStudy(), false);
    EXPECT_THROW(StudyTables(file, aStudy(), false), std::runtime_error);
  }
  EXPECT_NO_THROW(StudyTables(file, aStudy(), false));
  EXPECT_FALSE(std::filesystem::exists(file.string() + "-study")) << "the lock has gone with the session";
}

}  // namespace
}  // namespace carom
