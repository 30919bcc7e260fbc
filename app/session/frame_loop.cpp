#include "app/session/frame_loop.h"

#include <fmt/format.h>

#include <functional>

#include "app/session/console_parts.h"
#include "app/session/frame_watch.h"
#include "cave/overlay/latency_overlay.h"
#include "engine/base/log.h"

namespace carom {
namespace {

constexpr std::uint64_t kFramesBetweenSignals = 30;

/// What has been changed since `lead.before` is said and written.
void tell(Lead& lead, std::uint64_t number, Console* console) {
  for (const ControlChange& change : changesOf(lead.before, lead.controls)) {
    const std::string line = fmt::format("{}: {}", change.what, change.value);
    log::note(line);
    if (console) console->say(line);
    lead.source.changed(number, change);
  }
}

/// The operator's wishes take effect with the next frame.
void obey(Lead& lead, const WindowInput& input, const FrameState& state, Console* console) {
  // Keys change what is shown: in a recording, what it says.
  lead.controls.switches = state.record.switches;
  lead.controls.walls = state.record.controls;
  lead.controls.views = state.record.views;
  lead.controls.lesson = state.record.lesson;
  lead.before = lead.controls;
  obeyKeys(input, lead.keys, state.record.display_s, lead.controls);
  tell(lead, state.record.number, console);
  if (!asksForKeys(input)) return;
  sayKeys(lead.keys);
  lead.showsKeys = !lead.showsKeys;
  if (console) console->showKeys();
}

/// What is drawn over the walls' windows; empty: nothing.
std::function<void()> overlay(const LatencyView* latency, const Lead* lead) {
  if (!latency && !(lead && lead->showsKeys)) return {};
  return [latency, lead] {
    if (latency) drawLatency(*latency);
    if (lead && lead->showsKeys) console::keysOver(lead->keyMap);
  };
}

/// For who waits for frames that nobody watches.
void sayProgress(const FrameSource& source, std::uint64_t shown) {
  if (shown % kFramesBetweenSignals != 0) return;
  const std::optional<std::uint64_t> end = source.end();
  log::note(fmt::format("frame {}{}", shown, end ? fmt::format(" of {}", *end) : ""));
}

}  // namespace

Node nodeOf(Cluster& cluster, Stage& stage) {
  return {cluster,
          *stage.graphics,
          *stage.walls,
          stage.world,
          *stage.recording,
          stage.lock,
          stage.rig.display_hz,
          stage.realTime,
          stage.outside.get(),
          stage.diagram.get(),
          stage.console.get()};
}

std::unique_ptr<Sounds> soundsOf(const Stage& stage, bool silent) {
  const RoomAxes& axes = stage.rig.axes;
  if (silent || !stage.realTime) return nullptr;
  return std::make_unique<Sounds>(SoundAxes{axes.right, axes.up, axes.forward});
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
      if (!lead->controls.play.empty()) state.record.last = 1;  // of this game
    }
    node.cluster.share(state);
    watch.mark(FramePart::share);
    applyFrame(state, node.world);
    node.walls.draw(state.record, node.world);
    if (node.outside) node.outside->draw(state.record, node.world.histories, node.walls);
    node.walls.show(overlay(watch.view(state.record), lead));
    if (node.outside) node.outside->show();
    if (node.diagram) node.diagram->show(state.record, node.world);
    node.recording.take(node.walls, node.outside, state.record);
    watch.mark(FramePart::submit);
    if (node.realTime) {
      node.walls.awaitShown();  // so that the swap follows the others' at once
      watch.mark(FramePart::draw);
    }
    const WindowInput& input = node.graphics.poll();
    if (lead) {
      obey(*lead, input, state, node.console);
      // In simulated time nobody plays: a run is then the same whatever lies on the desk.
      const bool asks = state.record.lesson.phase == LessonPhase::asks;
      if (node.realTime) lead->source.handled(lead->desk.gather(node.walls, input, asks));
    }
    const bool wanted = node.cluster.swapTogether(state, node.world, wantsToEnd(input), [lead] {
      if (lead) lead->source.drawn();
    });
    watch.mark(FramePart::wait);
    node.walls.swap();
    if (lead && lead->sounds) lead->sounds->shown(state.record, node.world.events);
    if (node.outside) node.outside->swap();
    if (node.diagram) node.diagram->swap();
    watch.swapped(state.record, lead && node.realTime ? &lead->source : nullptr);
    if (lead) lead->source.shown(state);
    if (lead && node.console) {
      lead->before = lead->controls;
      const LatencyView& latency = watch.numbers(state.record);
      node.console->show(
          {state.record, node.world, node.walls, latency, lead->source, node.recording, lead->keys},
          lead->controls);
      tell(*lead, state.record.number, node.console);
    }
    if (lead && wanted) lead->controls.play.clear();  // whoever wants to end wants no other game
    ended = wanted || state.record.last;
    if (lead && !node.realTime) sayProgress(lead->source, state.record.number + 1);
  }
  if (lead && lead->keys == KeysOf::session && node.realTime) watch.sayHowItWent();
}

}  // namespace carom
