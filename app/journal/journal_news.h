#pragma once
// What a frame brings to the journal besides its record.

#include <cstddef>
#include <string>

#include "engine/billiard/billiard.h"

namespace carom {

/// A stroke made by hand.
struct HandStroke {
  Stroke stroke;
  std::size_t viewer = 0;  ///< whose hand it was, an index of the rig's viewers
};

/// What happened to a task (app/session/task_run.h).
struct TaskNews {
  std::string task;  ///< its name
  std::size_t viewer = 0;
  std::string event;      ///< begun, failed, solved
  int stars = 0;          ///< 1 to 3 where it is solved
  double energy_j = 0.0;  ///< of its strokes so far
};

}  // namespace carom
