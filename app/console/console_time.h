#pragma once
// The console's clocks, and the playback controls of a recorded session.

#include "app/console/console_parts.h"

namespace carom::console {

/// Draws one line with the clocks and the platform's motion.
void drawClocks(const ConsoleFrame& frame);

/// The playback controls of a recorded session: direction, rate, and a slider over its duration if both ends
/// are known.
class Playing {
 public:
  void draw(const ConsoleFrame& frame);

 private:
  PatientSlider slider_;
};

}  // namespace carom::console
