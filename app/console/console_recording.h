#pragma once
// The console's recording: the session file, pictures and movie.

#include <cstdint>
#include <filesystem>
#include <optional>

#include "app/console/console_parts.h"

namespace carom::console {

class RecordingPanel {
 public:
  /// The session is written to this file from now on; none: it is not.
  void writeTo(const std::optional<std::filesystem::path>& file) { file_ = file; }

  /// In few words, for the top of the console.
  void drawLight(const ConsoleFrame& frame) const;
  void draw(const ConsoleFrame& frame);

 private:
  std::optional<std::filesystem::path> file_;
  std::uintmax_t bytes_ = 0;
  double measured_s_ = -1.0;  ///< session clock
};

}  // namespace carom::console
