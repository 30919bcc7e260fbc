#pragma once
// The console's recording panel: session file, images and movie.

#include <cstdint>
#include <filesystem>
#include <optional>

#include "app/console_parts/console_parts.h"

namespace carom::console {

class RecordingPanel {
 public:
  /// Sets the session file that is written from now on; none if the session is not recorded.
  void writeTo(const std::optional<std::filesystem::path>& file) { file_ = file; }

  /// Draws a short status for the top of the console.
  void drawLight(const ConsoleFrame& frame) const;
  void draw(const ConsoleFrame& frame);

 private:
  void drawButtons(const ConsoleFrame& frame, const RecordingReport& report) const;

  std::optional<std::filesystem::path> file_;
  std::uintmax_t bytes_ = 0;
  double measured_s_ = -1.0;  ///< session clock
};

}  // namespace carom::console
