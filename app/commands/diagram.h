#pragma once
// `carom diagram`: the spacetime diagram of a scenario or of a recorded session.

#include <filesystem>
#include <optional>

namespace CLI {
class App;
}

namespace carom {

struct DiagramOptions {
  std::filesystem::path source;  ///< a scenario, or a session file
  std::filesystem::path figure;  ///< .svg or .png
  char along = 'x';              ///< the board's axis that is shown beside time: x or y
  std::optional<double> from_s;  ///< board time at the lower edge; none: 5 s before `until_s`, at least 0
  std::optional<double>
      until_s;  ///< of the present event, at the upper third; none: 5 s, or the session's end
};

/// Draws the world lines, mine among them, and at my present event its light cones and my axes: my time and
/// my now. Light goes at 45°. Returns the exit status; throws InputErrors or std::runtime_error.
int runDiagram(const DiagramOptions& options);

/// Adds the command to `app`; when it is called, its exit status is left in `status`.
void addDiagram(CLI::App& app, int& status);

}  // namespace carom
