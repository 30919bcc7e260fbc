#include "cave/render/edge_smoother.h"

#include <string>

#include <vtk_glew.h>

#include "cave/gl/gl_program.h"
#include "shaders/edge_frag.h"
#include "shaders/edge_tile_vert.h"

namespace carom {
namespace {

constexpr int kTile_px = 8;                  // as in shaders/edge_tile_vert.glsl
constexpr int kLeastSize_px = kTile_px + 2;  // a tile and the pixels around it
/// Returns what the shaders' texts begin with. Luminance: Rec. 709.
std::string preamble(EdgeSmoother::Tones tones) {
  const bool inAlpha = tones == EdgeSmoother::Tones::inAlpha;
  return std::string("#version 150\n#define TONE(pixel) ") +
         (inAlpha ? "(pixel).a\n" : "dot((pixel).rgb, vec3(0.2126, 0.7152, 0.0722))\n");
}

/// Returns the least step of tones from 0 to 1: four of the picture's 255 steps, or twelve where letters and
/// pictures have tones of their own.
float leastStep(EdgeSmoother::Tones tones) { return tones == EdgeSmoother::Tones::inAlpha ? 0.016F : 0.047F; }

}  // namespace

EdgeSmoother::EdgeSmoother(Tones tones)
    : program_(makeProgram("edges", preamble(tones) + shaders::edge_tile_vert,
                           preamble(tones) + shaders::edge_frag)) {
  glUseProgram(program_);
  setUniform(program_, "drawn", 0);
  setUniform(program_, "leastStep", leastStep(tones));
  sizeAt_ = glGetUniformLocation(program_, "size_px");
  leftAt_ = glGetUniformLocation(program_, "left_px");
  glUseProgram(0);
}

void EdgeSmoother::smooth(unsigned drawn, const glm::ivec2& size_px, const RenderTarget& picture,
                          int left_px) {
  if (size_px.x < kLeastSize_px || size_px.y < kLeastSize_px) return;
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, picture.framebuffer());
  if (left_px != 0) glViewport(left_px, 0, size_px.x, size_px.y);
  glBindTexture(GL_TEXTURE_2D, drawn);
  glUseProgram(program_);
  if (size_px != size_px_) glUniform2i(sizeAt_, size_px.x, size_px.y);
  if (left_px != left_px_) glUniform1i(leftAt_, left_px);
  size_px_ = size_px;
  left_px_ = left_px;
  glBindVertexArray(vertexArray_);
  glEnable(GL_PROGRAM_POINT_SIZE);
  const glm::ivec2 tiles = (size_px + kTile_px - 1) / kTile_px;
  glDrawArrays(GL_POINTS, 0, tiles.x * tiles.y);
  glDisable(GL_PROGRAM_POINT_SIZE);
  glBindVertexArray(0);
  glUseProgram(0);
  glBindTexture(GL_TEXTURE_2D, 0);
  if (left_px != 0) glViewport(0, 0, size_px.x, size_px.y);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
}

}  // namespace carom
