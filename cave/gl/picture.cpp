#include "cave/gl/picture.h"

#include <array>
#include <stdexcept>

#include <fmt/format.h>
#include <vtk_glew.h>

namespace carom {

// For a sized internal format Mesa's llvmpipe keeps to the order red, green, blue, and then copies into
// windows at six times the price.
void allocatePicture(const glm::ivec2& size_px) {
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, size_px.x, size_px.y, 0, GL_BGRA, GL_UNSIGNED_BYTE, nullptr);
}

RenderTarget::RenderTarget(const glm::ivec2& size_px) : size_px_(size_px) {
  GLint limit_px = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit_px);
  if (size_px.x < 1 || size_px.y < 1 || size_px.x > limit_px || size_px.y > limit_px) {
    throw std::runtime_error(fmt::format("a wall picture of {} x {} pixels cannot be drawn here; 1 to {} can",
                                         size_px.x, size_px.y, limit_px));
  }
  glBindTexture(GL_TEXTURE_2D, texture_);
  allocatePicture(size_px);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_2D, 0);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
  glBindRenderbuffer(GL_RENDERBUFFER, depth_);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size_px.x, size_px.y);
  glBindRenderbuffer(GL_RENDERBUFFER, 0);
  glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  clear();
}

void RenderTarget::clear() { clear(0, size_px_.x); }

void RenderTarget::clear(int left_px, int width_px) {
  if (isBlack_) return;
  constexpr std::array<float, 4> kBlack{0.0F, 0.0F, 0.0F, 1.0F};
  const bool whole = width_px == size_px_.x;
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
  if (!whole) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(left_px, 0, width_px, size_px_.y);
  }
  glClearBufferfv(GL_COLOR, 0, kBlack.data());
  if (!whole) glDisable(GL_SCISSOR_TEST);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  isBlack_ = whole;
}

void RenderTarget::fill(std::span<const std::uint32_t> pixels, int left_px, int width_px) {
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexSubImage2D(GL_TEXTURE_2D, 0, left_px, 0, width_px, size_px_.y, GL_BGRA, GL_UNSIGNED_BYTE,
                  pixels.data());
  glBindTexture(GL_TEXTURE_2D, 0);
  isBlack_ = false;
}

void RenderTarget::fill(std::span<const std::uint8_t> rgb) {
  if (rgb.size() != 3 * static_cast<std::size_t>(size_px_.x) * static_cast<std::size_t>(size_px_.y)) {
    throw std::invalid_argument(fmt::format("{} bytes were given for a picture of {} x {} pixels", rgb.size(),
                                            size_px_.x, size_px_.y));
  }
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size_px_.x, size_px_.y, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
  glBindTexture(GL_TEXTURE_2D, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);  // as OpenGL begins
  isBlack_ = false;
}

}  // namespace carom
