#pragma once
// The console's tracker panel: the state of each tracker, and how the head is known.

#include "app/console_parts/console_parts.h"

namespace carom::console {

/// Returns the status colour of the worst tracker: green, yellow or red.
const ImVec4& lightOfTrackers(const ConsoleFrame& frame);
void drawTrackers(const ConsoleFrame& frame);

}  // namespace carom::console
