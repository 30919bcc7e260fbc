#include "app/rig/traces.h"

#include <fmt/format.h>

#include <sstream>
#include <string>
#include <system_error>
#include <utility>

#include "app/toml/toml_file.h"
#include "engine/text/log.h"

namespace carom {

std::vector<TrackerSample> readBeginning(const std::filesystem::path& trace, std::uintmax_t most_bytes) {
  std::string rows = beginningOf(trace, InputKind::trace, static_cast<std::size_t>(most_bytes));
  if (rows.size() == most_bytes) rows.resize(rows.rfind('\n') + 1);
  std::istringstream in(std::move(rows));
  return readTrace(in, trace.string());
}

void openTraces(const Rig& rig, std::uintmax_t most_bytes) {
  std::vector<InputError> faults;
  for (const TrackerSetup& tracker : rig.trackers) {
    if (tracker.kind != TrackerKind::recorded) continue;
    try {
      std::error_code failed;
      const std::uintmax_t bytes = std::filesystem::file_size(tracker.source, failed);
      if (failed || bytes <= most_bytes) {
        readTrace(tracker.source);
        continue;
      }
      readBeginning(tracker.source, most_bytes);
      log::warn(fmt::format("{}:1:1: is large, {} MiB: its first {} MiB were read here, a session reads all",
                            tracker.source.string(), bytes >> 20U, most_bytes >> 20U));
    } catch (const InputError& fault) {
      faults.push_back(fault);
    }
  }
  if (!faults.empty()) throw InputErrors(std::move(faults));
}

}  // namespace carom
