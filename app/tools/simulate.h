#pragma once
// `carom simulate`: lists every collision of a scenario's game, and optionally its states.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/spacetime/event.h"

namespace CLI {
class App;
}

namespace carom {

/// A place of a puck's matter, from the centre of the relaxed puck.
struct PuckPoint {
  std::string puck;
  glm::dvec2 offset_m{0.0};
};

struct SimulateOptions {
  std::filesystem::path scenario;
  double until_s = 0.0;           ///< board time, not negative
  std::optional<double> every_s;  ///< interval of the states to list: at 0, every_s, 2 every_s, …
  std::vector<PuckPoint> points;  ///< to be followed
  std::optional<std::filesystem::path> json;  ///< if empty, a readable table on standard output
};

/// Largest number of states in one run.
inline constexpr double kMostStates = 1e6;

/// Largest number of collisions in one run; each needs about 4 kB while the JSON is made.
inline constexpr std::size_t kMostCollisions = 1200000;

/// Returns the exit status. Throws InputErrors for an invalid scenario.
int runSimulate(const SimulateOptions& options);

/// Adds the command to `app`. When it runs, it stores its exit status in `status`.
void addSimulate(CLI::App& app, int& status);

}  // namespace carom
