#include "cave/gl/picture_reader.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <vtk_glew.h>

namespace carom {
namespace {

// RGBA, which graphics cards transfer without conversion.
std::size_t bytesOf(const glm::ivec2& size_px) {
  return 4 * static_cast<std::size_t>(size_px.x) * static_cast<std::size_t>(size_px.y);
}

}  // namespace

/// Returns a buffer of this size, bound for packing.
GlBuffer PictureReader::bufferFor(std::size_t view, const glm::ivec2& size_px) {
  std::erase_if(spare_, [&](const Asked& spare) { return spare.view == view && spare.size_px != size_px; });
  const auto fits =
      std::find_if(spare_.begin(), spare_.end(), [&](const Asked& spare) { return spare.view == view; });
  if (fits != spare_.end()) {
    GlBuffer buffer = std::move(fits->buffer);
    spare_.erase(fits);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
    return buffer;
  }
  GlBuffer buffer;
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
  glBufferData(GL_PIXEL_PACK_BUFFER, static_cast<GLsizeiptr>(bytesOf(size_px)), nullptr, GL_STREAM_READ);
  return buffer;
}

void PictureReader::ask(const RenderTarget& picture, std::size_t view) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture.framebuffer());
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  const glm::ivec2 size_px = picture.size_px();
  GlBuffer buffer = bufferFor(view, size_px);
  glReadPixels(0, 0, size_px.x, size_px.y, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  asked_.push_back({view, std::move(buffer), placeFence(), size_px});
}

void PictureReader::fetch(std::size_t most, const Fetch& fetched) {
  while (!asked_.empty()) {
    Asked& oldest = asked_.front();
    const GLuint64 patience_ns = asked_.size() > most ? GL_TIMEOUT_IGNORED : 0;
    const GLenum state =
        glClientWaitSync(static_cast<GLsync>(oldest.arrived.get()), GL_SYNC_FLUSH_COMMANDS_BIT, patience_ns);
    if (state == GL_TIMEOUT_EXPIRED && patience_ns == 0) return;
    spare_.push_back(std::move(oldest));
    asked_.pop_front();
    Asked& arrived = spare_.back();
    arrived.arrived.reset();
    glBindBuffer(GL_PIXEL_PACK_BUFFER, arrived.buffer);
    const std::size_t bytes = bytesOf(arrived.size_px);
    const void* pixels =
        glMapBufferRange(GL_PIXEL_PACK_BUFFER, 0, static_cast<GLsizeiptr>(bytes), GL_MAP_READ_BIT);
    if (!pixels) {
      glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
      throw std::runtime_error("a picture cannot be read back from the graphics card");
    }
    fetched(arrived.size_px, {static_cast<const std::uint8_t*>(pixels), bytes});
    glUnmapBuffer(GL_PIXEL_PACK_BUFFER);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  }
}

}  // namespace carom
