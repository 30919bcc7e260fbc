#include "app/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "app/check.h"
#include "app/observe.h"
#include "app/simulate.h"
#include "app/toml_file.h"
#ifdef CAROM_WITH_CAVE
#include "app/cave_session.h"
#endif

namespace carom {

namespace {

/// The whole text is one number that this program can calculate with, within the range.
CLI::Validator numberIn(const Range& range, const std::string& expected) {
  return CLI::Validator(
      [range, expected](std::string& text) {
        const std::size_t sign = text.starts_with('+') ? 1 : 0;
        double value = 0.0;
        const char* end = text.data() + text.size();
        const auto [stop, failed] = std::from_chars(text.data() + sign, end, value);
        const bool whole = failed == std::errc() && stop == end;
        const bool fits =
            whole && value <= range.most && (range.above ? value > range.least : value >= range.least);
        return fits ? std::string() : fmt::format("'{}' is wrong, expected {}", text, expected);
      },
      "");
}

Vec3 toVec3(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }

void addJson(CLI::App& command, std::optional<std::filesystem::path>& json) {
  command.add_option("--json", json, "Write the result to this file as JSON; - is standard output")
      ->type_name("FILE");
}

void addSimulate(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("simulate", "Play a scenario: every collision, and where the pucks are");
  auto options = std::make_shared<SimulateOptions>();
  command->add_option("SCENARIO", options->scenario, "Scenario file")->required();
  command->add_option("--until", options->until_s, "Board time to play to, in seconds")
      ->required()
      ->type_name("S")
      ->check(numberIn(kNotNegative, "a time from 0 to 1e9 s"));
  command->add_option("--every", options->every_s, "Also give the states at 0, D, 2D, … seconds")
      ->type_name("D")
      ->check(numberIn(kPositive, "a time above 0 up to 1e9 s"));
  addJson(*command, options->json);
  command->footer(
      "Example:\n  carom simulate config/scenarios/three-pucks.toml --until 10 --every 0.5 --json game.json");
  command->callback([options, &status] {
    if (options->every_s && options->until_s / *options->every_s > kMostStates) {
      throw CLI::ValidationError("--every", "gives over a million states, expected a longer step");
    }
    status = runSimulate(*options);
  });
}

void addObserve(CLI::App& app, int& status) {
  using Point = std::tuple<std::string, double, double, double>;
  struct Line {
    std::filesystem::path scenario;
    std::vector<double> event, beta{0.0, 0.0, 0.0};
    std::vector<Point> points;
    std::optional<std::filesystem::path> json;
  };
  CLI::App* command = app.add_subcommand("observe", "What an eye at one event of the board sees");
  auto line = std::make_shared<Line>();
  command->add_option("SCENARIO", line->scenario, "Scenario file")->required();
  command->add_option("--event", line->event, "Board time (s) and place (m) at which the eye receives light")
      ->required()
      ->expected(4)
      ->type_name("T X Y Z")
      ->check(numberIn({}, "a number from -1e9 to 1e9"));
  command->add_option("--beta", line->beta, "The eye's velocity over c; at rest on the board if left out")
      ->expected(3)
      ->type_name("BX BY BZ")
      ->check(numberIn({}, "a number from -1e9 to 1e9"));
  command
      ->add_option("--point", line->points,
                   "A point of a puck or body, from its centre in its rest frame (m); may be given again. "
                   "Left out: every centre")
      ->type_name("NAME DX DY DZ")
      ->allow_extra_args(false);
  addJson(*command, line->json);
  command->footer(
      "Example: an eye 1 m above the board's edge, walking along it at half the speed of light\n"
      "  carom observe config/scenarios/three-pucks.toml --event 2 0 -0.7 1 --beta 0.5 0 0 --point red 0.03 "
      "0 0");
  command->callback([line, &status] {
    ObserveOptions options{line->scenario,
                           {line->event[0], {line->event[1], line->event[2], line->event[3]}},
                           toVec3(line->beta),
                           {},
                           line->json};
    if (!(glm::dot(options.beta, options.beta) < 1.0)) {
      throw CLI::ValidationError("--beta", "is not below the speed of light, expected a magnitude under 1");
    }
    for (const auto& [name, dx, dy, dz] : line->points) {
      const Vec3 offset_m(dx, dy, dz);
      if (!(glm::length(offset_m) <= kFurthest)) {
        throw CLI::ValidationError("--point", "is no number, expected offsets between -1e9 and 1e9");
      }
      options.points.push_back({name, offset_m});
    }
    try {
      status = runObserve(options);
    } catch (const UnknownBody& error) {
      throw CLI::ValidationError(error.what());
    }
  });
}

void addCheck(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("check", "Examine a scenario or a rig and say what is in it");
  auto file = std::make_shared<std::filesystem::path>();
  command->add_option("FILE", *file, "Scenario or rig")->required();
  command->footer("Example:\n  carom check config/rigs/desk.toml");
  command->callback([file, &status] { status = runCheck(*file); });
}

#ifdef CAROM_WITH_CAVE
void addCave(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("cave", "The immersive session: walk beside the board");
  auto options = std::make_shared<CaveOptions>();
  const std::filesystem::path config = CAROM_CONFIG_DIR;
  options->rig = config / "rigs/desk.toml";
  options->scenario = config / "scenarios/three-pucks.toml";
  command->add_option("--rig", options->rig, "Rig file: walls and trackers")->capture_default_str();
  command->add_option("--scenario", options->scenario, "Scenario file")->capture_default_str();
  command->add_option("--frames", options->frames, "Play so many frames in simulated time, then end")
      ->type_name("N")
      ->check(CLI::Range(1L, 1000000000L));
  command
      ->add_option("--capture", options->capture,
                   "Folder for the pictures of every wall and eye: WALL-EYE-FRAME.png")
      ->type_name("DIR");
  command->add_flag("--no-window", options->noWindow, "Draw without showing; an X display is still needed");
  command->footer(
      "Examples:\n  carom cave\n  carom cave --frames 90 --capture pictures --no-window\n"
      "  mpirun -n 4 carom cave --rig config/rigs/four-walls-cluster.toml");
  command->callback([options, &status] { status = runCave(*options); });
}
#endif

}  // namespace

void addCommands(CLI::App& app, int& status) {
  app.require_subcommand(1);
  app.failure_message([](const CLI::App* command, const CLI::Error& error) {
    return fmt::format("error: {}\nRun {} --help for what is expected.\n", error.what(),
                       command->get_display_name());
  });
  app.set_version_flag("--version", CAROM_VERSION, "Print the version");
  app.set_help_all_flag("--help-all", "Print the help of every command");
  app.footer(
      "Start with:\n  carom cave                                        the default session\n"
      "  carom check config/rigs/desk.toml                 what a file says\n"
      "  carom simulate config/scenarios/three-pucks.toml --until 10\n"
      "Each command explains itself: carom simulate --help");
  addSimulate(app, status);
  addObserve(app, status);
  addCheck(app, status);
#ifdef CAROM_WITH_CAVE
  addCave(app, status);
#endif
}

}  // namespace carom
