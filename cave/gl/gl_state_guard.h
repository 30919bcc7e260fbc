#pragma once
// The OpenGL state for flat pictures that are drawn directly, beside VTK, which shares the context.

#include <array>

#include <glm/vec2.hpp>

namespace carom {

/// From its construction on, drawing goes into all of `framebuffer`, with every test and blending off. Its
/// destructor restores the previous state, on which other users of the context rely.
class GlStateGuard {
 public:
  GlStateGuard(unsigned framebuffer, const glm::ivec2& size_px);
  ~GlStateGuard();
  GlStateGuard(const GlStateGuard&) = delete;
  GlStateGuard& operator=(const GlStateGuard&) = delete;

 private:
  static constexpr std::size_t kSwitches = 5;
  std::array<unsigned char, kSwitches> wasOn_{};
  std::array<int, 4> viewport_{}, scissor_{}, blend_{};
  int program_ = 0, vertexArray_ = 0, buffer_ = 0, framebuffer_ = 0, unit_ = 0, texture_ = 0, depth_ = 0;
  unsigned char depthMask_ = 0;
};

/// Turns alpha blending on for what is drawn from here on. Call it within a GlStateGuard.
void blendOver();

}  // namespace carom
