#pragma once
// A wall of the room as the rig file gives it: where it stands, its pixels, who draws it and how its two
// eyes reach the person. Room frame, metres.

#include <string>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace carom {

enum class Eye { left, right, mono };

enum class StereoMode {
  mono,
  left,
  right,
  quadBuffer,
  sideBySide,
  topBottom,
  anaglyph,
  interlaced,
  checkerboard,
};

/// Where a visible window lies on its monitor (or, in a rig with one window for all walls, where the
/// wall's picture lies in that window). Pixels from the top left.
struct WindowPlacement {
  int monitor = 0;
  glm::ivec2 position_px{0};
  glm::ivec2 size_px{0};
  bool fullscreen = false;
};

/// A rectangle by three of its corners, as seen from inside the room.
struct Wall {
  std::string name;
  glm::dvec3 lowerLeft_m{0.0};
  glm::dvec3 lowerRight_m{0.0};
  glm::dvec3 upperLeft_m{0.0};
  glm::ivec2 pixels{0};  ///< per eye: what is drawn and captured
  int node = 0;          ///< MPI rank that draws it
  WindowPlacement window;
  StereoMode stereo = StereoMode::mono;
};

}  // namespace carom
