#include "app/commands/replay.h"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <stdexcept>

#include "app/session/frame_loop.h"
#include "app/session/recorded_source.h"
#include "app/session/visitor_source.h"
#include "app/stage/all_ranks.h"
#include "app/viewer/person.h"
#include "devices/tracker/trace.h"
#include "engine/base/log.h"

namespace carom {
namespace {

bool isVisit(const ReplayOptions& options) {
  return options.observer || options.walk || options.beta || options.from_m || options.facing_rad;
}

/// The session's rig and scenario, from its file.
std::unique_ptr<SessionFile> openSession(const ReplayOptions& options, StageOptions& inputs) {
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

/// Where the frames come from, and the clock that they go by.
struct Frames {
  std::unique_ptr<Clock> clock;
  std::unique_ptr<FrameSource> source;
};

Frames framesOf(const ReplayOptions& options, const Stage& stage, SessionFile& session) {
  std::optional<RecordedGame> game;
  if (isVisit(options)) game = wholeGame(session, historiesAtStart(stage));
  Frames frames;
  const auto start = std::chrono::steady_clock::now();
  if (stage.realTime) {
    frames.clock = std::make_unique<SteadyClock>(start);
  } else {
    frames.clock = std::make_unique<SimulatedClock>();
  }
  if (game) {
    const Visitor visitor{options.observer, options.beta, stage.realTime && !options.observer, options.from_m,
                          options.facing_rad};
    frames.source = std::make_unique<VisitorSource>(stage.rig, stage.scenario, visitor, std::move(*game),
                                                    VisitTime{*frames.clock, start, stage.swapsWait});
  } else {
    frames.source = std::make_unique<RecordedSource>(session, historiesAtStart(stage), stage.rig.display_hz,
                                                     *frames.clock, options.at_s);
  }
  return frames;
}

void replay(Cluster& cluster, const ReplayOptions& options) {
  std::unique_ptr<SessionFile> session;
  StageOptions inputs;
  inputs.recording = options.recording;
  inputs.noWindow = inputs.simulated = options.noWindow;
  inputs.live = isVisit(options) && !options.observer;
  inputs.outside = options.outside;
  inputs.diagram = options.diagram;
  together(cluster, [&] {
    if (cluster.rank() == 0) session = openSession(options, inputs);
  });
  shareInputs(cluster, inputs);
  Stage stage = openStage(cluster, inputs);
  if (options.console && !options.noWindow) openConsole(cluster, stage, KeysOf::replay);

  Frames frames;
  std::optional<Lead> lead;
  together(cluster, [&] {
    if (cluster.rank() > 0) return;
    frames = framesOf(options, stage, *session);
    lead.emplace(Lead{*frames.source, KeysOf::replay, controlsAtStart(stage),
                      soundsOf(stage, options.silent || options.noWindow)});
    lead->controls.playing = inputs.scenario.file.string();
    if (!options.noWindow) sayKeys(KeysOf::replay);
  });
  runFrames(nodeOf(cluster, stage), lead ? &*lead : nullptr);
  frames.source.reset();  // trackers are asked to be quiet
  stage.recording->finish();
  if (lead && options.recording.capture)
    log::note(fmt::format("The pictures are in {}.", options.recording.capture->string()));
  cluster.leave();
}

}  // namespace

int runReplay(const ReplayOptions& options) {
  return runOnCluster([&](Cluster& cluster) { replay(cluster, options); });
}

}  // namespace carom
