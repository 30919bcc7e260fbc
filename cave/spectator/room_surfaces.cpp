#include "cave/spectator/room_surfaces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <vtk_glew.h>
#include <glm/geometric.hpp>

#include "cave/gl/gl_program.h"
#include "cave/gl/gl_state_guard.h"
#include "cave/gl/glyph_bitmap.h"
#include "cave/room/off_axis.h"
#include "shaders/backdrop_frag.h"
#include "shaders/ground_frag.h"
#include "shaders/panel_frag.h"
#include "shaders/panel_vert.h"
#include "shaders/stereo_vert.h"
#include "shaders/words_frag.h"

namespace carom {
namespace {

constexpr double kGround_m = 24.0;
constexpr int kName_px = 26;

void drawRectangle(const GlProgram& program, const OutsideView& view, const Wall& place) {
  setUniform(program, "clipFromRoom", view.clipFromRoom);
  setUniform(program, "lowerLeft_m", place.lowerLeft_m);
  setUniform(program, "across_m", place.lowerRight_m - place.lowerLeft_m);
  setUniform(program, "upwards_m", place.upperLeft_m - place.lowerLeft_m);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

glm::dvec3 placeOfName_m(const Wall& wall, const glm::dvec3& up, const glm::dvec3& camera_m) {
  constexpr double kAway_m = 0.14;
  const glm::dvec3 upwards_m = wall.upperLeft_m - wall.lowerLeft_m;
  const bool stands = std::abs(glm::dot(glm::normalize(upwards_m), up)) > 0.5;
  const glm::dvec3 middle_m = 0.5 * (wall.lowerLeft_m + wall.lowerRight_m);
  if (!stands) return middle_m - kAway_m * glm::normalize(upwards_m);
  if (showsInside(wall, camera_m)) return middle_m + upwards_m + kAway_m * up;
  return middle_m - 2.0 * kAway_m * normalOf(wall);
}

}  // namespace

bool showsInside(const Wall& wall, const glm::dvec3& camera_m) {
  return glm::dot(normalOf(wall), camera_m - wall.lowerLeft_m) > 0.0;
}

RoomSurfaces::RoomSurfaces(const RoomGeometry& room)
    : room_(room),
      floor_m_(room.isHeadset ? 0.0 : std::numeric_limits<double>::infinity()),
      panelProgram_(makeProgram("panel", shaders::panel_vert, shaders::panel_frag)),
      groundProgram_(makeProgram("ground", shaders::panel_vert, shaders::ground_frag)),
      backdropProgram_(makeProgram("backdrop", shaders::stereo_vert, shaders::backdrop_frag)),
      wordsProgram_(makeProgram("words", shaders::stereo_vert, shaders::words_frag)) {
  for (const Wall& wall : room.walls) {
    const bool known =
        std::any_of(walls_.begin(), walls_.end(), [&](const Wall& other) { return standSame(wall, other); });
    if (!known) walls_.push_back(wall);
    for (const glm::dvec3& corner_m : {wall.lowerLeft_m, wall.lowerRight_m, wall.upperLeft_m})
      floor_m_ = std::min(floor_m_, glm::dot(corner_m, room.up));
  }
  for (const Wall& wall : walls_) {
    const GlyphBitmap written = ink(wall.name, kName_px);
    std::vector<std::uint8_t> rgba(4 * written.alpha.size(), 255);
    for (std::size_t i = 0; i < written.alpha.size(); ++i) rgba[4 * i + 3] = written.alpha[i];
    Name name{{}, written.size_px};
    glBindTexture(GL_TEXTURE_2D, name.texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, name.size_px.x, name.size_px.y, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 rgba.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glBindTexture(GL_TEXTURE_2D, 0);
    names_.push_back(std::move(name));
  }
}

void RoomSurfaces::drawGround(const OutsideView& view) const {
  glBindVertexArray(vertexArray_);
  glUseProgram(backdropProgram_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  blendOver();
  if (glm::dot(view.camera_m, room_.up) < floor_m_) return;
  constexpr double kBelow_m = 0.01;  // the ground is lower, since a wall may be the floor
  const glm::dvec3 right = glm::cross(room_.forward, room_.up);
  Wall ground;
  ground.lowerLeft_m = (floor_m_ - kBelow_m) * room_.up - 0.5 * kGround_m * (right + room_.forward);
  ground.lowerRight_m = ground.lowerLeft_m + kGround_m * right;
  ground.upperLeft_m = ground.lowerLeft_m + kGround_m * room_.forward;
  glUseProgram(groundProgram_);
  setUniform(groundProgram_, "size_m", static_cast<float>(kGround_m));
  drawRectangle(groundProgram_, view, ground);
}

void RoomSurfaces::drawPanels(const OutsideView& view, const DisplayWalls& shown) const {
  for (const Wall& wall : walls_) drawPanel(wall, view, shown);
}

void RoomSurfaces::drawPanel(const Wall& wall, const OutsideView& view, const DisplayWalls& shown) const {
  if (!showsInside(wall, view.camera_m)) return;
  glUseProgram(panelProgram_);
  glBindVertexArray(vertexArray_);
  setUniform(panelProgram_, "shown", 0);
  const RenderTarget* live = shown.pictureOf(wall.name, wall.piece);
  setUniform(panelProgram_, "empty", live ? 0 : 1);
  if (live) glBindTexture(GL_TEXTURE_2D, live->texture());
  drawRectangle(panelProgram_, view, wall);
}

void RoomSurfaces::drawNames(const OutsideView& view) const {
  glUseProgram(wordsProgram_);
  glBindVertexArray(vertexArray_);
  setUniform(wordsProgram_, "words", 0);
  for (std::size_t i = 0; i < walls_.size(); ++i) {
    if (walls_[i].piece > 1) continue;  // the first piece of a curved wall has its name
    const glm::dvec4 at =
        view.clipFromRoom * glm::dvec4(placeOfName_m(walls_[i], room_.up, view.camera_m), 1.0);
    if (!(at.w > 0.0)) continue;
    const glm::ivec2 middle_px = (glm::dvec2(at) / at.w * 0.5 + 0.5) * glm::dvec2(view.size_px);
    const glm::ivec2& size_px = names_[i].size_px;
    const glm::ivec2 from_px = middle_px - size_px / 2;
    glBindTexture(GL_TEXTURE_2D, names_[i].texture);
    glViewport(from_px.x, from_px.y, size_px.x, size_px.y);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
}

}  // namespace carom
