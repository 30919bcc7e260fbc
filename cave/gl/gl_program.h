#pragma once
// A small OpenGL program from its two texts.

#include <string>

#include "cave/gl/gl_objects.h"

namespace carom {

/// Compiles and links in the current context; throws std::runtime_error with the compiler's message.
GlProgram makeProgram(const std::string& name, const std::string& vertexText,
                      const std::string& fragmentText);

}  // namespace carom
