#include "cave/gl/gl_program.h"

#include <stdexcept>

#include <vtk_glew.h>
#include <glm/gtc/type_ptr.hpp>

namespace carom {
namespace {

void compileInto(GLuint program, const std::string& name, GLenum stage, const std::string& text) {
  const GLuint shader = glCreateShader(stage);
  const char* source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled != GL_TRUE) {
    std::string message(4096, '\0');
    glGetShaderInfoLog(shader, static_cast<GLsizei>(message.size()), nullptr, message.data());
    glDeleteShader(shader);
    throw std::runtime_error("shader \"" + name + "\" does not compile: " + message.c_str());
  }
  glAttachShader(program, shader);
  glDeleteShader(shader);  // the program keeps it alive
}

}  // namespace

GlProgram makeProgram(const std::string& name, const std::string& vertexText, const std::string& fragmentText,
                      std::span<const char* const> inputs) {
  GlProgram program;
  compileInto(program, name, GL_VERTEX_SHADER, vertexText);
  compileInto(program, name, GL_FRAGMENT_SHADER, fragmentText);
  GLuint location = 0;
  for (const char* input : inputs) glBindAttribLocation(program, location++, input);
  glLinkProgram(program);
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) {
    std::string message(4096, '\0');
    glGetProgramInfoLog(program, static_cast<GLsizei>(message.size()), nullptr, message.data());
    throw std::runtime_error("shader \"" + name + "\" does not link: " + message.c_str());
  }
  return program;
}

void setUniform(const GlProgram& program, const char* name, int value) {
  glUniform1i(glGetUniformLocation(program, name), value);
}

void setUniform(const GlProgram& program, const char* name, float value) {
  glUniform1f(glGetUniformLocation(program, name), value);
}

void setUniform(const GlProgram& program, const char* name, const glm::dvec3& value) {
  glUniform3fv(glGetUniformLocation(program, name), 1, glm::value_ptr(glm::vec3(value)));
}

void setUniform(const GlProgram& program, const char* name, const glm::vec4& value) {
  glUniform4fv(glGetUniformLocation(program, name), 1, glm::value_ptr(value));
}

void setUniform(const GlProgram& program, const char* name, const glm::dmat3& value) {
  glUniformMatrix3fv(glGetUniformLocation(program, name), 1, GL_FALSE, glm::value_ptr(glm::mat3(value)));
}

void setUniform(const GlProgram& program, const char* name, const glm::dmat4& value) {
  glUniformMatrix4fv(glGetUniformLocation(program, name), 1, GL_FALSE, glm::value_ptr(glm::mat4(value)));
}

}  // namespace carom
