#include "app/output_commands/pattern.h"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <stdexcept>

#include "app/operator/room_languages.h"
#include "app/output_commands/words_in.h"
#include "app/rig/rig.h"
#include "app/room_formats/room_kind.h"
#include "app/session/frame_loop.h"
#include "app/session/session_listeners.h"
#include "app/session/session_views.h"
#include "app/stage/all_ranks.h"
#include "app/stage/session_setup.h"
#include "cave/cluster/cluster.h"
#include "cave/frame/pacer.h"
#include "engine/text/log.h"

namespace carom {
namespace {

/// The setup of this rank: its walls, with an empty scene.
struct Patterns {
  Rig rig;
  std::unique_ptr<Graphics> graphics;
  std::unique_ptr<DisplayWalls> walls;
  std::unique_ptr<Recording> recording;
};

Patterns openPatterns(Cluster& cluster, const PatternOptions& options) {
  Patterns patterns;
  onAllRanks(cluster, [&] {
    if (isForeignRoom(options.rig)) {
      throw std::runtime_error(fmt::format(
          "{}: --pattern takes a rig, expected one that `carom import` made of this", options.rig.string()));
    }
  });
  agreeOnVersion(cluster);
  Handover files(cluster);
  patterns.rig = files.rig({options.rig, {}});
  cluster.nameNodes(patterns.rig.walls);
  onAllRanks(cluster, [&] {
    const Rig& rig = patterns.rig;
    patterns.graphics = std::make_unique<Graphics>(displayOf(rig, cluster.rank()));
    if (!options.capture) checkMonitors(cluster.wallsOf(rig.walls), rig.oneWindow);
    const double anyLightSpeed_m_s = 1.0;
    patterns.walls =
        std::make_unique<DisplayWalls>(*patterns.graphics, Scene{}, anyLightSpeed_m_s,
                                       cluster.wallsOf(rig.walls), rig.oneWindow, !options.capture);
    patterns.recording = std::make_unique<Recording>(
        *patterns.graphics, RecordingOptions{options.capture, {}}, cluster, rig, false);
  });
  return patterns;
}

/// Shows the patterns that the operator selects, one frame per refresh of the display.
class ChosenPatterns : public FrameSource {
 public:
  void next(const FrameTimes& times, const FrameInput&, OperatorSettings& settings,
            Decision& decision) override {
    FrameRecord& record = decision.frame.record;
    record.number = times.number;
    record.display_s = times.display_s;
    record.controls = settings.walls;
  }
};

/// Shows each pattern once, for images: the test patterns, then the seam pattern at 0, 1 and 2 s.
class EveryPattern : public FrameSource {
 public:
  void next(const FrameTimes& times, const FrameInput&, OperatorSettings& settings,
            Decision& decision) override {
    FrameRecord& record = decision.frame.record;
    record.number = times.number;
    record.display_s = times.number == 0 ? 0.0 : static_cast<double>(times.number - 1);
    record.controls = settings.walls;
    record.controls.shown = times.number == 0 ? Shown::calibrationPattern : Shown::alignmentPattern;
    record.last = times.number == 3;
  }
};

void showPatterns(Cluster& cluster, Patterns& patterns, const PatternOptions& options) {
  const bool leads = cluster.rank() == 0, realTime = !options.capture;
  const Rig& rig = patterns.rig;
  std::unique_ptr<FrameSource> source = std::make_unique<EveryPattern>();
  if (realTime) source = std::make_unique<ChosenPatterns>();
  SteadyClock clock;
  std::unique_ptr<FramePacer> pacer = std::make_unique<FramePacer>();
  if (leads && realTime) pacer = std::make_unique<Pacer>(clock, rig.display_hz, rig.displayLatency_s);
  if (leads && realTime) sayKeys(KeysOf::patterns);
  OperatorSettings settings;
  settings.walls.shown = Shown::calibrationPattern;
  Director follower;
  FrameLeader leader(*source, KeysOf::patterns, settings, nullptr);
  Director& director = leads ? leader : follower;
  World nothing;
  NodeLock lock = patterns.walls->lockSwaps(rig.frameLock);
  FrameStatistics statistics(cluster, lock, rig.display_hz, realTime);
  WallsView walls(*patterns.walls, statistics, director, KeysOf::patterns);
  DrawingEnd drawingEnd(*patterns.walls, statistics, realTime);
  RecordingListener recording(*patterns.recording, *patterns.walls, nullptr);
  KeyLock noLock;
  EndQuestion ending;
  FrameContext context{cluster,
                       *patterns.graphics,
                       nothing,
                       *pacer,
                       director,
                       statistics,
                       {&walls, &drawingEnd},
                       {&statistics, &recording},
                       &noLock,
                       &ending};
  runFrames(context);
  patterns.recording->finish();
  if (leads && options.capture) log::note(fmt::format("The pictures are in {}.", options.capture->string()));
}

}  // namespace

int runPattern(const PatternOptions& options) {
  return runOnCluster([&](Cluster& cluster) {
    Patterns patterns = openPatterns(cluster, options);
    const WordsIn words(languagesOf(patterns.rig, nullptr, options.language).firstOf(0));
    showPatterns(cluster, patterns, options);
  });
}

}  // namespace carom
