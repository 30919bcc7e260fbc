#include "app/guide/help.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "app/file_keys/key_schema.h"
#include "app/file_keys/playlist_keys.h"
#include "app/file_keys/rig_keys.h"
#include "app/file_keys/scenario_keys.h"
#include "app/file_keys/study_keys.h"
#include "app/guide/manual_page.h"
#include "app/guide/trouble_table.h"

namespace carom {
namespace {

constexpr const char* kNothingFound =
    "No message of the page \"Running a room\" is like this. Give a whole line, as the program printed it, "
    "in "
    "quotes.\n"
    "  carom check FILE        says what is wrong with a rig, a game or a playlist\n"
    "  carom doctor RIG        says what a room and its computers lack\n"
    "  carom track --rig RIG   says what the trackers send\n"
    "  carom help              lists the commands\n"
    "The page lists all messages: /usr/share/doc/carom/app/doc/operators.md, or app/doc in the sources.\n";

/// Prints the text in lines of at most 100 letters, the further ones indented.
void printWrapped(const char* title, const std::string& text) {
  constexpr std::size_t kLine = 100;
  std::string line = fmt::format("{:<9}", title);
  std::size_t letters = line.size();
  for (std::size_t from = 0, to = 0; from < text.size(); from = to + 1) {
    to = std::min(text.find(' ', from), text.size());
    const std::string word = text.substr(from, to - from);
    if (letters + word.size() + 1 > kLine) {
      fmt::print("{}\n", line);
      line = std::string(9, ' ');
      letters = line.size();
    }
    line += (letters > 9 ? " " : "") + word;
    letters += word.size() + 1;
  }
  fmt::print("{}\n", line);
}

/// Prints the rows that are most like a message. Returns the exit status: 1 if there is none.
int explain(const std::string& words) {
  const std::vector<const Trouble*> found = nearestTroubles(troubles(), words);
  if (found.empty()) fmt::print("{}", kNothingFound);
  for (const Trouble* row : found) {
    if (row != found.front()) fmt::print("\n");
    printWrapped("message", row->says);
    printWrapped("means", row->meaning);
  }
  return found.empty() ? 1 : 0;
}

/// Adds an option that prints the keys of a kind of file in a form.
void addKeys(CLI::App& command, const char* option, const char* help, std::string (*form)(const FileKey&)) {
  static const std::map<std::string, const FileKey& (*)()> kinds{{"items", itemBankKeys},
                                                                 {"playlist", playlistKeys},
                                                                 {"rig", rigKeys},
                                                                 {"scenario", scenarioKeys},
                                                                 {"study", studyKeys}};
  const auto print = [form](const std::string& kind) { fmt::print("{}", form(kinds.at(kind)())); };
  command.add_option_function<std::string>(option, print, help)
      ->check(CLI::IsMember(&kinds))
      ->type_name("KIND");
}

}  // namespace

void addHelp(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand(
      "help", "Explain a message of the program and what helps; without one, list the commands");
  command->prefix_command();
  addKeys(*command, "--keys", "List the keys of a kind of file: items, playlist, rig, scenario or study",
          pageOf);
  addKeys(*command, "--schema",
          "Print the JSON Schema of such files, by which editors complete and check them", schemaOf);
  command->footer(
      "Examples:\n  carom help \"node 2 (left) is late: every wall keeps the last whole frame.\"\n"
      "  carom help one wall is black\n  carom help simulate\n  carom help --keys rig");
  command->callback([command, &app, &status] {
    if (command->count("--keys") + command->count("--schema") > 0) return;
    const std::vector<std::string> words = command->remaining();
    const auto isNamed = [&](const CLI::App* other) {
      return words.size() == 1 && other->get_name() == words[0];
    };
    if (words == std::vector<std::string>{"--manual"}) {  // for the build, which makes carom(1) of it
      fmt::print("{}", manualOfCommands(app));
      return;
    }
    const auto named = app.get_subcommands(isNamed);
    if (words.empty()) {  // App::help would be that of this command
      fmt::print("{}", app.get_formatter()->make_help(&app, app.get_name(), CLI::AppFormatMode::Normal));
    } else if (!named.empty()) {
      fmt::print("{}", named.front()->help("carom"));
    } else {
      status = explain(fmt::format("{}", fmt::join(words, " ")));
    }
  });
}

}  // namespace carom
