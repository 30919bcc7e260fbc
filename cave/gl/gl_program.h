#pragma once
// A small OpenGL program from its two texts.

#include <cstddef>
#include <string>

namespace carom {

/// Compiles and links in the current context; throws std::runtime_error with the compiler's message.
unsigned makeProgram(const std::string& name, const std::string& vertexText, const std::string& fragmentText);

/// Of the bound vertex array: the program's input `name` takes `size` floats from the bound buffer, `offset`
/// bytes into each of its corners, which are `stride` bytes.
void setAttribute(unsigned program, const char* name, int size, std::size_t stride, std::size_t offset);

}  // namespace carom
