#pragma once
// The spacetime diagram of the session at hand, in a window of its own on the first node.

#include "app/session/live_diagram.h"
#include "cave/display/window.h"
#include "cave/frame/frame_state.h"

namespace carom {

class DiagramWindow {
 public:
  DiagramWindow(Graphics& graphics, const Scenario& scenario);

  /// Another game.
  void play(const Scenario& scenario) { diagram_.play(scenario); }

  /// Draws it; `swap` makes it visible.
  void show(const FrameRecord& record, const World& world);
  void swap() { window_.swap(); }

 private:
  Window window_;
  LiveDiagram diagram_;
};

}  // namespace carom
