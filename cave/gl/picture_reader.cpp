#include "cave/gl/picture_reader.h"

#include <algorithm>
#include <stdexcept>

#include <vtk_glew.h>

namespace carom {
namespace {

// RGBA: what cards hand over without converting it.
std::size_t bytesOf(const glm::ivec2& size_px) {
  return 4 * static_cast<std::size_t>(size_px.x) * static_cast<std::size_t>(size_px.y);
}

}  // namespace

PictureReader::~PictureReader() {
  for (const Asked& asked : asked_) {
    glDeleteSync(static_cast<GLsync>(asked.arrived));
    glDeleteBuffers(1, &asked.buffer);
  }
  for (const Asked& spare : spare_) glDeleteBuffers(1, &spare.buffer);
}

/// A buffer of this size, bound for packing.
unsigned PictureReader::bufferFor(std::size_t view, const glm::ivec2& size_px) {
  std::erase_if(spare_, [&](const Asked& spare) {
    const bool outgrown = spare.view == view && spare.size_px != size_px;
    if (outgrown) glDeleteBuffers(1, &spare.buffer);
    return outgrown;
  });
  const auto fits =
      std::find_if(spare_.begin(), spare_.end(), [&](const Asked& spare) { return spare.view == view; });
  unsigned buffer = 0;
  if (fits != spare_.end()) {
    buffer = fits->buffer;
    spare_.erase(fits);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
    return buffer;
  }
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
  glBufferData(GL_PIXEL_PACK_BUFFER, static_cast<GLsizeiptr>(bytesOf(size_px)), nullptr, GL_STREAM_READ);
  return buffer;
}

void PictureReader::ask(const RenderTarget& picture, std::size_t view) {
  GLint readBefore = 0;
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &readBefore);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture.framebuffer());
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  const glm::ivec2 size_px = picture.size_px();
  const unsigned buffer = bufferFor(view, size_px);
  glReadPixels(0, 0, size_px.x, size_px.y, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(readBefore));
  asked_.push_back({view, buffer, glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0), size_px});
}

void PictureReader::fetch(std::size_t most, const Fetch& fetched) {
  while (!asked_.empty()) {
    const Asked oldest = asked_.front();
    const GLuint64 patience_ns = asked_.size() > most ? GL_TIMEOUT_IGNORED : 0;
    const GLenum state =
        glClientWaitSync(static_cast<GLsync>(oldest.arrived), GL_SYNC_FLUSH_COMMANDS_BIT, patience_ns);
    if (state == GL_TIMEOUT_EXPIRED && patience_ns == 0) return;
    asked_.pop_front();
    glDeleteSync(static_cast<GLsync>(oldest.arrived));
    spare_.push_back({oldest.view, oldest.buffer, nullptr, oldest.size_px});
    glBindBuffer(GL_PIXEL_PACK_BUFFER, oldest.buffer);
    const std::size_t bytes = bytesOf(oldest.size_px);
    const void* pixels =
        glMapBufferRange(GL_PIXEL_PACK_BUFFER, 0, static_cast<GLsizeiptr>(bytes), GL_MAP_READ_BIT);
    if (!pixels) {
      glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
      throw std::runtime_error("a picture cannot be read back from the graphics card");
    }
    fetched(oldest.size_px, {static_cast<const std::uint8_t*>(pixels), bytes});
    glUnmapBuffer(GL_PIXEL_PACK_BUFFER);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  }
}

}  // namespace carom
