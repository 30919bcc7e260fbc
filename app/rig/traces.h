#pragma once
// The recorded traces that a rig plays.

#include <cstdint>
#include <filesystem>
#include <limits>
#include <vector>

#include "app/rig/rig.h"
#include "devices/tracker/trace.h"

namespace carom {

/// Opens the trace of every recorded tracker before a session needs it. Throws InputErrors with the fault of
/// each that cannot be read. Of a trace larger than `most_bytes` only the beginning is read, and a warning
/// says so.
void openTraces(const Rig& rig, std::uintmax_t most_bytes = std::numeric_limits<std::uintmax_t>::max());

/// Returns the samples in the first bytes of a trace. Throws InputError as readTrace does.
std::vector<TrackerSample> readBeginning(const std::filesystem::path& trace, std::uintmax_t most_bytes);

}  // namespace carom
