#pragma once
// Owners of OpenGL objects. Each owner creates its object in the current context, can be moved but not
// copied, converts to the object's name, and deletes the object when it is destroyed: with a context current
// that owns or shares the object. A moved-from owner holds the name 0, which OpenGL never deletes.

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <span>
#include <utility>

namespace carom {

enum class GlKind { buffer, vertexArray, texture, framebuffer, renderbuffer, program, query };
unsigned createGlObject(GlKind kind);
void deleteGlObject(GlKind kind, unsigned name);

template <GlKind kind>
class GlObject {
 public:
  GlObject() : name_(createGlObject(kind)) {}
  ~GlObject() {
    if (name_ != 0) deleteGlObject(kind, name_);
  }
  GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }

  operator unsigned() const& { return name_; }
  operator unsigned() const&& = delete;  // the object would be gone before its name is used

 private:
  unsigned name_;
};
using GlBuffer = GlObject<GlKind::buffer>;
using GlVertexArray = GlObject<GlKind::vertexArray>;  ///< never shared between contexts
using GlTexture = GlObject<GlKind::texture>;
using GlFramebuffer = GlObject<GlKind::framebuffer>;  ///< never shared between contexts
using GlRenderbuffer = GlObject<GlKind::renderbuffer>;
using GlProgram = GlObject<GlKind::program>;
using GlQuery = GlObject<GlKind::query>;  ///< never shared between contexts

/// A fence among the commands of a context (OpenGL's GLsync), or null.
struct GlFenceDeleter {
  void operator()(void* sync) const;
};
using GlFence = std::unique_ptr<void, GlFenceDeleter>;
/// Places a fence behind all commands that were given to the current context so far.
GlFence placeFence();

/// One input of a program: the vec`size` named `name` is read `offset` bytes into each vertex.
struct VertexAttribute {
  const char* name;
  int size;
  std::size_t offset;
};

/// A vertex array that reads one buffer of vertices, each `stride` bytes. Create and
/// upload it while no vertex array is bound; afterwards neither that nor an array buffer is.
class VertexBuffer {
 public:
  VertexBuffer(const GlProgram& program, std::size_t stride,
               std::initializer_list<VertexAttribute> attributes);

  /// Replaces all vertices.
  void upload(std::span<const std::byte> vertices);
  /// Binds the vertex array, for glDrawArrays and glDrawElements.
  void bind() const;

 private:
  GlVertexArray array_;
  GlBuffer buffer_;
};

/// The same for vertices of one type.
template <typename Vertex>
class VertexStream {
 public:
  VertexStream(const GlProgram& program, std::initializer_list<VertexAttribute> attributes)
      : buffer_(program, sizeof(Vertex), attributes) {}

  void upload(std::span<const Vertex> vertices) { buffer_.upload(std::as_bytes(vertices)); }
  void bind() const { buffer_.bind(); }

 private:
  VertexBuffer buffer_;
};

}  // namespace carom
