#pragma once
// The spacetime diagram of the running session, in a separate window on rank 0.

#include "app/console/live_diagram.h"
#include "app/session/view.h"
#include "cave/display/window.h"
#include "cave/record/frame_state.h"

namespace carom {

class DiagramWindow : public View {
 public:
  DiagramWindow(Graphics& graphics, const WindowPlacement& place, const Scenario& scenario,
                std::vector<std::string> viewers);

  /// Switches to another game.
  void play(const Scenario& scenario) { diagram_.play(scenario); }

  void draw(const FrameRecord& record, const World& world) override;
  void swap() override { window_.swap(); }
  ScreenPlace place() const { return window_.place(); }

 private:
  Window window_;
  LiveDiagram diagram_;
};

}  // namespace carom
