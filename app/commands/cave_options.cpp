#include "app/commands/cave_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

#include "app/commands/session_options.h"
#include "app/link/link_address.h"
#include "app/operator/visitor_choices.h"
#include "app/toml/config_folder.h"
#include "app/tools/option_values.h"

namespace carom {
namespace {

/// Returns the names of rows, separated by commas and the last one by `last`.
template <typename Rows>
std::string namesIn(const Rows& rows, const char* last) {
  std::string names;
  for (const auto& row : rows)
    names += (names.empty() ? "" : &row == &rows.back() ? last : ", ") + std::string(row.name);
  return names;
}

/// Sets a switch as "NAME=on" or "NAME=off" says.
void turnSwitch(const std::string& text, Switches& switches) {
  for (const NamedSwitch& s : kNamedSwitches) {
    for (const bool on : {false, true}) {
      if (text != fmt::format("{}={}", s.name, on ? "on" : "off")) continue;
      switches.*s.value = on;
      return;
    }
  }
  throw CLI::ValidationError("--switch", fmt::format("'{}' is wrong, expected {}, then =on or =off", text,
                                                     namesIn(kNamedSwitches, " or ")));
}

/// Turns a time view on.
void showView(const std::string& name, TimeViews& views) {
  for (const NamedView& view : kNamedViews) {
    if (name != view.name) continue;
    views.*view.value = 1;
    return;
  }
  throw CLI::ValidationError(
      "--view", fmt::format("'{}' is wrong, expected one of {}", name, namesIn(kNamedViews, ", ")));
}

/// Adds the rig and the game. The defaults depend on whether somebody watches, which is known when the
/// command runs.
void addRigAndScenario(CLI::App& command, const std::shared_ptr<CaveOptions>& options) {
  command
      .add_option("--rig", options->rig,
                  "Rig file: walls and trackers. With --frames or --no-window, the default is rigs/desk.toml")
      ->default_str((configFolder() / "rigs/play.toml").string())
      ->transform(shipped({"rigs"}));
  command
      .add_option("--scenario", options->scenario,
                  "Scenario file. With --frames or --no-window, the default is scenarios/three-pucks.toml")
      ->default_str(fileOfGame(kWelcome))
      ->transform(shipped({"scenarios"}));
  addLanguage(command, options->language);
}

/// Adds the options of the beginning: effects, views of time, the phase of a lesson.
void addBeginning(CLI::App& command, const std::shared_ptr<CaveOptions>& options) {
  command
      .add_option_function<std::vector<std::string>>(
          "--switch",
          [options](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) turnSwitch(text, options->switches);
          },
          fmt::format("Begin with this effect on or off: {} (at first the first three are on). May be given "
                      "several times. Keys 1 to 5 turn them later",
                      namesIn(kNamedSwitches, ", ")))
      ->type_name("NAME=on|off")
      ->allow_extra_args(false);
  command
      .add_option_function<std::vector<std::string>>(
          "--view",
          [options](const std::vector<std::string>& names) {
            for (const std::string& name : names) showView(name, options->views);
          },
          fmt::format("A view of time to begin with: {}. May be given several times. Keys turn them later",
                      namesIn(kNamedViews, ", ")))
      ->type_name("NAME")
      ->allow_extra_args(false);
  command
      .add_option("--lesson", options->lesson,
                  "The phase in which a lesson begins: asks, shows or explains. Default: asks, or shows "
                  "with --frames")
      ->type_name("PHASE")
      ->transform(numberOf({{"asks", static_cast<int>(LessonPhase::asks)},
                            {"shows", static_cast<int>(LessonPhase::shows)},
                            {"explains", static_cast<int>(LessonPhase::explains)}}));
  command.add_flag("--hide-right", options->hideRight,
                   "Lessons do not tell which answer is right: for a class that discusses it before");
  command
      .add_option(
          "--text-size", options->textSize,
          "Size of the walls' words, for a large room: 1 as ever, up to 2 twice as high where there is "
          "room for it")
      ->type_name("FACTOR")
      ->check(numberIn({.least = 1.0, .most = 2.0}, "a factor from 1 to 2"));
}

void addSession(CLI::App& command, const std::shared_ptr<CaveOptions>& options) {
  auto* session =
      command
          .add_option(
              "--session", options->session,
              "Write the session to this new file (SQLite): every frame, sample and turn. A name with a "
              "date, such as monday-%F.db, is the day's, with a number if it is there already")
          ->type_name("DB");
  command
      .add_flag(
          "--resume-or-new", options->resumeOrNew,
          "Go on from the end of the session file, or of its newest game, if it is there; otherwise begin it")
      ->needs(session);
  command
      .add_flag(
          "--resume", options->resume,
          "Go on from the end of the session file, with its rig and scenario. --scenario, --switch, --view "
          "and --lesson are then for the games of later visitors")
      ->needs(session)
      ->excludes(command.get_option("--resume-or-new"))
      ->excludes(command.get_option("--rig"));
  command
      .add_option("--status", options->status,
                  "Say once a second in this JSON file how the session goes. It is always whole")
      ->type_name("FILE.json");
}

/// Adds what lets another room, elsewhere, play at the same table.
void addLink(CLI::App& command, const std::shared_ptr<CaveOptions>& options) {
  command
      .add_option(
          "--link", options->link,
          "Play at one table with another room: listen:PORT waits for it, HOST or HOST:PORT calls it, "
          "whose game is then played. The rig has [link] with the key that both share. Without a link no "
          "socket is open")
      ->type_name("listen:[ADDRESS:]PORT|HOST[:PORT]")
      ->check(CLI::Validator(
          [](std::string& text) {
            try {
              linkAddressOf(text);
              return std::string();
            } catch (const std::invalid_argument& error) {
              return std::string(error.what());
            }
          },
          ""))
      ->excludes(command.get_option("--frames"))
      ->excludes(command.get_option("--lesson"))
      ->excludes(command.get_option("--class"))
      ->excludes(command.get_option("--study"));
}

/// Adds what lets a session run without an operator.
void addUnattended(CLI::App& command, const std::shared_ptr<CaveOptions>& options) {
  command
      .add_option(
          "--unattended", options->unattended_s,
          "Welcome the next visitor after so many seconds without input or motion of the head, five "
          "times as many while a question stands: the last ten are counted down on the wall, then the "
          "first game starts anew, all settings as at the beginning. Locks Escape, Q and the close "
          "buttons of the windows")
      ->type_name("S")
      ->check(numberIn(kPositive, "a time above 0 up to 1e9 s"));
  command
      .add_option(
          "--pin", options->pin,
          "Lock the keys that end or spoil a demonstration: Escape, Q, T, X, K, B, L, + and -. F12, this "
          "number and Enter open the lock; F12 closes it")
      ->type_name("DIGITS")
      ->check(CLI::Validator(
          [](std::string& text) {
            const bool isPin = text.size() >= 3 && text.size() <= 12 &&
                               text.find_first_not_of("0123456789") == std::string::npos;
            return isPin ? std::string() : fmt::format("'{}' is wrong, expected 3 to 12 digits", text);
          },
          ""));
}

/// Adds what lets a class answer by phone, or the participants of a study.
void addClassAndStudy(CLI::App& command, const std::shared_ptr<CaveOptions>& options) {
  auto* with = command.add_flag(
      "--class", options->hasClass,
      "Let a class answer by phone: the front wall shows how to join. Prints the address of the pages, the "
      "word of the room and the teacher's PIN. Without it no socket is open");
  command
      .add_flag(
          "--take", options->takes,
          "After a game the front wall offers a QR code, by which whoever played it gets its page (carom "
          "page) on their phone, for an hour")
      ->needs(with)
      ->needs(command.get_option("--session"));
  command
      .add_flag("--follow", options->follows,
                "Phones may follow the game live, each by the eyes of an observer of its own")
      ->needs(with);
  CLI::Option* study =
      command
          .add_option("--study", options->study,
                      "A study whose participants come one after the other: they type the code of their slip "
                      "on the page that is printed and answer there; the lessons run in the room, in their "
                      "arm and order. Default rig: that of the first arm")
          ->type_name("STUDY")
          ->transform(shipped({"studies"}))
          ->needs(command.get_option("--session"))
          ->excludes(with);
  study->needs(command.add_option("--slips", options->slips, "The codes that carom study codes has drawn")
                   ->type_name("SLIPS.csv")
                   ->needs(study));
  command
      .add_flag("--amended", options->isAmended,
                "Go on with a study that was changed after its first participant: both hashes are kept")
      ->needs(study);
  CLI::Option* address =
      command
          .add_option(
              "--class-address", options->classAddress,
              "The address on which phones find the pages of a class or a study, in numbers. Default: "
              "the rig's, else this computer's in the network of its default route")
          ->type_name("ADDRESS");
  CLI::Option* port =
      command
          .add_option("--class-port", options->classPort,
                      "The port of the pages; 0: any that is free. Default: the rig's, else 8080")
          ->type_name("PORT")
          ->check(CLI::Range(0, 65535));
  command.parse_complete_callback([with, study, address, port] {
    const CLI::Option* given = address->count() > 0 ? address : port;
    if (given->count() > 0 && with->count() + study->count() == 0)
      throw CLI::RequiresError(given->get_name(), "--class or --study");
  });
}

}  // namespace

