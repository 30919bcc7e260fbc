// Studies whose data are kept for too long are named.
#include "app/study_data/retention.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "app/journal/session_facts.h"
#include "app/study/study_tables.h"
#include "app/temporary_folder.h"

namespace carom {
namespace {

using test::TemporaryFolder;
using namespace std::chrono_literals;

std::string studyUntil(const std::string& day) {
  return "title = \"Old\"\nseed = 1\nparticipants = 4\nlessons = [\"twins\"]\n" +
         (day.empty() ? "" : "keep_until = " + day + "\n") + "[[arm]]\nname = \"a\"\nrig = \"desk\"\n";
}

/// A session file of a study.
void session(const TemporaryFolder& folder, const std::string& name, const std::string& until) {
  const std::filesystem::path study = folder.file(name + ".toml", studyUntil(until));
  {
    SQLite::Database made((folder / (name + ".db")).string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    made.exec("CREATE TABLE session(key TEXT PRIMARY KEY, value)");
    made.exec("PRAGMA application_id = " + std::to_string(kJournalId));
  }
  StudyTables(folder / (name + ".db"), readStudy(study), false);
}

TEST(Retention, IsOverFromTheDayAfter) {
  const TemporaryFolder folder;
  const Study study = readStudy(folder.file("study.toml", studyUntil("2026-02-28")));
  EXPECT_EQ(overdueWords(study, 2026y / 2 / 28), "");
  EXPECT_EQ(overdueWords(study, 2026y / 3 / 1),
            "the data of the study 'Old' were to be kept until 2026-02-28, expected that its session files, "
            "exports and copies are deleted");
  EXPECT_EQ(overdueWords(readStudy(folder.file("ever.toml", studyUntil(""))), 2999y / 1 / 1), "");
}

TEST(Retention, NamesTheSessionFilesOfAFolder) {
  const TemporaryFolder folder;
  session(folder, "monday", "2026-02-28");
  session(folder, "tuesday", "2026-03-05");
  session(folder, "ever", "");
  folder.file("text.db", "no database");
  std::filesystem::create_directory(folder / "folder.db");
  std::filesystem::create_symlink("nowhere", folder / "link.db");
  const std::vector<std::string> over = overdueSessions(folder / "", 2026y / 3 / 2);
  ASSERT_EQ(over.size(), 1U);
  EXPECT_EQ(over[0].substr(0, 32), "monday.db: the data of the study");
  EXPECT_EQ(overdueSessions(folder / "", 2026y / 2 / 1).size(), 0U);
  EXPECT_EQ(overdueSessions(folder / "", 2026y / 4 / 1).size(), 2U);
  EXPECT_EQ(overdueSessions(folder / "nowhere", 2026y / 4 / 1).size(), 0U);
}

}  // namespace
}  // namespace carom
