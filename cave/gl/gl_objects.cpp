#include "cave/gl/gl_objects.h"

#include <vtk_glew.h>

namespace carom {
unsigned createGlObject(GlKind kind) {
  GLuint name = 0;
  switch (kind) {
    case GlKind::buffer:
      glGenBuffers(1, &name);
      break;
    case GlKind::vertexArray:
      glGenVertexArrays(1, &name);
      break;
    case GlKind::texture:
      glGenTextures(1, &name);
      break;
    case GlKind::framebuffer:
      glGenFramebuffers(1, &name);
      break;
    case GlKind::renderbuffer:
      glGenRenderbuffers(1, &name);
      break;
    case GlKind::program:
      name = glCreateProgram();
      break;
    case GlKind::query:
      glGenQueries(1, &name);
      break;
  }
  return name;
}

void deleteGlObject(GlKind kind, unsigned name) {
  switch (kind) {
    case GlKind::buffer:
      return glDeleteBuffers(1, &name);
    case GlKind::vertexArray:
      return glDeleteVertexArrays(1, &name);
    case GlKind::texture:
      return glDeleteTextures(1, &name);
    case GlKind::framebuffer:
      return glDeleteFramebuffers(1, &name);
    case GlKind::renderbuffer:
      return glDeleteRenderbuffers(1, &name);
    case GlKind::program:
      return glDeleteProgram(name);
    case GlKind::query:
      return glDeleteQueries(1, &name);
  }
}

void GlFenceDeleter::operator()(void* sync) const { glDeleteSync(static_cast<GLsync>(sync)); }

GlFence placeFence() { return GlFence(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0)); }

VertexBuffer::VertexBuffer(const GlProgram& program, std::size_t stride,
                           std::initializer_list<VertexAttribute> attributes) {
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  for (const VertexAttribute& attribute : attributes) {
    const auto location = static_cast<GLuint>(glGetAttribLocation(program, attribute.name));
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, attribute.size, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                          reinterpret_cast<const void*>(attribute.offset));
  }
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void VertexBuffer::upload(std::span<const std::byte> vertices) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size()), vertices.data(), GL_STREAM_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void VertexBuffer::bind() const { glBindVertexArray(array_); }

}  // namespace carom
