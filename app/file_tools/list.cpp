#include "app/file_tools/list.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "app/journal/session_file.h"
#include "app/languages/language_files.h"
#include "app/operator/visitor_choices.h"
#include "app/rig/rig.h"
#include "app/scenario/playlist.h"
#include "app/scenario/scenario.h"
#include "app/study/study.h"
#include "app/toml/config_folder.h"

namespace carom {
namespace {

constexpr std::size_t kBeginning = 1U << 20U;  // of a file whose kind is looked for

std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder, std::string_view extension) {
  std::vector<std::filesystem::path> files;
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failed)) {
    if (entry.path().extension() == extension && entry.is_regular_file(failed)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Returns the first fault of an exception as one line.
ListedFile faulty(const std::string& name, const std::exception& error) {
  const std::string said = error.what();
  return {name, said.substr(0, said.find('\n')), true};
}

void addScenario(const std::filesystem::path& file, const std::string& name, ListedFiles& listed) try {
  const Scenario scenario = readScenario(file);
  (scenario.lesson ? listed.lessons : listed.games).push_back({name, scenario.title});
} catch (const std::exception& error) {
  listed.games.push_back(faulty(name, error));
}

void addRig(const std::filesystem::path& file, const std::string& name, ListedFiles& listed) try {
  listed.rigs.push_back({name, readRig(file).title});
} catch (const std::exception& error) {
  listed.rigs.push_back(faulty(name, error));
}

void addPlaylist(const std::filesystem::path& file, const std::string& name, ListedFiles& listed) try {
  listed.playlists.push_back({name, readPlaylist(file).title});
} catch (const std::exception& error) {
  listed.playlists.push_back(faulty(name, error));
}

/// An item bank, which lies beside them, is no study.
void addStudyFile(const std::filesystem::path& file, const std::string& name, ListedFiles& listed) try {
  listed.studies.push_back({name, readStudy(file).title});
} catch (const std::exception& error) {
  const std::string text = beginningOf(file, InputKind::toml, kBeginning);
  if (text.find("[[arm]]") != std::string::npos) listed.studies.push_back(faulty(name, error));
}

/// Adds a file of a user's folder, if it is a scenario, a rig, a playlist or a study: only a scenario has a
/// light speed, only a rig has walls, only a playlist has games, only a study has arms. Of others, which
/// another program may have written, nothing is said.
void addLocal(const std::filesystem::path& file, ListedFiles& listed) {
  ListedFiles as;
  addScenario(file, file.string(), as);
  if (as.games.empty() || !as.games[0].isFaulty) {
    listed.lessons.insert(listed.lessons.end(), as.lessons.begin(), as.lessons.end());
    listed.games.insert(listed.games.end(), as.games.begin(), as.games.end());
    return;
  }
  addRig(file, file.string(), as);
  const std::string text = beginningOf(file, InputKind::toml, kBeginning);
  if (!as.rigs[0].isFaulty || text.find("[[wall]]") != std::string::npos) {
    listed.rigs.push_back(as.rigs[0]);
  } else if (text.find("[[game]]") != std::string::npos) {
    addPlaylist(file, file.string(), listed);
  } else if (text.find("[[arm]]") != std::string::npos) {
    addStudyFile(file, file.string(), listed);
  } else if (text.find("light_speed_m_s") != std::string::npos) {
    listed.games.push_back(as.games[0]);
  }
}

/// Returns how much of a part is translated; 100 % is all of it.
std::string wordsFor(const LanguageProgress::Part& part, std::string_view what) {
  return fmt::format("{} % of {} {}", part.all == 0 ? 100 : 100 * part.translated / part.all, part.all, what);
}

void addLanguages(ListedFiles& listed) {
  listed.languages.push_back({"en", "as everything is written"});
  for (const LanguageProgress& progress : progressOfLanguages()) {
    const bool isFaulty = !progress.fault.empty();
    listed.languages.push_back({progress.code,
                                isFaulty ? progress.fault
                                         : fmt::format("{}, {}", wordsFor(progress.texts, "texts"),
                                                       wordsFor(progress.games, "texts of games")),
                                isFaulty});
  }
}

void print(const char* heading, const std::vector<ListedFile>& files) {
  if (files.empty()) return;
  std::size_t width = 0;
  for (const ListedFile& file : files) width = std::max(width, file.name.size());
  fmt::print("{}\n", heading);
  for (const ListedFile& file : files)
    fmt::print("  {:{}}  {}{}\n", printable(file.name), width, file.isFaulty ? "error: " : "",
               printable(file.title));
}

int runList() {
  const ListedFiles listed = listFiles(".");
  print("games (carom cave --scenario NAME)", listed.games);
  print("lessons (carom cave --scenario NAME)", listed.lessons);
  print("rigs (carom cave --rig NAME)", listed.rigs);
  print("playlists (carom cave --playlist NAME)", listed.playlists);
  print("studies (carom study plan NAME)", listed.studies);
  print("traces (carom filter NAME)", listed.traces);
  print("languages (carom cave --language CODE)", listed.languages);
  const auto isFaulty = [](const ListedFile& file) { return file.isFaulty; };
  return std::any_of(listed.games.begin(), listed.games.end(), isFaulty) ||
                 std::any_of(listed.rigs.begin(), listed.rigs.end(), isFaulty) ||
                 std::any_of(listed.playlists.begin(), listed.playlists.end(), isFaulty) ||
                 std::any_of(listed.studies.begin(), listed.studies.end(), isFaulty) ||
                 std::any_of(listed.languages.begin(), listed.languages.end(), isFaulty)
             ? 1
             : 0;
}

/// Prints the games of a session: number, start, first and last second on the session clock, title.
int listGames(const std::filesystem::path& file) {
  const SessionFile session(file);
  fmt::print("games of {0} (carom replay {0} --game N)\n", printable(file.string()));
  fmt::print("{:>5}  {:20}  {:>17}  {}\n", "game", "started", "session clock", "title");
  std::size_t number = 0;
  for (const SessionGame& game : session.games()) {
    const std::string title = readScenario(game.scenario, game.scenarioText).title;
    fmt::print("{:5}  {:20}  {:>7.1f}-{:>7.1f} s  {}\n", ++number, game.startedUtc, game.from_s, game.to_s,
               title);
  }
  return 0;
}

}  // namespace

ListedFiles listFiles(const std::filesystem::path& folder) {
  ListedFiles listed;
  for (const std::string_view lesson : kLessons) addScenario(fileOfGame(lesson), std::string(lesson), listed);
  for (const auto& file : filesIn(configFolder() / "scenarios", ".toml")) {
    const std::string name = file.stem().string();
    if (std::find(kLessons.begin(), kLessons.end(), name) == kLessons.end()) addScenario(file, name, listed);
  }
  for (const auto& file : filesIn(configFolder() / "rigs", ".toml"))
    addRig(file, file.stem().string(), listed);
  for (const auto& file : filesIn(configFolder() / "playlists", ".toml"))
    addPlaylist(file, file.stem().string(), listed);
  for (const auto& file : filesIn(configFolder() / "studies", ".toml"))
    addStudyFile(file, file.stem().string(), listed);
  for (const auto& file : filesIn(configFolder() / "traces", ".csv"))
    listed.traces.push_back({file.stem().string(), ""});
  addLanguages(listed);
  for (const auto& file : filesIn(folder, ".toml")) addLocal(file.lexically_normal(), listed);
  return listed;
}

void addList(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand(
      "list",
      "List the shipped games, lessons, rigs, playlists, studies, traces and languages (with how "
      "much of each is translated), and those in this folder; or the games of a session");
  const auto session = std::make_shared<std::optional<std::filesystem::path>>();
  command->add_option("SESSION", *session, "Session file whose games are listed");
  command->footer("Examples:\n  carom list\n  carom list visit.db");
  command->callback([session, &status] { status = *session ? listGames(**session) : runList(); });
}

}  // namespace carom
