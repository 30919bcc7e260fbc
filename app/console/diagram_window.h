#pragma once
// The spacetime diagram of the session at hand, in a window of its own on the first node.

#include "app/console/live_diagram.h"
#include "app/session/view.h"
#include "cave/display/window.h"
#include "cave/frame/frame_state.h"

namespace carom {

class DiagramWindow : public View {
 public:
  DiagramWindow(Graphics& graphics, const Scenario& scenario);

  /// Another game.
  void play(const Scenario& scenario) { diagram_.play(scenario); }

  void draw(const FrameRecord& record, const World& world) override;
  void swap() override { window_.swap(); }

 private:
  Window window_;
  LiveDiagram diagram_;
};

}  // namespace carom
