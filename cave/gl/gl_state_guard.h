#pragma once
// The state in which plain pictures are drawn with OpenGL itself, beside VTK, which shares the context.

#include <array>

#include <glm/vec2.hpp>

namespace carom {

/// Draws into `framebuffer` from here on, over all of it, with every test and blending off, and puts back
/// what was when it goes: others of this context rely on it.
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

/// What is drawn from here on lies over what is there, as its alpha says. Within a GlStateGuard.
void blendOver();

}  // namespace carom
