#pragma once
// The shader texts for drawing bodies, assembled from their files.

#include <algorithm>
#include <string>
#include <vector>

#include "cave/scene/scene.h"
#include "engine/light/light_cone.h"
#include "engine/light/switches.h"

namespace carom {

/// The legs for which a shader is compiled: the simpler they are, the faster the shader.
enum class Legs {
  rest,          ///< one leg, at rest on the board
  one,           ///< one straight leg
  oneSpinning,   ///< one straight leg of a body that turns evenly, its rim at no more than 0.99 c
  many,          ///< any number of legs of a body that does not spin
  manySpinning,  ///< any number of legs
  followed       ///< none: the body's points have been solved for (cave/render/seen_rows.h)
};

/// Returns the GLSL text of the emission and colour kernels with everything they need.
std::string kernelText(Legs legs);

/// Returns the shaders for one state of the switches: effects that are off cost nothing. Bodies at a moment
/// are drawn as ghosts, whatever their paint. With `followsLamps` the only light is that of lamps that go on,
/// as it arrives.
std::string bodyVertexShader(Legs legs, Paint paint, const Switches& switches,
                             ViewTime moment = ViewTime::seen, bool followsLamps = false);
std::string surfaceFragmentShader(Paint paint, const Switches& switches, ViewTime moment = ViewTime::seen,
                                  bool followsLamps = false);

/// Returns how far apart the stripes in the ghost of a body are, which reaches so far from its centre.
constexpr float ghostStripes_m(double reach_m) {
  constexpr float kMost_m = 0.08F;  // of large bodies
  return std::min(kMost_m, 0.5F * static_cast<float>(reach_m));
}

/// The same texts in parts, to be joined: most parts are those of many shaders.
using ShaderParts = std::vector<std::string>;
ShaderParts bodyVertexParts(Legs legs, Paint paint, const Switches& switches,
                            ViewTime moment = ViewTime::seen, bool followsLamps = false);
ShaderParts surfaceFragmentParts(Paint paint, const Switches& switches, ViewTime moment = ViewTime::seen,
                                 bool followsLamps = false);

}  // namespace carom
