#pragma once
// The shader texts for drawing bodies, put together from their files.

#include <string>

#include "cave/scene/scene.h"
#include "engine/light/light_cone.h"
#include "engine/light/switches.h"

namespace carom {

/// What is known of the body's legs when the shader is compiled: the less it moves, the quicker.
enum class Legs {
  rest,  ///< one, at rest on the board
  one,   ///< one, straight
  many,  ///< any
};

/// The kernels of emission and colour as GLSL with all they need.
std::string kernelText(Legs legs);

/// One program for each state of the switches: what is off costs nothing. Bodies at a moment are drawn as
/// ghosts, whatever their paint.
std::string bodyVertexShader(Legs legs, Paint paint, const Switches& switches,
                             ViewTime moment = ViewTime::seen);
std::string surfaceFragmentShader(Paint paint, const Switches& switches, ViewTime moment = ViewTime::seen);

}  // namespace carom
