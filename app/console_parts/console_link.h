#pragma once
// The console's panel of the other room of a linked game.

#include "app/console_parts/console_parts.h"

namespace carom::console {

/// Draws the panel. There must be a link.
void drawLink(const ConsoleFrame& frame);

}  // namespace carom::console
