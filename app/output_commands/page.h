#pragma once
// `carom page`: a visit as one page for a browser.

#include <filesystem>
#include <string>

#include "app/page/visit.h"

namespace CLI {
class App;
}

namespace carom {

struct PageOptions {
  std::filesystem::path source;  ///< a session file or a scenario
  std::filesystem::path page;
  VisitOptions visit;
  std::string language;  ///< of its words; empty: as it was recorded
};

/// Writes the page, whole or not at all. Returns the exit status. Throws InputErrors or std::runtime_error.
int runPage(const PageOptions& options);

/// Adds the command to `app`. When it runs, it stores its exit status in `status`.
void addPage(CLI::App& app, int& status);

}  // namespace carom
