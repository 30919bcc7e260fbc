#pragma once
// `carom simulate`: every collision of a scenario's game and its states.

#include <cstddef>
#include <filesystem>
#include <optional>

namespace CLI {
class App;
}

namespace carom {

struct SimulateOptions {
  std::filesystem::path scenario;
  double until_s = 0.0;                       ///< board time, not negative
  std::optional<double> every_s;              ///< also the states at 0, every_s, 2 every_s, …
  std::optional<std::filesystem::path> json;  ///< none: a table for people on standard output
};

/// The most states that one run gives out.
inline constexpr double kMostStates = 1e6;

/// The most collisions that one run keeps, about 4 kB each while the JSON is made.
inline constexpr std::size_t kMostCollisions = 1200000;

/// Returns the exit status. Throws InputErrors for a bad scenario.
int runSimulate(const SimulateOptions& options);

/// Adds the command to `app`; when it is called, its exit status is left in `status`.
void addSimulate(CLI::App& app, int& status);

}  // namespace carom
