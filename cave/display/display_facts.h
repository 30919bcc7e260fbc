#pragma once
// What the X display of a node offers: its monitors, OpenGL, and who else draws on it.

#include <string>
#include <vector>

#include "cave/display/monitors.h"
#include "cave/gl/graphics.h"

namespace carom {

struct DisplayFacts {
  std::string display;         ///< such as ":0"
  bool isXwayland = false;     ///< a Wayland compositor draws what X programs show
  bool hasCompositor = false;  ///< a compositor redraws all windows, a frame later
  std::string compositor;      ///< its name, or that of the window manager, as far as they say
  std::string openGl;          ///< version
  std::string renderer;
  bool hasQuadBuffer = false;  ///< a window with a left and a right buffer can be opened
  std::string noSwapGroup;     ///< why windows cannot join a swap group and its barrier; empty if they can
  std::vector<Monitor> monitors;
};

/// Returns the facts of the display on which `graphics` draws. Opens a hidden window for a moment.
DisplayFacts displayFacts(const Graphics& graphics);

}  // namespace carom
