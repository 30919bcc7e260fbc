#include "cave/projection/screen_picture.h"

#include <cstddef>
#include <optional>

#include <vtk_glew.h>

#include "cave/gl/gl_program.h"
#include "cave/gl/gl_state_guard.h"
#include "cave/room/off_axis.h"
#include "shaders/screen_frag.h"
#include "shaders/screen_vert.h"

namespace carom {

ScreenPicture::ScreenPicture(const CurvedScreen& screen)
    : screen_(screen), program_(makeProgram("screen", shaders::screen_vert, shaders::screen_frag)) {
  for (const FlatPiece& piece : screen.pieces) pieces_.emplace_back(program_, piece.mesh);
}

ScreenPicture::DrawnPiece::DrawnPiece(const GlProgram& program, const ScreenMesh& mesh)
    : corners(program,
              {{"inWindow", 2, offsetof(Corner, inWindow)}, {"inRoom_m", 3, offsetof(Corner, inRoom_m)}}),
      count(static_cast<int>(3 * mesh.size())) {
  std::vector<Corner> drawn;
  drawn.reserve(3 * mesh.size());
  for (const ScreenTriangle& triangle : mesh) {
    for (const ScreenPoint& point : triangle)
      drawn.push_back({glm::vec2(point.inWindow), glm::vec3(point.inRoom_m)});
  }
  corners.upload(drawn);
}

void ScreenPicture::draw(const glm::dvec3& eyeInRoom_m, std::span<const std::unique_ptr<RenderTarget>> pieces,
                         RenderTarget& picture) const {
  picture.clear();
  const GlStateGuard state(picture.framebuffer(), picture.size_px());
  glUseProgram(program_);
  setUniform(program_, "piece", 0);
  glActiveTexture(GL_TEXTURE0);
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const std::optional<glm::dmat4> clip = clipFromRoom(screen_.pieces[i].wall, eyeInRoom_m);
    if (!clip) continue;
    setUniform(program_, "clipFromRoom", *clip);
    const glm::vec2 size_px(pieces[i]->size_px());
    glUniform2f(glGetUniformLocation(program_, "size_px"), size_px.x, size_px.y);
    glUniform2f(glGetUniformLocation(program_, "texel_1"), 1.0F / size_px.x, 1.0F / size_px.y);
    glBindTexture(GL_TEXTURE_2D, pieces[i]->texture());
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
      glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    pieces_[i].corners.bind();
    glDrawArrays(GL_TRIANGLES, 0, pieces_[i].count);
  }
  enterRestState();
}

}  // namespace carom
