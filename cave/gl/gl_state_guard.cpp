#include "cave/gl/gl_state_guard.h"

#include <vtk_glew.h>

namespace carom {
namespace {

constexpr std::array<GLenum, 5> kOff{GL_DEPTH_TEST, GL_BLEND, GL_SCISSOR_TEST, GL_CULL_FACE,
                                     GL_CLIP_DISTANCE0};
constexpr std::array<GLenum, 4> kBlend{GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA,
                                       GL_BLEND_DST_ALPHA};

}  // namespace

GlStateGuard::GlStateGuard(unsigned framebuffer, const glm::ivec2& size_px) {
  static_assert(kOff.size() == kSwitches);
  glGetIntegerv(GL_CURRENT_PROGRAM, &program_);
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &vertexArray_);
  glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &buffer_);
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer_);
  glGetIntegerv(GL_VIEWPORT, viewport_.data());
  glGetIntegerv(GL_SCISSOR_BOX, scissor_.data());
  for (std::size_t i = 0; i < kBlend.size(); ++i) glGetIntegerv(kBlend[i], &blend_[i]);
  glGetIntegerv(GL_DEPTH_FUNC, &depth_);
  glGetBooleanv(GL_DEPTH_WRITEMASK, &depthMask_);
  glGetIntegerv(GL_ACTIVE_TEXTURE, &unit_);
  glActiveTexture(GL_TEXTURE0);
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &texture_);
  for (std::size_t i = 0; i < kOff.size(); ++i) {
    wasOn_[i] = glIsEnabled(kOff[i]);
    glDisable(kOff[i]);
  }
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, size_px.x, size_px.y);
}

GlStateGuard::~GlStateGuard() {
  for (std::size_t i = 0; i < kOff.size(); ++i) {
    if (wasOn_[i]) {
      glEnable(kOff[i]);
    } else {
      glDisable(kOff[i]);
    }
  }
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(texture_));
  glActiveTexture(static_cast<GLenum>(unit_));
  glDepthMask(depthMask_);
  glDepthFunc(static_cast<GLenum>(depth_));
  glBlendFuncSeparate(static_cast<GLenum>(blend_[0]), static_cast<GLenum>(blend_[1]),
                      static_cast<GLenum>(blend_[2]), static_cast<GLenum>(blend_[3]));
  glScissor(scissor_[0], scissor_[1], scissor_[2], scissor_[3]);
  glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(framebuffer_));
  glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(buffer_));
  glBindVertexArray(static_cast<GLuint>(vertexArray_));
  glUseProgram(static_cast<GLuint>(program_));
}

void blendOver() {
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

}  // namespace carom
