#pragma once
// Who wants to know of every frame that is on the walls: journal, recording, sounds, statistics, console.

#include "app/session/decision.h"

namespace carom {

class FrameListener {
 public:
  virtual ~FrameListener() = default;

  /// The frame is on the walls, and the world is as it brought it. On ranks other than 0 the decision has its
  /// frame alone.
  virtual void shown(const Decision& decision) = 0;
};

}  // namespace carom
