#pragma once
// The console's trackers: how each fares, and how the head is known.

#include "app/console/console_parts.h"

namespace carom::console {

/// Green, yellow or red: the worst of them.
const ImVec4& lightOfTrackers(const ConsoleFrame& frame);
void drawTrackers(const ConsoleFrame& frame);

}  // namespace carom::console
