#include "app/commands/replay.h"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <stdexcept>

#include "app/commands/session_frames.h"
#include "app/session/recorded_source.h"
#include "app/session/replay_visitor_source.h"
#include "app/stage/all_ranks.h"
#include "devices/tracker/trace.h"

namespace carom {
namespace {

bool isVisit(const ReplayOptions& options) {
  return options.observer || options.walk || options.beta || options.from_m || options.facing_rad;
}

/// The session's rig and scenario, from its file.
std::unique_ptr<SessionFile> openSession(const ReplayOptions& options, SetupOptions& inputs) {
  auto session = std::make_unique<SessionFile>(options.session);
  if (!session->frames()) {
    throw std::runtime_error(
        fmt::format("session file {}: it ended before its first frame", options.session.string()));
  }
  if (options.observer) readTrace(*options.observer);
  inputs.rig = {session->facts().rig, session->facts().rigText};
  inputs.scenario = {session->facts().scenario, session->facts().scenarioText};
  return session;
}

/// Where the frames come from, and what they go by.
struct Frames {
  std::unique_ptr<Clock> clock;
  std::unique_ptr<FramePacer> pacer;
  std::unique_ptr<FrameSource> source;
};

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
    const Visitor visitor{options.observer, options.beta, setup.realTime && !options.observer, options.from_m,
                          options.facing_rad};
    frames.source =
        std::make_unique<ReplayVisitorSource>(rig, setup.scenario, visitor, std::move(*game), start);
    frames.pacer =
        std::make_unique<Pacer>(*frames.clock, rig.display_hz, rig.displayLatency_s, setup.swapsWait);
  } else {
    frames.source = std::make_unique<RecordedSource>(session, historiesAtStart(setup), rig.display_hz);
    frames.pacer = std::make_unique<RecordingPacer>(*frames.clock);
  }
  return frames;
}

/// On rank 0: the frames as the source has them.
void showFrames(Cluster& cluster, SessionSetup& setup, OperatorWindows& windows, const ReplayOptions& options,
                const std::string& scenario, Frames& frames) {
  OperatorSettings settings = settingsAtStart(setup);
  settings.playing = scenario;
  FrameLeader leader(*frames.source, KeysOf::replay, settings, setup.realTime ? setup.walls.get() : nullptr);
  const auto sounds = soundsFor(setup, options.silent || options.noWindow);
  const LeaderParts lead{*frames.source, leader, windows, sounds.get(), nullptr};
  runFrames(SessionFrames(cluster, setup, *frames.pacer, &lead, KeysOf::replay).context());
}

void replay(Cluster& cluster, const ReplayOptions& options) {
  std::unique_ptr<SessionFile> session;
  SetupOptions inputs;
  inputs.recording = options.recording;
  inputs.noWindow = inputs.simulated = options.noWindow;
  inputs.live = isVisit(options) && !options.observer;
  inputs.outside = options.outside;
  together(cluster, [&] {
    if (cluster.rank() == 0) session = openSession(options, inputs);
  });
  shareInputs(cluster, inputs.rig, inputs.scenario);
  SessionSetup setup = setUpSession(cluster, inputs);
  const bool visible = !options.noWindow;
  OperatorWindows windows =
      openWindows(cluster, setup, options.diagram && visible, options.console && visible, KeysOf::replay);
  Frames frames;
  together(cluster, [&] {
    if (cluster.rank() > 0) return;
    frames = framesOf(options, setup, *session);
    if (visible) sayKeys(KeysOf::replay);
  });
  if (frames.source) {
    showFrames(cluster, setup, windows, options, inputs.scenario.file.string(), frames);
  } else {
    FramePacer follows;
    runFrames(SessionFrames(cluster, setup, follows, nullptr, KeysOf::replay).context());
  }
  const bool leads = frames.source != nullptr;
  frames.source.reset();  // trackers are asked to be quiet
  setup.recording->finish();
  if (leads && options.recording.capture)
    fmt::print(stderr, "The pictures are in {}.\n", options.recording.capture->string());
  cluster.leave();
}

}  // namespace

int runReplay(const ReplayOptions& options) {
  return runOnCluster([&](Cluster& cluster) { replay(cluster, options); });
}

}  // namespace carom
