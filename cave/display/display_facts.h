#pragma once
// What the X display of a node offers: its monitors, OpenGL, and who else draws on it.

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "cave/gl/graphics.h"

namespace carom {

struct MonitorFacts {
  std::string name;  ///< of the output, such as "DP-1"
  glm::ivec2 size_px{0}, position_px{0};
  int rate_hz = 0;
};

struct DisplayFacts {
  std::string display;         ///< such as ":0"
  bool isXwayland = false;     ///< a Wayland compositor draws what X programs show
  bool hasCompositor = false;  ///< a compositor redraws all windows, a frame later
  std::string openGl;          ///< version
  std::string renderer;
  bool hasQuadBuffer = false;  ///< a window with a left and a right buffer can be opened
  std::vector<MonitorFacts> monitors;
};

/// Returns the facts of the display on which `graphics` draws. Opens a hidden window for a moment.
DisplayFacts displayFacts(const Graphics& graphics);

}  // namespace carom
