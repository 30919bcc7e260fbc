#pragma once
// The console's panel for the teacher of a class that answers by phone: how to join, how many have answered,
// and the same steps as on the teacher's page.

#include "app/console_parts/console_parts.h"

namespace carom::console {

/// Draws the panel. A class must take part.
void drawClass(const ConsoleFrame& frame);

}  // namespace carom::console
