#pragma once
// The console's clocks, and of a recorded session the way through it.

#include "app/console/console_parts.h"

namespace carom::console {

/// One line: what the clocks show, how the platform moves.
void drawClocks(const ConsoleFrame& frame);

/// Of a recorded session: to and fro, slower and faster, and a slider over all of it where its ends are
/// known.
class Playing {
 public:
  void draw(const ConsoleFrame& frame);

 private:
  PatientSlider slider_;
};

}  // namespace carom::console
