#pragma once
// The OpenGL state for pictures that are drawn in several steps by different users of a context.

#include <glm/vec2.hpp>

namespace carom {

/// Sets the OpenGL defaults that this program relies on: blending mixes by the alpha of the new colour, and
/// fragments as near as the stored depth pass the depth test.
void enterRestState();

/// From its construction on, drawing goes into all of `framebuffer`, with every test and blending off. Its
/// destructor leaves the context as its users expect to find it: nothing bound or in use, every test and
/// blending off, depth written, the functions of blending and of the depth test those of enterRestState. So
/// OpenGL need not be asked for its state, which would wait for the commands given so far. Guards
/// cannot be nested.
class GlStateGuard {
 public:
  GlStateGuard(unsigned framebuffer, const glm::ivec2& size_px);
  ~GlStateGuard();
  GlStateGuard(const GlStateGuard&) = delete;
  GlStateGuard& operator=(const GlStateGuard&) = delete;
};

/// Turns alpha blending on for the following draws. Call it within a GlStateGuard.
void blendOver();

}  // namespace carom
