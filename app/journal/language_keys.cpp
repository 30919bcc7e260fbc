#include "app/journal/language_keys.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "app/journal/session_games.h"
#include "engine/text/printable.h"

namespace carom {
namespace {

std::string keyOf(std::size_t number) { return fmt::format("language_{}", number + 1); }

void put(SQLite::Database& database, const std::string& key, const std::string& value) {
  SQLite::Statement row(database, "INSERT OR REPLACE INTO session VALUES(?, ?)");
  row.bind(1, key);
  row.bind(2, value);
  row.exec();
}

/// Returns a language of the file, or nothing. A PO file may have gone since.
std::string languageIn(SQLite::Database& database, const std::string& key) {
  std::string language = printable(sessionValue(database, key));
  const bool isFile = isPoFile(language) && std::filesystem::path(language).is_absolute();
  const std::string refusal = language.empty() || isFile ? "" : refusalOfLanguage(language);
  if (!refusal.empty()) throw std::runtime_error(fmt::format("{}: {}", key, refusal));
  return language;
}

}  // namespace

void putFirstLanguages(SQLite::Database& database, const SessionLanguages& languages,
                       std::span<const std::string> viewers) {
  for (const auto& [key, language] : languagesByViewer(languages.all, languages.atStart, viewers))
    put(database, key, language);
}

void putLanguages(SQLite::Database& database, const SessionLanguages& languages) {
  if (languages.all.size() < 2) return;
  for (std::size_t i = 0; i < languages.all.size(); ++i) put(database, keyOf(i), languages.all[i]);
}

SessionLanguages languagesIn(SQLite::Database& database, std::span<const std::string> viewers) {
  SessionLanguages languages;
  languages.all.clear();
  for (std::size_t i = 0; i < kMostLanguages; ++i) {
    const std::string language = languageIn(database, keyOf(i));
    if (language.empty()) break;
    languages.all.push_back(language);
  }
  const std::string ofAll = languageIn(database, "language");
  for (std::size_t viewer = 0; viewer < std::min(viewers.size(), kMostViewers); ++viewer) {
    const std::string own = languageIn(database, fmt::format("language.{}", viewers[viewer]));
    languages.atStart[viewer] = numberOf(languages, !own.empty()     ? own
                                                    : !ofAll.empty() ? ofAll
                                                                     : std::string(kEnglish));
  }
  return languages;
}

}  // namespace carom
