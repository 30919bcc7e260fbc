#pragma once
// The console's clocks, and the playback controls of a recorded session.

#include "app/console/console_parts.h"

namespace carom::console {

/// Draws the clocks and the platform's motion, in lines of this width.
void drawClocks(const ConsoleFrame& frame, float width_px);

/// The playback controls of a recorded session: direction, rate, and a slider over its duration if both ends
/// are known.
class Playing {
 public:
  void draw(const ConsoleFrame& frame);

 private:
  PatientSlider slider_;
};

}  // namespace carom::console
