#pragma once
// The recorded traces that a rig plays.

#include "app/files/rig.h"

namespace carom {

/// Opens the trace of every recorded tracker before a session needs it. Throws InputErrors with the fault of
/// each that cannot be read.
void openTraces(const Rig& rig);

}  // namespace carom
