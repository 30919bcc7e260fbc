#include "cave/projection/stereo.h"

#include <vtk_glew.h>
#include <glm/common.hpp>

#include "cave/gl/gl_program.h"
#include "cave/projection/projector.h"
#include "shaders/copy_frag.h"
#include "shaders/copy_vert.h"
#include "shaders/stereo_frag.h"
#include "shaders/stereo_vert.h"

namespace carom {
namespace {

/// Returns `mode` of shaders/stereo_frag.glsl if the eyes share the pane's pixels, 0 if each picture has its
/// own part of the pane.
int mixtureOf(StereoMode mode) {
  switch (mode) {
    case StereoMode::anaglyph:
      return 1;
    case StereoMode::interlaced:
      return 2;
    case StereoMode::checkerboard:
      return 3;
    case StereoMode::anaglyphGrey:
      return 4;
    case StereoMode::sideBySide:
    case StereoMode::topBottom:
    case StereoMode::mono:
    case StereoMode::left:
    case StereoMode::right:
    case StereoMode::quadBuffer:
      return 0;
  }
  return 0;
}

/// Returns the size of the part of a pane that one eye's picture fills; all of it if the eyes' pixels
/// alternate.
glm::ivec2 eyeSize_px(const Pane& pane) {
  if (pane.stereo == StereoMode::sideBySide) return {(pane.size_px.x + 1) / 2, pane.size_px.y};
  if (pane.stereo == StereoMode::topBottom) return {pane.size_px.x, (pane.size_px.y + 1) / 2};
  return pane.size_px;
}

}  // namespace

StereoPacker::StereoPacker(unsigned framebuffer)
    : framebuffer_(framebuffer),
      copyProgram_(makeProgram("copy", shaders::copy_vert, shaders::copy_frag)),
      mixProgram_(makeProgram("stereo", shaders::stereo_vert, shaders::stereo_frag)) {
  glUseProgram(copyProgram_);
  setUniform(copyProgram_, "picture", 0);
  glUseProgram(mixProgram_);
  setUniform(mixProgram_, "leftPicture", 0);
  setUniform(mixProgram_, "rightPicture", 1);
  modeAt_ = glGetUniformLocation(mixProgram_, "mode");
  heightAt_ = glGetUniformLocation(mixProgram_, "windowHeight_px");
}

StereoPacker::~StereoPacker() = default;

Pane StereoPacker::projected(const Pane& pane) {
  std::unique_ptr<Projector>& projector = projectors_[pane.projection];
  if (!projector) projector = std::make_unique<Projector>(*pane.projection);
  const glm::ivec2 size_px = glm::max(eyeSize_px(pane), glm::ivec2(1));
  Pane result = pane;
  result.projection = nullptr;
  const Eye first = pane.stereo == StereoMode::right ? Eye::right : Eye::left;
  result.left = &projector->project(*pane.left, first, size_px);
  if (pane.right) result.right = &projector->project(*pane.right, Eye::right, size_px);
  return result;
}

void StereoPacker::draw(const Pane& pane, const glm::ivec2& windowSize_px) {
  if (pane.projection) {
    const Pane corrected = projected(pane);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
    return draw(corrected, windowSize_px);
  }
  if (pane.stereo == StereoMode::quadBuffer && pane.right) {
    glDrawBuffer(GL_BACK_LEFT);
    copy(*pane.left, pane.position_px, pane.size_px, windowSize_px);
    glDrawBuffer(GL_BACK_RIGHT);
    copy(*pane.right, pane.position_px, pane.size_px, windowSize_px);
    glDrawBuffer(GL_BACK);
    return;
  }
  if (const int mixture = mixtureOf(pane.stereo)) return mix(pane, windowSize_px, mixture);
  const RenderTarget& right = pane.right ? *pane.right : *pane.left;
  const glm::ivec2 half_px = pane.size_px / 2;
  if (pane.stereo == StereoMode::sideBySide) {
    copy(*pane.left, pane.position_px, {half_px.x, pane.size_px.y}, windowSize_px);
    copy(right, pane.position_px + glm::ivec2(half_px.x, 0), {pane.size_px.x - half_px.x, pane.size_px.y},
         windowSize_px);
  } else if (pane.stereo == StereoMode::topBottom) {
    const int top_px = pane.size_px.y - half_px.y;
    copy(*pane.left, pane.position_px, {pane.size_px.x, top_px}, windowSize_px);
    copy(right, pane.position_px + glm::ivec2(0, top_px), {pane.size_px.x, half_px.y}, windowSize_px);
  } else {
    copy(*pane.left, pane.position_px, pane.size_px, windowSize_px);
  }
}

/// Copies a picture into a part of the window: pixel by pixel if that is as large, smoothly if not.
void StereoPacker::copy(const RenderTarget& picture, const glm::ivec2& position_px, const glm::ivec2& size_px,
                        const glm::ivec2& windowSize_px) const {
  glDisable(GL_DEPTH_TEST);
  glViewport(position_px.x, windowSize_px.y - position_px.y - size_px.y, size_px.x, size_px.y);
  glUseProgram(copyProgram_);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, picture.texture());
  const auto filter = [](int which) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, which);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, which);
  };
  const bool asLarge = picture.size_px() == size_px;
  if (asLarge) filter(GL_NEAREST);
  glBindVertexArray(vertexArray_);
  glDrawArrays(GL_TRIANGLES, 0, 6);
  if (asLarge) filter(GL_LINEAR);
}

void StereoPacker::mix(const Pane& pane, const glm::ivec2& windowSize_px, int mixture) const {
  const RenderTarget& right = pane.right ? *pane.right : *pane.left;
  glDisable(GL_DEPTH_TEST);
  glViewport(pane.position_px.x, windowSize_px.y - pane.position_px.y - pane.size_px.y, pane.size_px.x,
             pane.size_px.y);
  glUseProgram(mixProgram_);
  glUniform1i(modeAt_, mixture);
  glUniform1f(heightAt_, static_cast<float>(windowSize_px.y));
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, pane.left->texture());
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, right.texture());
  glBindVertexArray(vertexArray_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace carom
