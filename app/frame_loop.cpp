#include "app/frame_loop.h"

#include <fmt/format.h>

#include "app/frame_watch.h"

namespace carom {
namespace {

constexpr std::uint64_t kFramesBetweenNews = 30;

/// The operator's wishes take effect with the next frame.
void obey(Lead& lead, const WindowInput& input, const FrameState& state) {
  // Keys change what is shown: in a recording, what it says.
  lead.controls.switches = state.record.switches;
  lead.controls.walls = state.record.controls;
  lead.controls.views = state.record.views;
  const Controls before = lead.controls;
  obeyKeys(input, lead.keys, state.record.display_s, lead.controls);
  for (const ControlChange& change : changesOf(before, lead.controls)) {
    fmt::print(stderr, "{}: {}\n", change.what, change.value);
    lead.source.changed(state.record.number, change);
  }
  if (asksForKeys(input)) sayKeys(lead.keys);
}

/// For who waits for frames that nobody watches.
void sayProgress(const FrameSource& source, std::uint64_t shown) {
  if (shown % kFramesBetweenNews != 0) return;
  const std::optional<std::uint64_t> end = source.end();
  fmt::print(stderr, "frame {}{}\n", shown, end ? fmt::format(" of {}", *end) : "");
}

}  // namespace

Node nodeOf(Cluster& cluster, Stage& stage) {
  return {cluster,    *stage.graphics,      *stage.walls,  stage.world, *stage.recording,
          stage.lock, stage.rig.display_hz, stage.realTime, stage.outside.get(), stage.diagram.get()};
}

Controls controlsAtStart(const Stage& stage) {
  Controls controls;
  controls.eyeSeparation_m = stage.rig.head.eyeSeparation_m;
  controls.lightSpeed_m_s = stage.scenario.billiard.lightSpeed_m_s;
  return controls;
}

void runFrames(const Node& node, Lead* lead) {
  FrameState state;
  FrameWatch watch(node.cluster, node.lock, node.display_hz);
  bool ended = false;
  while (!ended) {
    watch.begin();
    if (lead) {
      lead->source.next(lead->controls, state);
      watch.decided(lead->source.deciding());
    }
    node.cluster.share(state);
    watch.mark(FramePart::share);
    applyFrame(state, node.world);
    node.walls.draw(state.record, node.world);
    if (node.outside) node.outside->draw(state.record, node.world.histories, node.walls);
    node.walls.show(watch.view(state.record));
    if (node.outside) node.outside->show();
    if (node.diagram) node.diagram->show(state.record, node.world);
    node.recording.take(node.walls, node.outside, state.record);
    watch.mark(FramePart::submit);
    if (node.realTime) {
      node.walls.awaitShown();  // so that the swap follows the others' at once
      watch.mark(FramePart::draw);
    }
    const WindowInput& input = node.graphics.poll();
    if (lead) obey(*lead, input, state);
    const bool wanted = node.cluster.swapTogether(state, node.world, wantsToEnd(input), [lead] {
      if (lead) lead->source.drawn();
    });
    watch.mark(FramePart::wait);
    node.walls.swap();
    if (node.outside) node.outside->swap();
    if (node.diagram) node.diagram->swap();
    watch.swapped(state.record, lead && node.realTime ? &lead->source : nullptr);
    if (lead) lead->source.shown(state);
    ended = wanted || state.record.last;
    if (lead && !node.realTime) sayProgress(lead->source, state.record.number + 1);
  }
  if (lead && lead->keys == KeysOf::session && node.realTime) watch.sayHowItWent();
}

}  // namespace carom
