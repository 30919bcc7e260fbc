#include "cave/gl/gl_state_guard.h"

#include <array>

#include <vtk_glew.h>

namespace carom {
namespace {

void turnOff() {
  constexpr std::array<GLenum, 5> kSwitches{GL_DEPTH_TEST, GL_BLEND, GL_SCISSOR_TEST, GL_CULL_FACE,
                                            GL_CLIP_DISTANCE0};
  for (const GLenum what : kSwitches) glDisable(what);
}

}  // namespace

void enterRestState() {
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDepthFunc(GL_LEQUAL);
}

GlStateGuard::GlStateGuard(unsigned framebuffer, const glm::ivec2& size_px) {
  turnOff();
  glActiveTexture(GL_TEXTURE0);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, size_px.x, size_px.y);
}

GlStateGuard::~GlStateGuard() {
  turnOff();
  glDepthMask(GL_TRUE);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, 0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glBindVertexArray(0);
  glUseProgram(0);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
}

void blendOver() { glEnable(GL_BLEND); }

}  // namespace carom
