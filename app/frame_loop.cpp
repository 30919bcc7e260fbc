#include "app/frame_loop.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/keys.h"

namespace carom {
namespace {

constexpr std::uint64_t kFramesBetweenForgetting = 600;  // ten seconds at 60 Hz

/// The latest board time at which an eye receives light.
double latestObservation_s(const ObserverView& observer) {
  double latest_s = observer.eyes.front().observation.t_s;
  for (const EyeView& eye : observer.eyes) latest_s = std::max(latest_s, eye.observation.t_s);
  return latest_s;
}

/// The person and the game at the frame's display time, as the record that all ranks will hold.
void decide(Play& play, std::span<const WorldLine> histories, FrameState& state) {
  const FrameTimes times = play.pacer.next();
  const ObserverView observer = play.person.at(times, play.eyeSeparation_m);
  state.record = {};
  play.game.advance(latestObservation_s(observer), state);
  if (times.number % kFramesBetweenForgetting == 0) play.game.forget(histories, observer, state);
  state.record.number = times.number;
  state.record.display_s = times.display_s;
  state.record.observer = observer;
  state.record.last = play.lastFrame && times.number >= *play.lastFrame;
  state.record.switches = play.switches;
  state.record.controls = play.controls;
}

void obeyKeys(Play& play, const WindowInput& input) {
  turnSwitches(input, play.switches);
  steerWalls(input, play.controls);
  setEyesApart(input, play.eyeSeparation_m);
}

/// The frame is on the walls.
void finish(Play& play, const FrameState& state) {
  play.pacer.swapped();
  if (play.journal) play.journal->add(state, play.person.head(), play.person.samples());
  const std::uint64_t shown = state.record.number + 1;
  if (play.lastFrame && shown % 30 == 0) fmt::print(stderr, "frame {} of {}\n", shown, *play.lastFrame + 1);
}

}  // namespace

void runFrames(const Node& node, Play* play) {
  Stage& stage = node.stage;
  FrameState state;
  bool ended = false;
  while (!ended) {
    if (play) decide(*play, stage.histories, state);
    node.cluster.share(state);
    applyFrame(state, stage.histories);
    stage.walls->draw(state.record, stage.histories);
    stage.walls->show();
    if (node.capture) stage.walls->capture(*node.capture, state.record.number);
    const WindowInput& input = stage.graphics->poll();
    if (play) obeyKeys(*play, input);
    const bool wanted = node.cluster.swapTogether(state, stage.histories, wantsToEnd(input), [play] {
      if (play) play->pacer.drawn();
    });
    stage.walls->swap();
    if (play) finish(*play, state);
    ended = wanted || state.record.last;
  }
}

}  // namespace carom
