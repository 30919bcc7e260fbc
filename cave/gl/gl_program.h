#pragma once
// Small OpenGL programs, each made from two shader texts.

#include <span>
#include <string>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "cave/gl/gl_objects.h"

namespace carom {

/// Compiles and links a program in the current context. The inputs of its vertices that are named get the
/// locations 0, 1 and so on, so that several programs can share a vertex array. Throws std::runtime_error
/// with the compiler's message.
GlProgram makeProgram(const std::string& name, const std::string& vertexText, const std::string& fragmentText,
                      std::span<const char* const> inputs = {});

/// Sets the uniform `name` of the program, which is in use; OpenGL takes single precision.
void setUniform(const GlProgram& program, const char* name, int value);
void setUniform(const GlProgram& program, const char* name, float value);
void setUniform(const GlProgram& program, const char* name, const glm::dvec3& value);
void setUniform(const GlProgram& program, const char* name, const glm::vec4& value);
void setUniform(const GlProgram& program, const char* name, const glm::dmat3& value);
void setUniform(const GlProgram& program, const char* name, const glm::dmat4& value);

}  // namespace carom
