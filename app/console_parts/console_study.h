#pragma once
// The console's panel for a study: a code is typed here, and it shows how far everybody is.

#include <array>

#include "app/console_parts/console_parts.h"

namespace carom::console {

class StudyPanel {
 public:
  /// Draws the panel. There must be a study.
  void draw(const ConsoleFrame& frame);

 private:
  std::array<char, 16> code_{};
};

}  // namespace carom::console
