#pragma once
// The interface of everything that is called after each displayed frame: journal, recording, sounds,
// statistics, console.

#include "app/live/decision.h"

namespace carom {

class FrameListener {
 public:
  virtual ~FrameListener() = default;

  /// Is called when the frame is on the walls and the world has been updated to it. On ranks other than 0
  /// only `decision.frame` is set.
  virtual void shown(const Decision& decision) = 0;
};

}  // namespace carom
