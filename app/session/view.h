#pragma once
// What every frame is drawn into.

#include "cave/frame/frame_state.h"

namespace carom {

class View {
 public:
  virtual ~View() = default;

  /// Draws the frame, not yet visible.
  virtual void draw(const FrameRecord& record, const World& world) = 0;
  /// Makes it visible, once every node has drawn it.
  virtual void swap() {}
};

}  // namespace carom
