#pragma once
// `carom filter`: a recorded trace through the head filter of a session.

#include <filesystem>
#include <optional>

namespace CLI {
class App;
}

namespace carom {

struct FilterOptions {
  std::filesystem::path trace;
  double lightSpeed_m_s = 1.42;              ///< for what the eye would see of it
  std::optional<std::filesystem::path> csv;  ///< none: a summary for people on standard output
};

/// One row out for each row in, made of that row and those before it. Returns the exit status. Throws
/// InputError for a bad trace.
int runFilter(const FilterOptions& options);

/// Adds the command to `app`; when it is called, its exit status is left in `status`.
void addFilter(CLI::App& app, int& status);

}  // namespace carom
