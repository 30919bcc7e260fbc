#pragma once
// The spacetime diagram of the session at hand, in a window of its own on the first node.

#include "app/spacetime_chart.h"
#include "cave/frame_state.h"
#include "cave/window.h"

namespace carom {

class DiagramWindow {
 public:
  DiagramWindow(Graphics& graphics, const Scenario& scenario);

  /// Draws it anew, some ten times a second, and shows it; `swap` makes it visible.
  void show(const FrameRecord& record, const World& world);
  void swap() { window_.swap(); }

 private:
  void follow(const FrameRecord& record, const World& world);

  Window window_;
  DiagramSubject subject_;
  Chart chart_;
  double drawn_s_ = -1.0;  ///< session clock
};

}  // namespace carom
