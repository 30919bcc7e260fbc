#include "cave/sculpture/glass_drawer.h"

#include <algorithm>

#include <vtk_glew.h>
#include <glm/gtc/type_ptr.hpp>

#include "cave/gl/gl_program.h"
#include "cave/gl/gl_state_guard.h"
#include "shaders/glass_frag.h"
#include "shaders/glass_shadow_frag.h"
#include "shaders/glass_sheet_frag.h"
#include "shaders/glass_vert.h"

namespace carom {

GlassMesh::GlassMesh(const GlProgram& program) : corners_(program, {{"event", 3, 0}}) {}

void GlassMesh::upload(std::span<const glm::vec3> corners,
                       std::span<const std::array<std::uint32_t, 3>> triangles) {
  corners_.upload(corners);
  glBindBuffer(GL_ARRAY_BUFFER, triangles_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.size_bytes()), triangles.data(),
               GL_STREAM_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  count_ = triangles.size();
}

void GlassMesh::draw(const TriangleRange& triangles) const {
  if (triangles.first >= count_) return;
  const std::size_t count = std::min(triangles.count, count_ - triangles.first);
  corners_.bind();
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles_);
  const auto* const first = static_cast<const std::array<std::uint32_t, 3>*>(nullptr) + triangles.first;
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * count), GL_UNSIGNED_INT, first);
}

GlassDrawer::GlassDrawer()
    : program_(makeProgram("glass", shaders::glass_vert, shaders::glass_frag)),
      sheets_(makeProgram("glass sheets", shaders::glass_vert, shaders::glass_sheet_frag)),
      shadows_(makeProgram("glass shadows", shaders::glass_vert, shaders::glass_shadow_frag)) {}

namespace {

/// One way of drawing pieces, with a program of its own.
class Pass {
 public:
  Pass(const GlProgram& program, const GlassPlace& place, const glm::mat4& drawnFromEvent,
       const glm::mat4& clipFromDrawn)
      : program_(program) {
    glUseProgram(program);
    glUniformMatrix4fv(at("clipFromDrawn"), 1, GL_FALSE, glm::value_ptr(clipFromDrawn));
    glUniformMatrix4fv(at("drawnFromEvent"), 1, GL_FALSE, glm::value_ptr(drawnFromEvent));
    glUniform4fv(at("heightOfEvent"), 1, glm::value_ptr(place.heightOfEvent));
    glUniform2f(at("heights_m"), place.present_m, place.top_m);
    colour_ = at("colour"), look_ = at("look");
  }
  /// Of glass that both takes and adds: which of these it does.
  void setAdds(bool adds) const { glUniform1i(at("adds"), adds ? 1 : 0); }

  void draw(const GlassDrawer::Piece& piece) const {
    const GlassLook& look = piece.look;
    const float sides = look.closed ? 2.0F : 1.0F;
    glUniform3fv(colour_, 1, glm::value_ptr(look.colour));
    glUniform4f(look_, look.taken, sides * look.shine, sides * look.edge, look.ahead);
    piece.mesh->draw(piece.triangles);
  }

 private:
  GLint at(const char* name) const { return glGetUniformLocation(program_, name); }

  unsigned program_;
  GLint colour_, look_;
};

}  // namespace

void GlassDrawer::draw(std::span<const Piece> pieces, const GlassPlace& place,
                       const glm::mat4& clipFromDrawn) const {
  glEnable(GL_BLEND);
  glDepthMask(GL_FALSE);
  glEnable(GL_CLIP_DISTANCE0);
  glEnable(GL_CLIP_DISTANCE0 + 1);
  glEnable(GL_CULL_FACE);
  glBlendFunc(GL_ZERO, GL_SRC_COLOR);
  const auto drawClosed = [&](const Pass& pass) {
    for (const Piece& piece : pieces)
      if (piece.look.closed) pass.draw(piece);
  };
  drawClosed({shadows_, place, place.shadowFromEvent, clipFromDrawn});
  const Pass glass(program_, place, place.drawnFromEvent, clipFromDrawn);
  glass.setAdds(false);
  drawClosed(glass);
  glBlendFunc(GL_ONE, GL_ONE);
  glass.setAdds(true);
  drawClosed(glass);
  // Sheets leave the tones alone, by which edges behind them are smoothed (cave/render/edge_pixels.h).
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
  glDisable(GL_CULL_FACE);
  const Pass sheets(sheets_, place, place.drawnFromEvent, clipFromDrawn);
  for (const Piece& piece : pieces)
    if (!piece.look.closed) sheets.draw(piece);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  enterRestState();
  glDisable(GL_CLIP_DISTANCE0 + 1);
  glDisable(GL_CLIP_DISTANCE0);
}

}  // namespace carom
