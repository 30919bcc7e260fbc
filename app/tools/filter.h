#pragma once
// `carom filter`: passes a recorded trace through the head filter of a session.

#include <filesystem>
#include <optional>

namespace CLI {
class App;
}

namespace carom {

struct FilterOptions {
  std::filesystem::path trace;
  double lightSpeed_m_s = 1.42;              ///< for the aberration caused by velocity errors
  std::optional<std::filesystem::path> csv;  ///< if empty, a readable summary on standard output
};

/// Writes one row for each input row, computed from that row and the earlier ones. Returns the exit status.
/// Throws InputError if the trace is invalid.
int runFilter(const FilterOptions& options);

/// Adds the command to `app`. When it runs, it stores its exit status in `status`.
void addFilter(CLI::App& app, int& status);

}  // namespace carom