std::shared_ptr<CaveOptions> addCaveOptions(CLI::App& command) {
  auto options = std::make_shared<CaveOptions>();
  addRigAndScenario(command, options);
  command
      .add_option(
          "--playlist", options->playlist,
          "Playlist file: the games that may be played, in their order, and for how long. Default: the "
          "rig's, if it names one")
      ->type_name("FILE.toml")
      ->transform(shipped({"playlists"}));
  command.add_option("--frames", options->frames, "Play so many frames in simulated time, then end")
      ->type_name("N")
      ->check(CLI::Range(1L, 1000000000L));
  command
      .add_option("--capture", options->recording.capture,
                  "Folder for the pictures of every wall and eye: WALL-EYE-FRAME.png")
      ->type_name("DIR");
  addMovie(command, options->recording.movie);
  addBeginning(command, options);
  addSession(command, options);
  command.add_flag("--no-window", options->noWindow, "Draw without showing; an X display is still needed");
  command.add_flag(
      "--by-mouse", options->byMouse,
      "A dry run of the room without its trackers, none of which is opened: mouse and keys move head and "
      "wand. "
      "Arrows walk, Page Up and Page Down raise and lower the head, Delete and End turn it; the wand points "
      "where the mouse does, and the left button is its trigger");
  addWithoutNodes(command, options->withoutNodes);
  addClassAndStudy(command, options);
  addLink(command, options);
  addUnattended(command, options);
  addSilent(command, options->silent);
  addExtraWindows(command, options->extra);
  return options;
}

void chooseRest(CaveOptions& options) {
  const bool isWatched = !options.frames && !options.noWindow;
  if (options.rig.empty()) options.rig = configFolder() / (isWatched ? "rigs/play.toml" : "rigs/desk.toml");
  options.isUsualGame = options.scenario.empty();
  if (options.isUsualGame && (!options.resume || !options.study.empty()))
    options.scenario = fileOfGame(isWatched ? kWelcome : "three-pucks");
}

CaveOptions caveOptionsOf(std::vector<std::string> arguments) {
  CLI::App command("", "cave");
  const auto options = addCaveOptions(command);
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
  command.parse(std::move(arguments));
  chooseRest(*options);
  return *options;
}

}  // namespace carom
