#pragma once
// The shader texts for drawing bodies, put together from their files.

#include <string>

#include "cave/scene.h"

namespace carom {

/// The emission kernel as GLSL with all it needs. `oneLeg`: for bodies that never turn, whose legs beyond the
/// first the compiler may then leave out.
std::string emissionKernelText(bool oneLeg);

std::string bodyVertexShader(bool oneLeg, Paint paint);
std::string surfaceFragmentShader(Paint paint);

}  // namespace carom
