#include "cave/overlay/standing_board.h"

#include <array>

#include <vtk_glew.h>

#include "cave/gl/gl_program.h"
#include "cave/gl/gl_state_guard.h"
#include "cave/room/off_axis.h"
#include "shaders/board_frag.h"
#include "shaders/panel_vert.h"

namespace carom {

StandingBoard::StandingBoard(const Wall& place)
    : place_(place),
      written_(place.pixels),
      program_(makeProgram("board", shaders::panel_vert, shaders::board_frag)) {}

const RenderTarget& StandingBoard::wiped() const {
  const GlStateGuard state(written_.framebuffer(), written_.size_px());
  constexpr std::array<float, 4> kNothing{};
  glClearBufferfv(GL_COLOR, 0, kNothing.data());
  return written_;
}

// The writing is premultiplied by its alpha, since it was written over nothing.
void StandingBoard::draw(const Wall& wall, const glm::dvec3& eyeInRoom_m, const RenderTarget& picture) const {
  const std::optional<glm::dmat4> clip = clipFromRoom(wall, eyeInRoom_m);
  if (!clip) return;
  const GlStateGuard state(picture.framebuffer(), picture.size_px());
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glUseProgram(program_);
  glBindVertexArray(vertexArray_);
  glBindTexture(GL_TEXTURE_2D, written_.texture());
  setUniform(program_, "written", 0);
  setUniform(program_, "clipFromRoom", *clip);
  setUniform(program_, "lowerLeft_m", place_.lowerLeft_m);
  setUniform(program_, "across_m", place_.lowerRight_m - place_.lowerLeft_m);
  setUniform(program_, "upwards_m", place_.upperLeft_m - place_.lowerLeft_m);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  enterRestState();
}

}  // namespace carom
