#include "app/files/traces.h"

#include <vector>

#include "app/files/toml_file.h"
#include "devices/tracker/trace.h"

namespace carom {

void openTraces(const Rig& rig) {
  std::vector<InputError> faults;
  for (const TrackerSetup& tracker : rig.trackers) {
    if (tracker.kind != TrackerKind::recorded) continue;
    try {
      readTrace(tracker.source);
    } catch (const InputError& fault) {
      faults.push_back(fault);
    }
  }
  if (!faults.empty()) throw InputErrors(std::move(faults));
}

}  // namespace carom
