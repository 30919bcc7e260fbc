#include "app/pattern.h"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <stdexcept>

#include "app/import.h"
#include "app/keys.h"
#include "app/rig.h"
#include "app/stage.h"
#include "cave/cluster.h"
#include "cave/pacer.h"

namespace carom {
namespace {

/// The walls of this rank; nothing else is in the scene.
struct Patterns {
  Rig rig;
  std::unique_ptr<Graphics> graphics;
  std::unique_ptr<WallSet> walls;
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
    if (options.capture) makeFolder(*options.capture);
  });
  cluster.agree("rig", textOf({options.rig, {}}));
  cluster.nameNodes(patterns.rig.walls);
  together(cluster, [&] {
    const Rig& rig = patterns.rig;
    patterns.graphics = std::make_unique<Graphics>(displayOf(rig, cluster.rank()));
    const double anyLightSpeed_m_s = 1.0;
    patterns.walls = std::make_unique<WallSet>(*patterns.graphics, Scene{}, anyLightSpeed_m_s,
                                               wallsOf(rig, cluster), rig.oneWindow, !options.capture);
  });
  return patterns;
}

void capturePatterns(Cluster& cluster, Patterns& patterns, const std::filesystem::path& folder) {
  FrameState state;
  for (std::uint64_t number = 0; number < 4; ++number) {
    state.record.number = number;
    state.record.controls.shown = number == 0 ? Shown::testPattern : Shown::seamPattern;
    state.record.display_s = number == 0 ? 0.0 : static_cast<double>(number - 1);
    cluster.share(state);
    patterns.walls->draw(state.record, {});
    together(cluster, [&] { patterns.walls->capture(folder, number); });
  }
  if (cluster.rank() == 0) fmt::print(stderr, "The pictures are in {}.\n", folder.string());
}

void showPatterns(Cluster& cluster, Patterns& patterns) {
  SteadyClock clock(std::chrono::steady_clock::now());
  Pacer pacer(clock, patterns.rig.display_hz, patterns.rig.displayLatency_s);
  const bool leads = cluster.rank() == 0;
  WallControls controls{Shown::testPattern};
  FrameState state;
  for (bool ended = false; !ended;) {
    if (leads) {
      const FrameTimes times = pacer.next();
      state.record.number = times.number;
      state.record.display_s = times.display_s;
      state.record.controls = controls;
    }
    cluster.share(state);
    patterns.walls->draw(state.record, {});
    patterns.walls->show();
    const WindowInput& input = patterns.graphics->poll();
    if (leads) steerWalls(input, controls, false);
    ended = cluster.swapTogether(state, {}, wantsToEnd(input), [&] {
      if (leads) pacer.drawn();
    });
    patterns.walls->swap();
    if (leads) pacer.swapped();
  }
}

}  // namespace

int runPattern(const PatternOptions& options) {
  return runOnCluster([&](Cluster& cluster) {
    Patterns patterns = openPatterns(cluster, options);
    if (options.capture) return capturePatterns(cluster, patterns, *options.capture);
    if (cluster.rank() == 0) sayPatternKeys();
    showPatterns(cluster, patterns);
  });
}

}  // namespace carom
