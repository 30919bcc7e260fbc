#include "cave/render/edge_smoother.h"

#include <vtk_glew.h>

#include "cave/gl/gl_program.h"
#include "cave/gl/gl_state_guard.h"
#include "shaders/edge_frag.h"
#include "shaders/edge_tile_vert.h"

namespace carom {
namespace {

constexpr int kTile_px = 8;                  // as in shaders/edge_tile_vert.glsl
constexpr int kLeastSize_px = kTile_px + 2;  // a tile and the pixels around it
constexpr float kLeastStep = 0.016F;         // of tones 0 to 1: four of the picture's steps

}  // namespace

EdgeSmoother::EdgeSmoother() : program_(makeProgram("edges", shaders::edge_tile_vert, shaders::edge_frag)) {
  const GlStateGuard state(0, {1, 1});
  glUseProgram(program_);
  setUniform(program_, "drawn", 0);
  setUniform(program_, "leastStep", kLeastStep);
}

void EdgeSmoother::smooth(unsigned drawn, const glm::ivec2& size_px, const RenderTarget& picture,
                          int left_px) const {
  if (size_px.x < kLeastSize_px || size_px.y < kLeastSize_px) return;
  const GlStateGuard state(picture.framebuffer(), size_px);
  glViewport(left_px, 0, size_px.x, size_px.y);
  glBindTexture(GL_TEXTURE_2D, drawn);
  glUseProgram(program_);
  glUniform2i(glGetUniformLocation(program_, "size_px"), size_px.x, size_px.y);
  setUniform(program_, "left_px", left_px);
  glBindVertexArray(vertexArray_);
  glEnable(GL_PROGRAM_POINT_SIZE);
  const glm::ivec2 tiles = (size_px + kTile_px - 1) / kTile_px;
  glDrawArrays(GL_POINTS, 0, tiles.x * tiles.y);
  glDisable(GL_PROGRAM_POINT_SIZE);
}

}  // namespace carom
