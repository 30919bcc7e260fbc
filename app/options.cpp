#include "options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "app/files/config_folder.h"
#include "app/files/toml_file.h"
#include "app/tools/check.h"
#include "app/tools/filter.h"
#include "app/tools/import.h"
#include "app/tools/observe.h"
#include "app/tools/simulate.h"
#include "app/tools/track.h"
#ifdef CAROM_WITH_CAVE
#include "app/commands/cave_session.h"
#include "app/commands/diagram.h"
#include "app/commands/events.h"
#include "app/commands/export.h"
#include "app/commands/pattern.h"
#include "app/commands/replay.h"
#include "app/operator/controls.h"
#include "app/stage/scenario_scene.h"
#include "cave/capture/movie.h"
#endif

namespace carom {

namespace {

// What needs VTK: not there in builds for the sanitizers.
#ifdef CAROM_WITH_CAVE
const SeenSceneText kSeenScene = seenSceneVtp;
const std::function<void(const Scenario&)> kOpenMeshes = openMeshes;
#else
const SeenSceneText kSeenScene;
const std::function<void(const Scenario&)> kOpenMeshes;
#endif

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

/// Puts the shipped file in the place of its bare name.
CLI::Validator shipped(const std::string& kind) {
  return CLI::Validator(
      [kind](std::string& text) {
        text = shippedFile(text, kind).string();
        return std::string();
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
  command->add_option("SCENARIO", options->scenario, "Scenario file, or the name of a shipped one")
      ->required()
      ->transform(shipped("scenarios"));
  command->add_option("--until", options->until_s, "Board time to play to, in seconds")
      ->required()
      ->type_name("S")
      ->check(numberIn(kNotNegative, "a time from 0 to 1e9 s"));
  command->add_option("--every", options->every_s, "Also give the states at 0, D, 2D, … seconds")
      ->type_name("D")
      ->check(numberIn(kPositive, "a time above 0 up to 1e9 s"));
  addJson(*command, options->json);
  command->footer("Example:\n  carom simulate three-pucks --until 10 --every 0.5 --json game.json");
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
    std::optional<std::filesystem::path> json, vtp;
  };
  CLI::App* command = app.add_subcommand("observe", "What an eye at one event of the board sees");
  auto line = std::make_shared<Line>();
  command->add_option("SCENARIO", line->scenario, "Scenario file, or the name of a shipped one")
      ->required()
      ->transform(shipped("scenarios"));
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
  command->add_option("--vtp", line->vtp, "Write the whole seen scene to this file, as a mesh for ParaView")
      ->type_name("FILE");
  command->footer(
      "Example: an eye 1 m above the board's edge, walking along it at half the speed of light\n"
      "  carom observe three-pucks --event 2 0 -0.7 1 --beta 0.5 0 0 --point red 0.03 "
      "0 0");
  command->callback([line, &status] {
    ObserveOptions options{
        line->scenario,     {line->event[0], {line->event[1], line->event[2], line->event[3]}},
        toVec3(line->beta), {},
        line->json,         line->vtp};
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
      status = runObserve(options, kSeenScene);
    } catch (const UnknownBody& error) {
      throw CLI::ValidationError(error.what());
    }
  });
}

void addFilter(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("filter", "Run a recorded tracker trace through the head filter of a session");
  auto options = std::make_shared<FilterOptions>();
  command->add_option("TRACE", options->trace, "Trace: time_s,x_m,y_m,z_m and perhaps qx,qy,qz,qw")
      ->required()
      ->transform(shipped("traces"));
  command->add_option("--light-speed", options->lightSpeed_m_s, "Light speed for what the eye would see, m/s")
      ->capture_default_str()
      ->type_name("C")
      ->check(numberIn(kPositive, "a speed above 0 up to 1e9 m/s"));
  command
      ->add_option("--csv", options->csv,
                   "Write position, celerity and its standard deviation, a row for each of the trace's; - is "
                   "standard output. Left out: a summary")
      ->type_name("FILE");
  command->footer(
      "Each row out is made of its own row and earlier ones only.\n"
      "Example:\n  carom filter walk --light-speed 1.42");
  command->callback([options, &status] { status = runFilter(*options); });
}

void addTrack(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("track", "Watch the trackers of a rig, and record the head");
  auto options = std::make_shared<TrackOptions>();
  auto list = std::make_shared<bool>(false);
  options->rig = configFolder() / "rigs/desk.toml";
  command->add_option("--rig", options->rig, "Rig file whose trackers to watch")
      ->capture_default_str()
      ->transform(shipped("rigs"));
  command
      ->add_option("--record", options->record,
                   "Write the samples of the head's sensor to this trace; it appears, whole, at the end")
      ->type_name("TRACE");
  command->add_option("--seconds", options->seconds, "End after so long; left out: at Ctrl-C")
      ->type_name("S")
      ->check(numberIn(kPositive, "a time above 0 up to 1e9 s"));
  command->add_flag("--list", *list, "Only say what is plugged in");
  command->footer(
      "Columns: age, since the newest pose held; jitter, of the intervals; rest, the noise of a coordinate "
      "while the sensor last kept still; dropouts, intervals of over one and a half usual ones.\n"
      "Example:\n  carom track --rig desk --record walk.csv --seconds 60");
  command->callback([options, list, &status] { status = *list ? runTrackList() : runTrack(*options); });
}

void addCheck(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("check", "Examine a scenario or a room and say what is in it and what is odd");
  auto file = std::make_shared<std::filesystem::path>();
  command->add_option("FILE", *file, "Scenario, rig, .pvx of ParaView or .json of SGCT")
      ->required()
      ->transform(shipped("rigs"))
      ->transform(shipped("scenarios"));
#ifdef CAROM_WITH_CAVE
  auto pattern = std::make_shared<bool>(false);
  auto capture = std::make_shared<std::optional<std::filesystem::path>>();
  auto* show = command->add_flag("--pattern", *pattern,
                                 "Show test patterns on a rig's walls instead, until Escape; under mpirun on "
                                 "every node's");
  command
      ->add_option("--capture", *capture,
                   "Folder for the patterns as pictures, without a window: WALL-EYE-FRAME.png, frame 0 the "
                   "test patterns, 1 to 3 the seam pattern after 0, 1 and 2 s")
      ->type_name("DIR")
      ->needs(show);
#endif
  command->footer("Example:\n  carom check desk");
  command->callback([=, &status] {
#ifdef CAROM_WITH_CAVE
    if (*pattern) {
      status = runPattern({*file, *capture});
      return;
    }
#endif
    status = runCheck(*file, kOpenMeshes);
  });
}

void addImport(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("import", "Turn another program's room file into a rig");
  auto options = std::make_shared<ImportOptions>();
  command->add_option("FILE", options->file, ".pvx of ParaView or .json of SGCT")->required();
  command->add_option("-o,--output", options->rig, "The rig to write; must not exist. - is standard output")
      ->required()
      ->type_name("RIG.toml");
  command->footer("Example:\n  carom import cave.pvx -o cave.toml");
  command->callback([options, &status] { status = runImport(*options); });
}

#ifdef CAROM_WITH_CAVE
/// Turns a switch as "NAME=on" or "NAME=off" says.
void turnSwitch(const std::string& text, Switches& switches) {
  for (const NamedSwitch& s : kNamedSwitches) {
    for (const bool on : {false, true}) {
      if (text != fmt::format("{}={}", s.name, on ? "on" : "off")) continue;
      switches.*s.value = on;
      return;
    }
  }
  throw CLI::ValidationError(
      "--switch", fmt::format("'{}' is wrong, expected retardation, contraction, aberration, colour or "
                              "searchlight, then =on or =off",
                              text));
}

/// Turns a view of time on.
void showView(const std::string& name, TimeViews& views) {
  std::string names;
  for (const NamedView& view : kNamedViews) {
    if (name == view.name) {
      views.*view.value = 1;
      return;
    }
    names += (names.empty() ? "" : ", ") + std::string(view.name);
  }
  throw CLI::ValidationError("--view", fmt::format("'{}' is wrong, expected one of {}", name, names));
}

void addSilent(CLI::App& command, bool& silent) {
  command.add_flag("--silent", silent, "No sounds; else each collision and stroke clicks when it is seen");
}

void addOutside(CLI::App& command, bool& outside, bool& diagram, bool& console) {
  command.add_flag(
      "--console", console,
      "Open the operator's console on the first node: walls in small, trackers, switches, games, events");
  command.add_flag("--diagram", diagram,
                   "Show the spacetime diagram in a window of its own: my axes tilt as I move");
  command.add_flag(
      "--outside", outside,
      "Show the room from outside, too: its walls, the person, the table where it is. With --capture "
      "also as outside-mono-FRAME.png");
}

void addMovie(CLI::App& command, std::optional<std::filesystem::path>& movie) {
  command
      .add_option(
          "--movie", movie,
          "Movie of this node's walls, the left eye's, encoded by the program ffmpeg: .mp4, .webm or .ogv. "
          "With several nodes each writes its own: FILE-node1.mp4 is node 1's")
      ->type_name("FILE")
      ->check(CLI::Validator(
          [](std::string& text) {
            if (isMovieName(text)) return std::string();
            return fmt::format("'{}' is wrong, expected a name that ends in {}", text, kMovieEndings);
          },
          ""));
}

void addCave(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("cave", "The immersive session: walk beside the board");
  auto options = std::make_shared<CaveOptions>();
  options->rig = configFolder() / "rigs/desk.toml";
  options->scenario = configFolder() / "scenarios/three-pucks.toml";
  command->add_option("--rig", options->rig, "Rig file: walls and trackers")
      ->capture_default_str()
      ->transform(shipped("rigs"));
  command->add_option("--scenario", options->scenario, "Scenario file")
      ->capture_default_str()
      ->transform(shipped("scenarios"));
  command->add_option("--frames", options->frames, "Play so many frames in simulated time, then end")
      ->type_name("N")
      ->check(CLI::Range(1L, 1000000000L));
  command
      ->add_option("--capture", options->recording.capture,
                   "Folder for the pictures of every wall and eye: WALL-EYE-FRAME.png")
      ->type_name("DIR");
  addMovie(*command, options->recording.movie);
  command
      ->add_option_function<std::vector<std::string>>(
          "--switch",
          [options](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) turnSwitch(text, options->switches);
          },
          "An effect to begin with on or off: retardation, contraction, aberration (on), colour, searchlight "
          "(off). May be given again. Keys 1 to 5 turn them later")
      ->type_name("NAME=on|off")
      ->allow_extra_args(false);
  command
      ->add_option_function<std::vector<std::string>>(
          "--view",
          [options](const std::vector<std::string>& names) {
            for (const std::string& name : names) showView(name, options->views);
          },
          "A view of time to begin with: board-now, my-now, paths, events, clocks, ruler, angles, split, "
          "frozen. May be given "
          "again. Keys turn them later")
      ->type_name("NAME")
      ->allow_extra_args(false);
  auto* session =
      command
          ->add_option("--session", options->session,
                       "Write the session to this new file (SQLite): every frame, sample and turn")
          ->type_name("DB");
  command
      ->add_flag("--resume", options->resume,
                 "Go on from the end of the session file, with its rig and scenario")
      ->needs(session)
      ->excludes(command->get_option("--rig"))
      ->excludes(command->get_option("--scenario"))
      ->excludes(command->get_option("--switch"))
      ->excludes(command->get_option("--view"));
  command->add_flag("--no-window", options->noWindow, "Draw without showing; an X display is still needed");
  addSilent(*command, options->silent);
  addOutside(*command, options->outside, options->diagram, options->console);
  command->footer(
      "Examples:\n  carom cave\n  carom cave --frames 90 --capture pictures --no-window\n"
      "  carom cave --switch colour=on --switch searchlight=on\n"
      "  mpirun -n 4 carom cave --rig four-walls-cluster");
  command->callback([options, &status] { status = runCave(*options); });
}
#endif

#ifdef CAROM_WITH_CAVE
void addReplay(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("replay", "Show a recorded session again, as it was or as another person sees it");
  auto options = std::make_shared<ReplayOptions>();
  command->add_option("SESSION", options->session, "Session file")->required();
  command
      ->add_option(
          "--observer", options->observer,
          "Trace of another person's head, in the room: the same game, seen by them, until they would see "
          "what was not recorded")
      ->type_name("TRACE")
      ->transform(shipped("traces"));
  command->add_flag("--walk", options->walk, "Walk about in the game yourself: the rig's tracker follows you")
      ->excludes(command->get_option("--observer"));
  command
      ->add_option_function<std::vector<double>>(
          "--beta",
          [options](const std::vector<double>& beta) {
            options->beta = toVec3(beta);
            if (glm::dot(*options->beta, *options->beta) < 1.0) return;
            throw CLI::ValidationError("--beta",
                                       "is not below the speed of light, expected a magnitude under 1");
          },
          "The velocity of the other person's room over c, on the board")
      ->expected(3)
      ->type_name("BX BY BZ")
      ->check(numberIn({}, "a number from -1e9 to 1e9"));
  command
      ->add_option_function<std::vector<double>>(
          "--from", [options](const std::vector<double>& place_m) { options->from_m = toVec3(place_m); },
          "Where the other person's room stands: its floor's origin on the board, in metres (the floor is "
          "0.75 m "
          "below the cloth)")
      ->expected(3)
      ->type_name("X Y Z")
      ->check(numberIn({}, "a number from -1e9 to 1e9"));
  command
      ->add_option_function<double>(
          "--facing", [options](double deg) { options->facing_rad = glm::radians(deg); },
          "Which way that room's front looks, anticlockwise from the table's length")
      ->type_name("DEG")
      ->check(numberIn({-360.0, 360.0}, "an angle from -360 to 360 degrees"));
  auto* at = command
                 ->add_option("--at", options->at_s,
                              "Begin at this second of the session instead of at its start; not with another "
                              "person")
                 ->type_name("S")
                 ->check(numberIn(kNotNegative, "a time from 0 to 1e9 s"));
  for (const char* other : {"--observer", "--walk", "--beta", "--from", "--facing"})
    at->excludes(command->get_option(other));
  command
      ->add_option("--capture", options->recording.capture,
                   "Folder for the pictures of every wall and eye: WALL-EYE-FRAME.png")
      ->type_name("DIR");
  addMovie(*command, options->recording.movie);
  command->add_flag("--no-window", options->noWindow,
                    "Draw without showing, as fast as it goes; an X display is still needed");
  addSilent(*command, options->silent);
  addOutside(*command, options->outside, options->diagram, options->console);
  command->footer(
      "Examples:\n  carom replay game.db\n  carom replay game.db --observer walk --capture "
      "pictures --no-window\n  carom replay game.db --walk --beta 0.6 0 0\n"
      "  carom replay game.db --walk --from 0 1.6 -0.75 --facing -90   (from the other side of the table)\n"
      "Keys: Space pauses, arrows go back and on and change the speed, R runs backwards, H tells the "
      "others.");
  command->callback([options, &status] { status = runReplay(*options); });
}

void addExport(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand(
      "export", "Write what was seen in a recorded session as numbers, or as meshes for ParaView");
  auto options = std::make_shared<ExportOptions>();
  command->add_option("SESSION", options->session, "Session file")->required();
  command
      ->add_option("--observer", options->observer,
                   "Trace of another person's head, in the room: what they see of the same game")
      ->type_name("TRACE")
      ->transform(shipped("traces"));
  command->add_option("--every", options->every, "Only frames whose numbers are multiples of this")
      ->type_name("N")
      ->check(CLI::Range(1L, 1000000000L));
  command
      ->add_option(
          "--csv", options->csv,
          "Write a row for each frame and body to this file: the observer's event, where and when the light "
          "left the body's centre, where it is seen and how it is shifted; - is standard output")
      ->type_name("FILE");
  command
      ->add_option("--paraview", options->paraview,
                   "New folder for the whole seen scene of each frame: ParaView opens DIR/seen.pvd")
      ->type_name("DIR");
  command->footer(
      "Both as carom observe has them, for the point between the eyes; board frame, seconds and metres. A "
      "frame's "
      "meshes take some megabytes: --every 30 is two a second.\n"
      "Examples:\n  carom export game.db --csv seen.csv\n"
      "  carom export game.db --observer walk --every 30 --paraview seen");
  command->callback([options, &status] {
    if (!options->csv && !options->paraview) {
      throw CLI::ValidationError("export",
                                 "nothing is to be written, expected --csv FILE, --paraview DIR or both");
    }
    status = runExport(*options);
  });
}

void addEvents(CLI::App& app, int& status) {
  struct Line {
    EventsOptions options;
    std::vector<double> velocity{0.0, 0.0, 0.0};
    std::vector<std::tuple<double, double, double>> places;
    std::vector<std::uint64_t> pair;
  };
  CLI::App* command =
      app.add_subcommand("events", "List what happened, in any frame, and what light told of it");
  auto line = std::make_shared<Line>();
  command->add_option("SOURCE", line->options.source, "Session file or scenario")
      ->required()
      ->transform(shipped("scenarios"));
  command->add_option("--velocity", line->velocity, "v/c on the board of another frame, to list them in, too")
      ->expected(3)
      ->type_name("BX BY BZ")
      ->check(numberIn({}, "a number from -1e9 to 1e9"));
  command
      ->add_option("--until", line->options.until_s,
                   "Board time of the last event; left out: 10 s, or a session's end")
      ->type_name("S")
      ->check(numberIn(kNotNegative, "a time from 0 to 1e9 s"));
  command
      ->add_option(
          "--place", line->places,
          "Who rests at this place of the board (m): when light brings them the news of each. May be "
          "given again")
      ->type_name("X Y Z")
      ->allow_extra_args(false);
  command->add_option("--pair", line->pair, "Only the two events of these numbers")
      ->expected(2)
      ->type_name("A B");
  command
      ->add_option("--csv", line->options.csv,
                   "Write them to this file, a row an event; - is standard output. Left out: a table")
      ->type_name("FILE");
  command->footer(
      "A session says also in which frame, and when, the light of each reached the person's head.\n"
      "Examples:\n  carom events game.db --velocity 0.5 0 0\n"
      "  carom events two-cushions --until 2 --velocity 0.5 0 0 --place 0 -1 0.3 --csv events.csv");
  command->callback([line, &status] {
    EventsOptions& options = line->options;
    options.movingBeta = toVec3(line->velocity);
    if (!(glm::dot(options.movingBeta, options.movingBeta) < 1.0)) {
      throw CLI::ValidationError("--velocity",
                                 "is not below the speed of light, expected a magnitude under 1");
    }
    for (const auto& [x, y, z] : line->places) {
      options.places_m.emplace_back(x, y, z);
      if (!(glm::length(options.places_m.back()) <= kFurthest)) {
        throw CLI::ValidationError("--place", "is no place, expected numbers between -1e9 and 1e9");
      }
    }
    if (!line->pair.empty()) options.pair = {line->pair[0], line->pair[1]};
    status = runEvents(options);
  });
}

void addDiagram(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("diagram", "Draw the spacetime diagram of a scenario or of a recorded session");
  auto options = std::make_shared<DiagramOptions>();
  command->add_option("SOURCE", options->source, "Scenario or session file")
      ->required()
      ->transform(shipped("scenarios"));
  command->add_option("-o,--output", options->figure, "The figure: FIG.svg or FIG.png")
      ->required()
      ->type_name("FIG");
  command->add_option("--along", options->along, "The board's axis beside time: x or y")
      ->capture_default_str()
      ->check(CLI::IsMember({'x', 'y'}));
  command
      ->add_option("--from", options->from_s,
                   "Board time at the lower edge; left out: 5 s before the present event")
      ->type_name("S")
      ->check(numberIn(kNotNegative, "a time from 0 to 1e9 s"));
  command
      ->add_option("--until", options->until_s,
                   "Board time of the present event; left out: 5 s, or a session's end")
      ->type_name("S")
      ->check(numberIn(kPositive, "a time above 0 up to 1e9 s"));
  command->footer("Example:\n  carom diagram three-pucks -o three-pucks.svg");
  command->callback([options, &status] {
    if (options->from_s && options->until_s && !(*options->from_s < *options->until_s)) {
      throw CLI::ValidationError("--from", "is not before --until");
    }
    status = runDiagram(*options);
  });
}
#endif

/// What was wrong, and which help says what is right.
std::string failureMessage(const CLI::App* app, const CLI::Error& error) {
  const std::vector<CLI::App*> given = app->get_subcommands();
  std::string what = error.what();
  if (given.empty() && error.get_name() == "RequiredError") {
    std::string names;
    for (const CLI::App* command : app->get_subcommands([](const CLI::App*) { return true; })) {
      names += (names.empty() ? "" : ", ") + command->get_name();
    }
    const std::vector<std::string> rest = app->remaining();
    what = fmt::format("{}, expected one of {}",
                       rest.empty() ? "no command is given" : "'" + rest[0] + "' is no command", names);
  }
  return fmt::format("error: {}\nRun {}{} --help for what is expected.\n", what, app->get_display_name(),
                     given.empty() ? "" : " " + given[0]->get_name());
}

}  // namespace

void addCommands(CLI::App& app, int& status) {
  app.require_subcommand(1);
  app.failure_message(failureMessage);
  app.set_version_flag("--version", CAROM_VERSION, "Print the version");
  app.set_help_all_flag("--help-all", "Print the help of every command");
  app.footer(
      "Start with:\n  carom cave                                        the default session\n"
      "  carom check desk                                  what a file says\n"
      "  carom simulate three-pucks --until 10\n"
      "Each command explains itself: carom simulate --help");
  addSimulate(app, status);
  addObserve(app, status);
  addCheck(app, status);
  addImport(app, status);
  addFilter(app, status);
  addTrack(app, status);
#ifdef CAROM_WITH_CAVE
  addCave(app, status);
  addEvents(app, status);
  addDiagram(app, status);
  addReplay(app, status);
  addExport(app, status);
#endif
}

}  // namespace carom
