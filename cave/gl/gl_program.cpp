#include "cave/gl/gl_program.h"

#include <stdexcept>

#include <vtk_glew.h>

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
  glDeleteShader(shader);  // lives on with the program
}

}  // namespace

unsigned makeProgram(const std::string& name, const std::string& vertexText,
                     const std::string& fragmentText) {
  const GLuint program = glCreateProgram();
  compileInto(program, name, GL_VERTEX_SHADER, vertexText);
  compileInto(program, name, GL_FRAGMENT_SHADER, fragmentText);
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

void setAttribute(unsigned program, const char* name, int size, std::size_t stride, std::size_t offset) {
  const auto location = static_cast<GLuint>(glGetAttribLocation(program, name));
  glEnableVertexAttribArray(location);
  glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                        reinterpret_cast<const void*>(offset));
}

}  // namespace carom
