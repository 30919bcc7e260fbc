// The languages of a session in its file.
#include "app/journal/language_keys.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <map>
#include <stdexcept>

#include "app/journal/session_file.h"
#include "app/journal_frames.h"
#include "app/temporary_folder.h"

namespace carom {
namespace {

using namespace test;
using Keys = std::map<std::string, std::string>;

SessionFacts factsWith(const SessionLanguages& languages) {
  SessionFacts facts = kFacts;
  facts.viewers = {"anna", "ben"};
  facts.languages = languages;
  return facts;
}

/// Writes a session of no frames, or goes on with it.
void write(const std::filesystem::path& file, const SessionLanguages& languages, bool goesOn = false) {
  Journal(file, factsWith(languages), goesOn);
}

Keys keysOf(const std::filesystem::path& file) {
  SQLite::Database database(file.string());
  SQLite::Statement rows(database, "SELECT key, value FROM session WHERE key LIKE 'language%'");
  Keys keys;
  while (rows.executeStep()) keys[rows.getColumn(0).getString()] = rows.getColumn(1).getString();
  return keys;
}

TEST(LanguageKeys, TellWhoReadsWhichAndAreReadAgain) {
  const TemporaryFolder folder;
  const std::vector<std::pair<SessionLanguages, Keys>> cases{
      {{}, {{"language", "en"}}},
      {{{"fr"}, {}}, {{"language", "fr"}}},
      {{{"fr", "en"}, {1, 1}}, {{"language", "en"}, {"language_1", "fr"}, {"language_2", "en"}}},
      {{{"fr", "/words/my ja.po"}, {0, 1}},
       {{"language.anna", "fr"},
        {"language.ben", "/words/my ja.po"},
        {"language_1", "fr"},
        {"language_2", "/words/my ja.po"}}}};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    SCOPED_TRACE(i);
    const std::filesystem::path file = folder / (std::to_string(i) + ".db");
    write(file, cases[i].first);
    EXPECT_EQ(keysOf(file), cases[i].second);
    EXPECT_EQ(SessionFile(file).facts().languages, cases[i].first);
  }
}

TEST(LanguageKeys, ASessionThatGoesOnMayHaveMore) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "game.db";
  write(file, {{"fr"}, {}});
  write(file, {{"fr", "ja"}, {1, 1}}, true);
  EXPECT_EQ(keysOf(file), (Keys{{"language", "fr"}, {"language_1", "fr"}, {"language_2", "ja"}}));
  EXPECT_EQ(SessionFile(file).facts().languages, (SessionLanguages{{"fr", "ja"}, {}}));
}

TEST(LanguageKeys, ANameThatNoLanguageHasIsRefused) {
  const TemporaryFolder folder;
  for (const char* name : {"../fr", "words/mine.po", "/etc/passwd"}) {
    const std::filesystem::path file = folder / "game.db";
    write(file, {});
    SQLite::Database(file.string(), SQLite::OPEN_READWRITE)
        .exec(std::string("UPDATE session SET value = '") + name + "' WHERE key = 'language'");
    EXPECT_THROW(SessionFile{file}, std::runtime_error) << name;
    std::filesystem::remove(file);
  }
}

TEST(LanguageKeys, AFrameInALanguageThatTheSessionLacksIsRefused) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "game.db";
  {
    Journal journal(file, factsWith({{"fr", "en"}, {}}), false);
    FrameState state = frameOf(0);
    state.record.viewers[0].language = 2;
    journal.add(state, head(), {});
  }
  SessionFile session(file);
  FrameState state;
  EXPECT_THROW(session.next(state), std::runtime_error);
}

}  // namespace
}  // namespace carom
