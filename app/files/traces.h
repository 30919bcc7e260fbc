#pragma once
// The recordings that a rig plays.

#include "app/files/rig.h"

namespace carom {

/// Opens every recorded tracker's trace, before a session needs it. Throws InputErrors with the fault of each
/// that cannot be read.
void openTraces(const Rig& rig);

}  // namespace carom
