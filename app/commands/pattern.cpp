#include "app/commands/pattern.h"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <stdexcept>

#include "app/files/rig.h"
#include "app/session/frame_loop.h"
#include "app/session/stage.h"
#include "app/stage/all_ranks.h"
#include "app/tools/import.h"
#include "cave/cluster/cluster.h"
#include "cave/frame/pacer.h"
#include "engine/base/log.h"

namespace carom {
namespace {

/// The walls of this rank; nothing else is in the scene.
struct Patterns {
  Rig rig;
  std::unique_ptr<Graphics> graphics;
  std::unique_ptr<DisplayWalls> walls;
  std::unique_ptr<Recording> recording;
};

Patterns openPatterns(Cluster& cluster, const PatternOptions& options) {
  Patterns patterns;
  together(cluster, [&] {
    if (isForeignRoom(options.rig)) {
      throw std::runtime_error(fmt::format(
          "{}: --pattern takes a rig, expected one that `carom import` made of this", options.rig.string()));
    }
    patterns.rig = readRig(options.rig);
    openBlends({options.rig, {}}, patterns.rig);
  });
  agreeOnRig(cluster, {options.rig, {}}, patterns.rig);
  cluster.nameNodes(patterns.rig.walls);
  together(cluster, [&] {
    const Rig& rig = patterns.rig;
    patterns.graphics = std::make_unique<Graphics>(displayOf(rig, cluster.rank()));
    const double anyLightSpeed_m_s = 1.0;
    patterns.walls =
        std::make_unique<DisplayWalls>(*patterns.graphics, Scene{}, anyLightSpeed_m_s,
                                       cluster.wallsOf(rig.walls), rig.oneWindow, !options.capture);
    patterns.recording = std::make_unique<Recording>(
        *patterns.graphics, RecordingOptions{options.capture, {}}, cluster, rig, false);
  });
  return patterns;
}

/// The patterns as the operator chooses them, one frame at each of the display's ticks.
class ChosenPatterns : public FrameSource {
 public:
  explicit ChosenPatterns(const Rig& rig) : pacer_(clock_, rig.display_hz, rig.displayLatency_s) {}

  void next(const Controls& controls, FrameState& state) override {
    const FrameTimes times = pacer_.next();
    state.record.number = times.number;
    state.record.display_s = times.display_s;
    state.record.controls = controls.walls;
  }
  void drawn() override { pacer_.drawn(); }
  void shown(const FrameState&) override { pacer_.swapped(); }

 private:
  SteadyClock clock_;
  Pacer pacer_;
};

/// All of them once, for pictures: the test patterns, then the seam pattern at 0, 1 and 2 s.
class EveryPattern : public FrameSource {
 public:
  void next(const Controls& controls, FrameState& state) override {
    state.record.number = number_;
    state.record.display_s = number_ == 0 ? 0.0 : static_cast<double>(number_ - 1);
    state.record.controls = controls.walls;
    state.record.controls.shown = number_ == 0 ? Shown::calibrationPattern : Shown::alignmentPattern;
    state.record.last = number_ == 3;
    ++number_;
  }

 private:
  std::uint64_t number_ = 0;
};

void showPatterns(Cluster& cluster, Patterns& patterns, const PatternOptions& options) {
  std::unique_ptr<FrameSource> source;
  if (options.capture) {
    source = std::make_unique<EveryPattern>();
  } else {
    source = std::make_unique<ChosenPatterns>(patterns.rig);
  }
  const bool leads = cluster.rank() == 0;
  if (leads && !options.capture) sayKeys(KeysOf::patterns);
  Lead lead{*source, KeysOf::patterns, {}};
  lead.controls.walls.shown = Shown::calibrationPattern;
  World nothing;
  NodeLock lock = patterns.walls->lockSwaps(patterns.rig.frameLock);
  runFrames({cluster, *patterns.graphics, *patterns.walls, nothing, *patterns.recording, lock,
             patterns.rig.display_hz, !options.capture},
            leads ? &lead : nullptr);
  patterns.recording->finish();
  if (leads && options.capture) log::note(fmt::format("The pictures are in {}.", options.capture->string()));
}

}  // namespace

int runPattern(const PatternOptions& options) {
  return runOnCluster([&](Cluster& cluster) {
    Patterns patterns = openPatterns(cluster, options);
    showPatterns(cluster, patterns, options);
  });
}

}  // namespace carom
