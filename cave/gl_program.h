#pragma once
// A small OpenGL program from its two texts.

#include <string>

namespace carom {

/// Compiles and links in the current context; throws std::runtime_error with the compiler's message.
unsigned makeProgram(const std::string& name, const std::string& vertexText, const std::string& fragmentText);

}  // namespace carom
