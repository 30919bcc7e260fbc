#include "app/frame_loop.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>

namespace carom {
namespace {

Head headOf(const HeadEstimate& estimate) { return {estimate.pose, estimate.celerity_m_s}; }

/// The latest board time at which an eye receives light.
double latestObservation_s(const ObserverView& observer) {
  double latest_s = observer.eyes.front().observation.t_s;
  for (const EyeView& eye : observer.eyes) latest_s = std::max(latest_s, eye.observation.t_s);
  return latest_s;
}

/// The person and the game at the frame's display time, as the record that all ranks will hold.
void decide(Play& play, FrameState& state) {
  const FrameTimes times = play.pacer.next();
  const HeadEstimate head = play.head.at(times);
  play.observer.step(times.step_s, headOf(head));
  const ObserverView observer = play.observer.view(play.eyeSeparation_m);
  state.record = {};
  play.game.advance(latestObservation_s(observer), state);
  state.record.number = times.number;
  state.record.display_s = times.display_s;
  state.record.observer = observer;
  state.record.last = play.frames && times.number + 1 >= *play.frames;
}

/// A line now and then while a session of given length runs.
void sayHowFar(const Play& play, const FrameRecord& record) {
  if (play.frames && (record.number + 1) % 30 == 0) {
    fmt::print(stderr, "frame {} of {}\n", record.number + 1, *play.frames);
  }
}

/// Someone at this node wants the session to end: Escape, Q, or the window's own button.
bool wantsToEnd(Graphics& graphics) {
  const WindowInput& input = graphics.poll();
  return input.closeRequested || std::any_of(input.keys.begin(), input.keys.end(), [](const KeyInput& key) {
           return key.pressed && (key.key == GLFW_KEY_ESCAPE || key.key == GLFW_KEY_Q);
         });
}

}  // namespace

void runFrames(Node& node, Play* play) {
  FrameState state;
  bool ended = false;
  while (!ended) {
    if (play) decide(*play, state);
    node.cluster.share(state);
    applyFrame(state, node.histories);
    node.walls.draw(state.record.observer, node.histories);
    node.walls.show();
    if (node.capture) node.walls.capture(*node.capture, state.record.number);
    const bool wanted = node.cluster.firstFailed(wantsToEnd(node.graphics)) >= 0;
    node.cluster.swapTogether(state, digestOf(state, node.histories));
    node.walls.swap();
    if (play) sayHowFar(*play, state.record);
    ended = wanted || state.record.last;
  }
}

}  // namespace carom
