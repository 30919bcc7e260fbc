#include "app/cave_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>

#include "app/frame_loop.h"
#include "app/keys.h"
#include "app/open_tracker.h"
#include "app/session_file.h"
#include "app/stage.h"

namespace carom {
namespace {

/// A dozen swaps of nothing tell whether swaps wait for the display.
bool swapsWait(WallSet& walls, Clock& clock, double display_hz) {
  std::array<double, 12> returned_s{};
  for (double& swap_s : returned_s) {
    walls.swap();
    swap_s = clock.now_s();
  }
  return swapsWaitFor(display_hz, returned_s);
}

/// Time as a session lives it: simulated for a given number of frames, unless a device tracks the head.
std::unique_ptr<Clock> clockOf(const Rig& rig, const CaveOptions& options,
                               std::chrono::steady_clock::time_point start) {
  const bool device = isDevice(rig.trackers[rig.head.sensor.tracker].kind);
  if (options.frames && !device) return std::make_unique<SimulatedClock>();
  if (options.frames)
    fmt::print(stderr, "The head is tracked by a device: the frames are shown in real time.\n");
  return std::make_unique<SteadyClock>(start);
}

/// The person and the game at the start of the session, or after the last frame of the one that goes on.
std::unique_ptr<Play> startPlay(Stage& stage, std::unique_ptr<Clock> clock,
                                std::chrono::steady_clock::time_point start, const CaveOptions& options,
                                const std::optional<FrameRecord>& before) {
  const Rig& rig = stage.rig;
  Person person(rig, stage.scenario, start, before);
  const bool waits = !options.frames && !options.noWindow && swapsWait(*stage.walls, *clock, rig.display_hz);
  const std::uint64_t firstFrame = before ? before->number + 1 : 0;
  std::optional<std::uint64_t> lastFrame;
  if (options.frames) lastFrame = firstFrame + *options.frames - 1;
  Pacer pacer(*clock, rig.display_hz, rig.displayLatency_s, waits, firstFrame);
  return std::make_unique<Play>(Play{std::move(clock),
                                     pacer,
                                     std::move(person),
                                     Game(stage.scenario),
                                     rig.head.eyeSeparation_m,
                                     lastFrame,
                                     before ? before->switches : options.switches,
                                     nullptr,
                                     {}});
}

/// What is about to be seen, for the person at rank 0.
void announce(const Stage& stage, const Cluster& cluster, const CaveOptions& options) {
  const std::vector<Wall>& walls = stage.rig.walls;
  fmt::print(stderr, "{} (light at {} m/s) in {}: {} wall{}, {} node{}.\n", stage.scenario.title,
             stage.scenario.billiard.lightSpeed_m_s, stage.rig.title, walls.size(),
             walls.size() == 1 ? "" : "s", cluster.size(), cluster.size() == 1 ? "" : "s");
  for (const Wall& wall : walls) {
    if (wall.node < cluster.size()) continue;
    fmt::print(stderr, "Wall {} asks for node {}; node {} draws it.\n", wall.name, wall.node,
               wall.node % cluster.size());
  }
  for (int rank = 0; rank < cluster.size(); ++rank) {
    const bool draws = std::any_of(walls.begin(), walls.end(),
                                   [&](const Wall& wall) { return wall.node % cluster.size() == rank; });
    if (!draws) fmt::print(stderr, "warning: node {} has no wall to draw.\n", rank);
  }
  if (!options.noWindow) sayKeys();
  fmt::print(stderr, "{}", tessellationReport(stage.scene, stage.tessellation));
}

/// The file that the session is written to: --session, new or gone on with; none without it.
std::unique_ptr<Journal> openJournal(const CaveOptions& options, const StageOptions& inputs,
                                     const Stage& stage) {
  if (!options.session) return nullptr;
  const SessionFacts facts{CAROM_VERSION,           inputs.rig.file,
                           inputs.scenario.file,    textOf(inputs.rig),
                           textOf(inputs.scenario), stage.scenario.billiard.lightSpeed_m_s};
  const auto say = [](const std::string& line) { fmt::print(stderr, "{}\n", line); };
  return std::make_unique<Journal>(*options.session, facts, options.resume, say);
}

/// What a session that goes on goes on from.
struct Before {
  SessionFacts facts;
  std::optional<FrameRecord> last;  ///< none: it ended before its first frame
};

Before whatWas(const std::filesystem::path& file) {
  SessionFile session(file);
  Before before{session.facts(), {}};
  for (FrameState state; session.next(state);) before.last = state.record;
  return before;
}

void runSession(Cluster& cluster, const CaveOptions& options) {
  StageOptions inputs{{options.rig, {}}, {options.scenario, {}}, true, options.capture, options.noWindow};
  Before before;
  together(cluster, [&] {
    if (cluster.rank() > 0 || !options.session) return;
    if (!options.resume && std::filesystem::exists(*options.session)) {
      throw std::runtime_error(fmt::format(
          "session file {}: it is there already, expected a new name, or --resume to go on with it",
          options.session->string()));
    }
    if (!options.resume) return;
    before = whatWas(*options.session);
    inputs.rig = {before.facts.rig, before.facts.rigText};
    inputs.scenario = {before.facts.scenario, before.facts.scenarioText};
  });
  if (options.resume) shareInputs(cluster, inputs);
  Stage stage = openStage(cluster, inputs);
  std::unique_ptr<Play> play;
  together(cluster, [&] {
    if (cluster.rank() > 0) return;
    const double lived_s = before.last ? before.last->display_s : 0.0;
    const auto start =
        std::chrono::steady_clock::now() - std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                               std::chrono::duration<double>(lived_s));
    auto clock = clockOf(stage.rig, options, start);
    clock->sleepUntil(lived_s);
    play = startPlay(stage, std::move(clock), start, options, before.last);
    play->journal = openJournal(options, inputs, stage);
  });
  if (play) announce(stage, cluster, options);
  runFrames({cluster, stage, options.capture}, play.get());
  if (play && options.session) fmt::print(stderr, "The session is in {}.\n", options.session->string());
  if (play && options.capture) fmt::print(stderr, "The pictures are in {}.\n", options.capture->string());
}

}  // namespace

int runCave(const CaveOptions& options) {
  return runOnCluster([&](Cluster& cluster) { runSession(cluster, options); });
}

}  // namespace carom
