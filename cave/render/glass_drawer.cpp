#include "cave/render/glass_drawer.h"

#include <algorithm>

#include <vtk_glew.h>
#include <glm/gtc/type_ptr.hpp>

#include "cave/gl/gl_program.h"
#include "cave/gl/gl_state_guard.h"
#include "shaders/glass_frag.h"
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

GlassDrawer::GlassDrawer() : program_(makeProgram("glass", shaders::glass_vert, shaders::glass_frag)) {}

void GlassDrawer::draw(std::span<const Piece> pieces, const GlassPlace& place,
                       const glm::mat4& clipFromDrawn) const {
  glUseProgram(program_);
  glEnable(GL_BLEND);
  glDepthMask(GL_FALSE);
  glEnable(GL_CLIP_DISTANCE0);
  glEnable(GL_CLIP_DISTANCE0 + 1);
  const auto at = [&](const char* name) { return glGetUniformLocation(program_, name); };
  glUniformMatrix4fv(at("clipFromDrawn"), 1, GL_FALSE, glm::value_ptr(clipFromDrawn));
  glUniformMatrix4fv(at("drawnFromEvent"), 1, GL_FALSE, glm::value_ptr(place.drawnFromEvent));
  glUniform4fv(at("heightOfEvent"), 1, glm::value_ptr(place.heightOfEvent));
  glUniform2f(at("heights_m"), place.present_m, place.top_m);
  const GLint colour = at("colour"), look = at("look"), adds = at("adds");
  for (const int pass : {0, 1}) {
    glUniform1i(adds, pass);
    if (pass == 0) {
      glBlendFunc(GL_ZERO, GL_SRC_COLOR);
    } else {
      glBlendFunc(GL_ONE, GL_ONE);
    }
    for (const Piece& piece : pieces) {
      if (pass == 0 && piece.look.taken == 0.0F) continue;
      if (piece.look.closed) {
        glEnable(GL_CULL_FACE);
      } else {
        glDisable(GL_CULL_FACE);
      }
      const float sides = piece.look.closed ? 2.0F : 1.0F;
      glUniform3fv(colour, 1, glm::value_ptr(piece.look.colour));
      glUniform4f(look, piece.look.taken, sides * piece.look.shine, sides * piece.look.edge,
                  piece.look.ahead);
      piece.mesh->draw(piece.triangles);
    }
  }
  enterRestState();
  glDisable(GL_CLIP_DISTANCE0 + 1);
  glDisable(GL_CLIP_DISTANCE0);
}

}  // namespace carom
