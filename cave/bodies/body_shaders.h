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
  aroundTurn,    ///< two straight legs of a body that does not spin
  many,          ///< any number of legs of a body that does not spin
  manySpinning,  ///< any number of legs
  followed       ///< none: the body's points have been solved for (cave/bodies/seen_rows.h)
};

/// Returns the GLSL text of the emission and colour kernels with everything they need.
std::string kernelText(Legs legs);

/// What the shaders of a body are compiled for: effects that are off cost nothing. Bodies at a moment are
/// drawn as ghosts, whatever their paint.
struct BodyVariant {
  Legs legs = Legs::rest;
  Paint paint = Paint::plain;
  Switches switches;
  ViewTime moment = ViewTime::seen;
  bool followsLamps = false;  ///< the only light is that of lamps that go on, as it arrives
  bool isHot = false;         ///< its matter glows (cave/bodies/hot_bodies.h)

  bool operator==(const BodyVariant&) const = default;
};

/// Returns the shaders of a variant.
std::string bodyVertexShader(const BodyVariant& variant);
std::string surfaceFragmentShader(const BodyVariant& variant);

/// Returns how far apart the stripes in the ghost of a body are, which reaches so far from its centre.
constexpr float ghostStripes_m(double reach_m) {
  constexpr float kMost_m = 0.08F;  // of large bodies
  return std::min(kMost_m, 0.5F * static_cast<float>(reach_m));
}

/// The same texts in parts, to be joined: most parts are those of many shaders.
using ShaderParts = std::vector<std::string>;
ShaderParts bodyVertexParts(const BodyVariant& variant);
ShaderParts surfaceFragmentParts(const BodyVariant& variant);

}  // namespace carom
