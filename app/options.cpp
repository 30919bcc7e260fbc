#include "options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/cave_session.h"
#include "app/commands/replay.h"
#include "app/file_tools/check.h"
#include "app/file_tools/import.h"
#include "app/file_tools/list.h"
#include "app/file_tools/texts.h"
#include "app/guide/help.h"
#include "app/output_commands/diagram.h"
#include "app/output_commands/events.h"
#include "app/output_commands/export.h"
#include "app/output_commands/page.h"
#include "app/output_commands/pattern.h"
#include "app/record_tools/answers.h"
#include "app/record_tools/compare.h"
#include "app/record_tools/link.h"
#include "app/record_tools/study.h"
#include "app/room_commands/doctor.h"
#include "app/room_commands/room.h"
#include "app/stage/handover.h"
#include "app/stage/scenario_scene.h"
#include "app/toml/input_file.h"
#include "app/tools/calibrate.h"
#include "app/tools/filter.h"
#include "app/tools/force.h"
#include "app/tools/observe.h"
#include "app/tools/simulate.h"
#include "app/tools/track.h"

namespace carom {
namespace {

const SeenSceneText kSeenScene = seenSceneVtp;
const FileOpeners kOpeners{examineMeshes, [](const auto& file, const Rig& rig) {
                             openBlends({file, {}}, rig);
                           }};
const ShowPattern kShowPattern = [](const auto& rig, const auto& capture, const auto& language) {
  return runPattern({rig, capture, language});
};

/// Returns the message for a command line error, with the help command that explains it.
std::string failureMessage(const CLI::App* app, const CLI::Error& error) {
  const std::vector<CLI::App*> given = app->get_subcommands();
  std::string what = error.what();
  if (given.empty() && error.get_name() == "RequiredError") {
    std::vector<std::string> names;
    for (const CLI::App* command : app->get_subcommands([](const CLI::App*) { return true; }))
      names.push_back(command->get_name());
    const std::vector<std::string> rest = app->remaining();
    const auto meant = rest.empty() ? std::nullopt : nearestWord(rest[0], names);
    what = rest.empty() ? "no command is given" : fmt::format("'{}' is no command", rest[0]);
    what += meant ? fmt::format(", expected '{}'?", *meant)
                  : fmt::format(", expected one of {}", fmt::join(names, ", "));
  }
  return fmt::format("error: {}\nRun {}{} --help for what is expected.\n", what, app->get_display_name(),
                     given.empty() ? "" : " " + given[0]->get_name());
}

/// Adds every command to `app`. The named one runs while the line is parsed and stores its exit status in
/// `status`.
void addCommands(CLI::App& app, int& status) {
  app.require_subcommand(1);
  app.failure_message(failureMessage);
  app.set_version_flag("--version", CAROM_VERSION, "Print the version");
  app.set_help_all_flag("--help-all", "Print the help of every command");
  app.footer(
      "Start with:\n  carom cave                                        the welcome: a game that already "
      "runs\n"
      "  carom list                                        the shipped games, lessons and rigs\n"
      "  carom check desk                                  what a file says\n"
      "  carom simulate three-pucks --until 10\n"
      "Each command explains itself: carom simulate --help");
  addCave(app, status);
  addReplay(app, status);
  addEvents(app, status);
  addDiagram(app, status);
  addExport(app, status);
  addCompare(app, status);
  addPage(app, status);
  addAnswers(app, status);
  addStudy(app, status);
  addList(app, status);
  addCheck(app, status, kOpeners, kShowPattern);
  addTexts(app, status);
  addSimulate(app, status);
  addObserve(app, status, kSeenScene);
  addRoom(app, status);
  addDoctor(app, status);
  addImport(app, status);
  addCalibrate(app, status);
  addTrack(app, status);
  addFilter(app, status);
  addForce(app, status);
  addLinkTools(app, status);
  addHelp(app, status);
}

}  // namespace

int runCommandLine(int argc, char** argv) {
  CLI::App app(
      "carom: a billiard table on which light is slow, shown as special relativity says it would look.",
      "carom");
  int status = 0;
  addCommands(app, status);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return status;
}

}  // namespace carom
