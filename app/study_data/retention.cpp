#include "app/study_data/retention.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <system_error>

#include "app/journal/session_facts.h"
#include "app/journal/session_games.h"
#include "app/study/study_tables.h"
#include "engine/text/outside_file.h"
#include "engine/text/printable.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 1000;  // of a folder that are looked into

std::string overdueIn(const fs::path& file, std::chrono::year_month_day today) try {
  if (!refusalOf(file, InputKind::session).empty()) return {};
  constexpr int kBusy_ms = 200;
  SQLite::Database session(file.string(), SQLite::OPEN_READONLY, kBusy_ms);
  // A view or a trigger in the place of a table could compute without end.
  const bool hasTablesAlone =
      session.execAndGet("SELECT count(*) FROM sqlite_schema WHERE type IN ('view', 'trigger')").getInt() ==
      0;
  if (!hasTablesAlone || session.execAndGet("PRAGMA application_id").getInt() != kJournalId ||
      !hasStudy(session))
    return {};
  return overdueWords(keptStudy(sessionValue(session, "study"), sessionValue(session, "study_items")), today);
} catch (const std::exception&) {
  return {};  // the commands that read it tell its faults
}

}  // namespace

std::string overdueWords(const Study& study, std::chrono::year_month_day today) {
  if (!study.keepUntil || std::chrono::sys_days(today) <= std::chrono::sys_days(*study.keepUntil)) return {};
  const std::chrono::year_month_day& until = *study.keepUntil;
  return fmt::format(
      "the data of the study '{}' were to be kept until {:04}-{:02}-{:02}, expected that its session files, "
      "exports and copies are deleted",
      printable(study.title), static_cast<int>(until.year()), static_cast<unsigned>(until.month()),
      static_cast<unsigned>(until.day()));
}

std::vector<std::string> overdueSessions(const fs::path& folder, std::chrono::year_month_day today) {
  std::vector<fs::path> files;
  std::error_code failed;
  for (fs::directory_iterator it(folder, failed), end; !failed && it != end && files.size() < kMostFiles;
       it.increment(failed)) {
    if (it->path().extension() == ".db") files.push_back(it->path());
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> all;
  for (const fs::path& file : files) {
    if (const std::string words = overdueIn(file, today); !words.empty())
      all.push_back(fmt::format("{}: {}", printable(file.filename().string()), words));
  }
  return all;
}

std::chrono::year_month_day todayUtc() {
  return std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now());
}

}  // namespace carom
