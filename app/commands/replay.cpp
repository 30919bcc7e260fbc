#include "app/commands/replay.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <glm/trigonometric.hpp>
#include <memory>
#include <stdexcept>

#include "app/commands/session_frames.h"
#include "app/commands/session_options.h"
#include "app/replay/recorded_source.h"
#include "app/replay/replay_visitor_source.h"
#include "app/replay/soft_replay_source.h"
#include "app/session/game_settings.h"
#include "app/stage/all_ranks.h"
#include "app/tools/option_values.h"
#include "devices/tracker/trace.h"
#include "engine/text/log.h"

namespace carom {
namespace {

bool isVisit(const ReplayOptions& options) {
  return options.observer || options.rig || options.walk || options.beta || options.from_m ||
         options.facing_rad;
}

/// Opens the session file and takes rig and scenario from it.
std::unique_ptr<SessionFile> openSession(const ReplayOptions& options, SetupOptions& inputs) {
  auto session = std::make_unique<SessionFile>(options.session, options.game);
  if (!session->frames()) {
    throw std::runtime_error(
        fmt::format("session file {}: it ended before its first frame", options.session.string()));
  }
  if (options.observer) readTrace(*options.observer);
  if (!options.as.empty()) session->viewerNamed(options.as);
  session->scenario();  // refuses one that the session does not belong to
  inputs.rig = {session->facts().rig, session->facts().rigText};
  const std::array<int, 2>& eye_px = session->facts().eyePixels;
  if (!inputs.live && eye_px[0] > 0 && eye_px[1] > 0) inputs.eye_px = {eye_px[0], eye_px[1]};
  inputs.textSize = session->facts().textSize;
  inputs.people = session->facts().isLinked;
  inputs.languages = shownIn(session->facts().languages, options.language);
  if (options.rig) inputs.rig = {*options.rig, {}};
  inputs.scenario = {session->facts().scenario, session->facts().scenarioText};
  return session;
}

/// The frame source, with its clock and pacer.
struct Frames {
  std::unique_ptr<Clock> clock;
  std::unique_ptr<FramePacer> pacer;
  std::unique_ptr<FrameSource> source;
};

/// Returns the viewer of the session who is the first in what is shown.
std::size_t firstShown(const ReplayOptions& options, const SessionFile& session) {
  return options.as.empty() ? 0 : session.viewerNamed(options.as);
}

Frames framesOf(const ReplayOptions& options, const SessionSetup& setup, SessionFile& session) {
  std::optional<RecordedGame> game;
  if (isVisit(options)) game = wholeGame(session, historiesAtStart(setup));
  Frames frames;
  const auto start = std::chrono::steady_clock::now();
  if (setup.realTime) {
    frames.clock = std::make_unique<SteadyClock>(start);
  } else {
    frames.clock = std::make_unique<SimulatedClock>();
  }
  const Rig& rig = setup.rig;
  if (game) {
    frames.pacer = pacerFor(setup, *frames.clock);
    const Visitor visitor{options.observer, options.beta, setup.realTime && !options.observer, options.from_m,
                          options.facing_rad};
    frames.source =
        std::make_unique<ReplayVisitorSource>(rig, setup.scenario, visitor, std::move(*game), start);
  } else {
    frames.source = std::make_unique<RecordedSource>(session, historiesAtStart(setup), rig.display_hz,
                                                     options.at_s, firstShown(options, session));
    frames.pacer = std::make_unique<RecordingPacer>(*frames.clock);
  }
  if (!hasSoftPucks(setup.scenario)) return frames;
  std::vector<StrokeInFrame> strokes = session.strokesByFrame(setup.scenario.billiard.pucks);
  // Another observer's frames have numbers of their own, and know the whole game.
  if (isVisit(options))
    std::for_each(strokes.begin(), strokes.end(), [](StrokeInFrame& one) { one.first = 0; });
  frames.source =
      std::make_unique<SoftReplaySource>(std::move(frames.source), setup.scenario, std::move(strokes));
  return frames;
}

/// Shows the frames of the source, on rank 0. Another observer reads the language in which the one in whose
/// place they are began.
void showFrames(Cluster& cluster, SessionSetup& setup, OperatorWindows& windows, const ReplayOptions& options,
                const SessionFile& session, Frames& frames) {
  OperatorSettings settings = settingsAtStart(setup.rig, setup.scenario);
  settings.languageOf.front() = session.facts().languages.atStart.at(firstShown(options, session));
  settings.playing = session.facts().scenario.string();
  settings.console = consoleAtStart(setup.desk);
  FrameLeader leader(*frames.source, KeysOf::replay, settings,
                     devicesOf(setup.realTime ? setup.walls.get() : nullptr, KeysOf::replay));
  const auto sounds = soundsFor(setup, options.silent || options.noWindow);
  const LeaderParts lead{*frames.source, leader, windows, sounds.get(), nullptr, nullptr};
  runFrames(SessionFrames(cluster, setup, *frames.pacer, &lead, KeysOf::replay).context());
}

void replay(Cluster& cluster, const ReplayOptions& options) {
  std::unique_ptr<SessionFile> session;
  SetupOptions inputs;
  inputs.recording = options.recording;
  inputs.noWindow = inputs.simulated = options.noWindow;
  inputs.live = isVisit(options) && !options.observer;
  inputs.extra = options.extra;
  inputs.sky = options.sky;
  if (!options.as.empty() || isVisit(options)) inputs.onlyFor = options.as;
  onAllRanks(cluster, [&] {
    if (cluster.rank() == 0) session = openSession(options, inputs);
  });
  SessionSetup setup = setUpSession(cluster, inputs);
  if (session) sayGame(*session, setup.scenario.title);
  const bool visible = !options.noWindow;
  OperatorWindows windows = openWindows(cluster, setup, KeysOf::replay);
  Frames frames;
  onAllRanks(cluster, [&] {
    if (cluster.rank() > 0) return;
    frames = framesOf(options, setup, *session);
    if (visible) sayKeys(KeysOf::replay);
  });
  if (frames.source) {
    showFrames(cluster, setup, windows, options, *session, frames);
  } else {
    FramePacer follows;
    runFrames(SessionFrames(cluster, setup, follows, nullptr, KeysOf::replay).context());
  }
  const bool leads = frames.source != nullptr;
  frames.source.reset();  // stops the trackers
  if (leads) rememberWindows(setup, windows);
  setup.recording->finish();
  if (leads && options.recording.capture)
    log::note(fmt::format("The pictures are in {}.", options.recording.capture->string()));
  cluster.leave();
}

/// Adds who sees the recorded game instead of the person who played it: where, how fast and which way they
/// go.
void addVisitor(CLI::App& command, const std::shared_ptr<ReplayOptions>& options) {
  command
      .add_option(
          "--observer", options->observer,
          "Trace of another observer's head, in the room: the same game, seen by them, until they would see "
          "what was not recorded")
      ->type_name("TRACE")
      ->transform(shipped({"traces"}));
  command
      .add_option("--rig", options->rig,
                  "Walk about in the recorded game in another room than the recorded one, or with a headset")
      ->type_name("RIG")
      ->transform(shipped({"rigs"}))
      ->excludes(command.get_option("--observer"));
  command
      .add_flag("--walk", options->walk,
                "Walk about in the recorded game yourself, with the head tracked by the rig's tracker")
      ->excludes(command.get_option("--observer"));
  command
      .add_option_function<std::vector<double>>(
          "--beta",
          [options](const std::vector<double>& beta) {
            options->beta = toVec3(beta);
            if (glm::dot(*options->beta, *options->beta) < 1.0) return;
            throw CLI::ValidationError("--beta",
                                       "is not below the speed of light, expected a magnitude under 1");
          },
          "The velocity of the other observer's room over c, on the board")
      ->expected(3)
      ->type_name("BX BY BZ")
      ->check(numberIn({}, "a number from -1e9 to 1e9"));
  command
      .add_option_function<std::vector<double>>(
          "--from", [options](const std::vector<double>& place_m) { options->from_m = toVec3(place_m); },
          "Where the other observer's room stands: its floor's origin on the board, in metres (the floor is "
          "0.75 m "
          "below the cloth)")
      ->expected(3)
      ->type_name("X Y Z")
      ->check(numberIn({}, "a number from -1e9 to 1e9"));
  command
      .add_option_function<double>(
          "--facing", [options](double deg) { options->facing_rad = glm::radians(deg); },
          "Which way that room's front looks, anticlockwise from the table's length")
      ->type_name("DEG")
      ->check(numberIn({-360.0, 360.0}, "an angle from -360 to 360 degrees"));
}

/// Adds the picture by direction that is shown in the place of the walls.
void addSky(CLI::App& command, const std::shared_ptr<ReplayOptions>& options) {
  const auto sky = [options]() -> SkyPicture& {
    return options->sky ? *options->sky : options->sky.emplace();
  };
  CLI::Option* const kind =
      command
          .add_option_function<std::string>(
              "--sky",
              [sky](const std::string& name) {
                const auto* const found = std::find(kSkyKinds.begin(), kSkyKinds.end(), name);
                sky().kind = static_cast<SkyKind>(found - kSkyKinds.begin());
              },
              "Show one picture of all directions in the place of the walls, as planetariums and players of "
              "360° movies want it")
          ->type_name("KIND")
          ->check(CLI::IsMember(std::vector<std::string>(kSkyKinds.begin(), kSkyKinds.end())));
  command
      .add_option_function<int>(
          "--size", [sky](int size_px) { sky().size_px = size_px; },
          "Pixels across a fisheye's circle, all longitudes, or a square of a cubemap; 2048 if left out")
      ->type_name("N")
      ->check(CLI::Range(64, 8192))
      ->needs(kind);
  command
      .add_option_function<std::vector<double>>(
          "--eye", [sky](const std::vector<double>& place_m) { sky().eye_m = toVec3(place_m); },
          "Where in the room it is seen from, in metres; left out: from the recorded head")
      ->expected(3)
      ->type_name("X Y Z")
      ->check(numberIn({-1000.0, 1000.0}, "a number from -1000 to 1000"))
      ->needs(kind);
  command
      .add_option("--stereo", "Two eyes that face the front, the left one's picture above the right one's")
      ->type_name("MODE")
      ->check(CLI::IsMember({"top-bottom"}))
      ->each([sky](const std::string&) { sky().twoEyes = true; })
      ->needs(kind);
}

}  // namespace

int runReplay(const ReplayOptions& options) {
  return runOnCluster([&](Cluster& cluster) { replay(cluster, options); });
}

void addReplay(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("replay", "Show a recorded session again, as it was or as another observer sees it");
  auto options = std::make_shared<ReplayOptions>();
  command->add_option("SESSION", options->session, "Session file")->required();
  addGame(*command, options->game);
  command
      ->add_option(
          "--as", options->as,
          "Of several who shared the room, show this one's walls alone; another observer of the game "
          "is then in this one's place")
      ->type_name("NAME");
  addVisitor(*command, options);
  command
      ->add_option("--at", options->at_s,
                   "Begin at this second of the session instead of at its start; not with another observer")
      ->type_name("S")
      ->check(numberIn(kNotNegative, "a time from 0 to 1e9 s"));
  command
      ->add_option("--capture", options->recording.capture,
                   "Folder for the pictures of every wall and eye: WALL-EYE-FRAME.png")
      ->type_name("DIR");
  addMovie(*command, options->recording.movie);
  addLanguage(*command, options->language);
  addSky(*command, options);
  command->add_flag("--no-window", options->noWindow,
                    "Draw without showing, as fast as it goes; an X display is still needed");
  addSilent(*command, options->silent);
  addExtraWindows(*command, options->extra);
  command->footer(
      "Examples:\n  carom replay game.db\n  carom replay game.db --observer walk --capture "
      "pictures --no-window\n  carom replay game.db --walk --beta 0.6 0 0\n"
      "  carom replay game.db --walk --from 0 1.6 -0.75 --facing -90   (from the other side of the table)\n"
      "  carom replay game.db --sky equirectangular --size 4096 --movie around.mp4 --no-window\n"
      "Keys: Space pauses, arrows go back and on and change the speed, R runs backwards, H tells the "
      "others.");
  command->callback([options, &status] {
    if (options->at_s && isVisit(*options))
      throw CLI::ValidationError("--at",
                                 "is for the session as it was, expected it without another observer");
    status = runReplay(*options);
  });
}

}  // namespace carom
