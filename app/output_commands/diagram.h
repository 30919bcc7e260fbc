#pragma once
// `carom diagram`: the spacetime diagram of a scenario or of a recorded session.

#include <filesystem>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace carom {

struct DiagramOptions {
  std::filesystem::path source;     ///< a scenario or a session file
  std::optional<std::size_t> game;  ///< of a session, from 1; by default the newest
  std::filesystem::path figure;     ///< .svg or .png
  std::string language;             ///< of its words; empty: as the first viewer read at first
  char along = 'x';                 ///< the board axis shown beside time: x or y
  /// Board time at the lower edge; by default 5 s before `until_s`, at least 0.
  std::optional<double> from_s;
  std::optional<double>
      until_s;  ///< board time of the present event, at the upper third; by default 5 s, or the session's end
};

/// Draws all world lines with the observer's, and at the observer's present event the light cones and the
/// observer's axes of time and of simultaneity. Light is at 45°. Returns the exit status. Throws InputErrors
/// or std::runtime_error.
int runDiagram(const DiagramOptions& options);

/// Adds the command to `app`. When it runs, it stores its exit status in `status`.
void addDiagram(CLI::App& app, int& status);

}  // namespace carom
