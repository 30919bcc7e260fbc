#include "cave/render/draw_target.h"

#include <array>

#include <vtk_glew.h>
#include <glm/common.hpp>

namespace carom {

DrawTarget::DrawTarget(int samples) : samples_(samples > 1 ? samples : 0) {}

void DrawTarget::grow(const glm::ivec2& size_px) {
  buffer_px_ = glm::max(buffer_px_, size_px);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  if (samples_ == 0) {
    glBindTexture(GL_TEXTURE_2D, texture_);
    allocatePicture(buffer_px_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
  } else {
    glBindRenderbuffer(GL_RENDERBUFFER, colour_);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_RGBA8, buffer_px_.x, buffer_px_.y);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
  }
  glBindRenderbuffer(GL_RENDERBUFFER, depth_);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_DEPTH_COMPONENT24, buffer_px_.x,
                                   buffer_px_.y);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  glBindRenderbuffer(GL_RENDERBUFFER, 0);
}

void DrawTarget::bind(const glm::ivec2& size_px) {
  if (size_px.x > buffer_px_.x || size_px.y > buffer_px_.y) grow(size_px);
  size_px_ = size_px;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  if (size_px != viewport_px_) glViewport(0, 0, size_px.x, size_px.y);
  viewport_px_ = size_px;
  glEnable(GL_DEPTH_TEST);
}

void DrawTarget::begin(const glm::ivec2& size_px) {
  bind(size_px);
  const bool whole = size_px == buffer_px_;
  if (!whole) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, size_px.x, size_px.y);
  }
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  if (!whole) glDisable(GL_SCISSOR_TEST);
}

void DrawTarget::beginWith(const DrawTarget& other) {
  bind(other.size_px_);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, other.framebuffer_);
  glBlitFramebuffer(0, 0, size_px_.x, size_px_.y, 0, 0, size_px_.x, size_px_.y,
                    GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
}

void DrawTarget::copyTo(const RenderTarget& picture, int left_px) const {
  glDisable(GL_DEPTH_TEST);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, picture.framebuffer());
  glBlitFramebuffer(0, 0, size_px_.x, size_px_.y, left_px, 0, left_px + size_px_.x, size_px_.y,
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void DrawTarget::read(std::span<std::uint32_t> pixels) const {
  glDisable(GL_DEPTH_TEST);
  glReadPixels(0, 0, size_px_.x, size_px_.y, GL_BGRA, GL_UNSIGNED_BYTE, pixels.data());
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace carom
