// Who withdraws is gone: no byte of the code stays, and what others did stays as it was.
#include "app/study_data/study_delete.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "app/journal/session_games.h"
#include "app/study/study_tables.h"
#include "app/temporary_folder.h"

namespace carom {
namespace {

using test::contentOf;
using test::TemporaryFolder;

const std::string kGone = "7KQ2MD", kStays = "5ABCDE";

/// A session of two participants, whose lessons are the games of frames 0 to 9 and of 10 to 19.
std::filesystem::path madeSession(const TemporaryFolder& folder) {
  const auto file = folder / "day.db";
  {
    SQLite::Database made(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    made.exec(
        "CREATE TABLE session(key TEXT PRIMARY KEY, value); CREATE TABLE game(first_frame, first_event);"
        "CREATE TABLE frame(number, display_s); CREATE TABLE viewer(frame, name); CREATE TABLE "
        "run(first_frame);"
        "CREATE TABLE event(number); CREATE TABLE turn(event); CREATE TABLE sample(time_s);"
        "INSERT INTO game VALUES(0, 0)");
    SQLite::Transaction all(made);
    for (int frame = 0; frame < 20; ++frame) {
      const std::string n = std::to_string(frame);
      made.exec("INSERT INTO frame VALUES(" + n + ", " + n + "); INSERT INTO viewer VALUES(" + n +
                ", 'guest'); INSERT INTO event VALUES(" + n + "); INSERT INTO turn VALUES(" + n +
                "); INSERT INTO sample VALUES(" + n + " - 0.25)");
    }
    all.commit();
  }
  Study study;
  study.sha256 = "abc";
  StudyTables tables(file, study, false);
  for (const std::string& code : {kGone, kStays}) {
    tables.write({code, "a", code == kGone ? 1U : 2U, 0, "ABC", "take-part", "1", "2026-11-23", 7, 2, ""});
    tables.write(code, {"pre", "A", "i", "a", 1, 1.0, 0, "because", 1.0}, true);
    tables.beginLesson(code, "twins", 1);
    if (code == kGone)
      tables.database().exec("INSERT INTO game VALUES(10, 10); INSERT INTO run VALUES(0), (10)");
  }
  return file;
}

std::string refusalOf(const std::filesystem::path& file) {
  try {
    deleteParticipant(kGone, file, "w");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(StudyDelete, RemovesThePersonTheirLessonsAndEveryByteOfTheirCode) {
  const TemporaryFolder folder;
  const auto file = madeSession(folder);
  ASSERT_NE(contentOf(file).find(kGone), std::string::npos);
  const StudyDeletion deleted = deleteParticipant(kGone, file, "0123456789abcdef");
  EXPECT_EQ(deleted.rows, 4U) << "one of each table";
  EXPECT_EQ(deleted.games, 1U);
  EXPECT_EQ(contentOf(file).find(kGone), std::string::npos);
  SQLite::Database session(file.string());
  const auto rowsOf = [&](const std::string& from) {
    return session.execAndGet("SELECT count(*) || ' ' || min(" + from).getString();
  };
  EXPECT_EQ(rowsOf("number) FROM frame"), "10 10");
  EXPECT_EQ(rowsOf("frame) FROM viewer"), "10 10");
  EXPECT_EQ(rowsOf("number) FROM event"), "10 10");
  EXPECT_EQ(rowsOf("event) FROM turn"), "10 10");
  EXPECT_EQ(rowsOf("time_s) FROM sample"), "10 9.75") << "taken for the frame after";
  EXPECT_EQ(rowsOf("first_frame) FROM game"), "1 10");
  EXPECT_EQ(rowsOf("first_frame) FROM run"), "1 10");
  ASSERT_EQ(participantsIn(session).size(), 1U);
  EXPECT_EQ(participantsIn(session)[0].code, kStays);
  EXPECT_EQ(responsesOf(session, kStays).size(), 1U);
  EXPECT_EQ(sessionValue(session, "study_withdrew"), "1");
  EXPECT_EQ(sessionValue(session, "study_withdrawals"), "0123456789abcdef");
}

TEST(StudyDelete, OfSomebodyWhoIsNotThereChangesNoCount) {
  const TemporaryFolder folder;
  const auto file = madeSession(folder);
  EXPECT_FALSE(deleteParticipant("9ZZZZZ", file, "w").any());
  SQLite::Database session(file.string());
  EXPECT_EQ(sessionValue(session, "study_withdrew"), "");
  EXPECT_EQ(participantsIn(session).size(), 2U);
}

TEST(StudyDelete, WaitsForTheEndOfTheSession) {
  const TemporaryFolder folder;
  const auto file = madeSession(folder);
  Study study;
  study.sha256 = "abc";
  {
    const StudyTables open(file, study, false);
    EXPECT_EQ(refusalOf(file),
              file.string() + ": a session with its study is open, expected that its session is over");
  }
  EXPECT_EQ(refusalOf(file), "");
  EXPECT_NE(refusalOf(folder.file("text.db", "no database")), "");
  EXPECT_NE(refusalOf(folder / "none.db"), "");
}

TEST(StudyDelete, AnExportLosesTheirRecordsTheirPathsAndReportsThatNameThem) {
  const TemporaryFolder folder;
  const auto data = folder / "data";
  std::filesystem::create_directories(data / ("sub-" + kGone) / "motion");
  std::filesystem::create_directories(data / ("sub-" + kStays) / "motion");
  folder.file("data/sub-" + kGone + "/motion/x.tsv", "0\t1\n");
  folder.file("data/sub-" + kStays + "/motion/x.tsv", "0\t1\n");
  folder.file("data/study.csv", "key,value\nwithdrew,2\nseed,5\n");
  folder.file("data/responses.csv", "participant,reason\n" + kGone + ",\"two\nlines\"\n" + kStays +
                                        ",\"also\ntwo\"\n" + kGone + ",\n");
  folder.file("data/report.html", "<p>" + kGone + "</p>");
  folder.file("data/results.csv", "test,p\ngain,0.5\n");
  const StudyDeletion deleted = deleteParticipant(kGone, data, "w");
  EXPECT_EQ(deleted.rows, 2U) << "a record may have several lines";
  EXPECT_EQ(deleted.files, 4U) << "the report, and a folder with its folder and its file";
  EXPECT_EQ(contentOf(data / "responses.csv"), "participant,reason\n" + kStays + ",\"also\ntwo\"\n");
  EXPECT_EQ(contentOf(data / "study.csv"), "key,value\nwithdrew,3\nseed,5\n");
  EXPECT_EQ(contentOf(data / "results.csv"), "test,p\ngain,0.5\n");
  EXPECT_FALSE(std::filesystem::exists(data / ("sub-" + kGone)));
  EXPECT_TRUE(std::filesystem::exists(data / ("sub-" + kStays) / "motion/x.tsv"));
  EXPECT_FALSE(std::filesystem::exists(data / "report.html"));
  EXPECT_FALSE(deleteParticipant(kGone, data, "w").any()) << "a second time there is nothing";
  EXPECT_EQ(contentOf(data / "study.csv"), "key,value\nwithdrew,3\nseed,5\n");
  EXPECT_EQ(
      refusalOf(folder / ""),
      (folder / "").string() + " has no study.csv, expected a folder that carom study export has written");
}

}  // namespace
}  // namespace carom
