#pragma once
// The interface of everything that draws and shows each frame.

#include "cave/record/frame_state.h"

namespace carom {

class View {
 public:
  virtual ~View() = default;

  /// Draws the frame into the back buffer.
  virtual void draw(const FrameRecord& record, const World& world) = 0;
  /// Shows the drawn frame; called once every node has drawn it.
  virtual void swap() {}
};

}  // namespace carom
