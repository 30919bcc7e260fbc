#include "cave/overlay/comfort_overlay.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <vtk_glew.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "cave/gl/gl_program.h"
#include "cave/gl/gl_state_guard.h"
#include "cave/hud/hud_text.h"
#include "cave/hud/motion_overlay.h"
#include "cave/room/off_axis.h"
#include "shaders/shade_frag.h"
#include "shaders/shade_vert.h"

namespace carom {
namespace {

constexpr double kHalfLine_m = 0.004;
constexpr int kParts = 4;  // of a wall's edges, between the lines of the resting frame

}  // namespace

double shadeOf(const SeenFrame& seen) {
  if (!seen.record.controls.comfort) return 0.0;
  const double beta = glm::length(betaFromU(platformInRoom_u(seen)));
  return std::clamp(beta / ComfortOverlay::kFullBeta, 0.0, 1.0);
}

glm::dvec3 sightOf(const RoomGeometry& room, const SeenFrame& seen) {
  if (seen.self.tracked.headKnown && (room.isHeadset || room.walls.size() > 1))
    return (seen.self.tracked.roomFromHeadSensor * room.viewers.front().sensorFromEyes).orientation *
           room.forward;
  const std::optional<Wall> front = frontWall(room);
  if (!front) return room.forward;
  const glm::dvec3 middle_m = 0.5 * (front->lowerRight_m + front->upperLeft_m);
  return glm::normalize(middle_m - seen.self.observer.middle.positionInRoom_m);
}

ComfortOverlay::ComfortOverlay()
    : program_(makeProgram("dark edges", shaders::shade_vert, shaders::shade_frag)) {}

void ComfortOverlay::draw(const RoomGeometry& room, const Wall& wall, const glm::dvec3& eyeInRoom_m,
                          const SeenFrame& seen, const RenderTarget& picture) {
  const double dark = shadeOf(seen);
  if (!(dark > 0.0)) return;
  shade(wall, eyeInRoom_m, sightOf(room, seen), dark, 0.0, picture);
  drawFrame(room, wall, eyeInRoom_m, dark, picture);
}

void ComfortOverlay::fade(const Wall& wall, const SeenFrame& seen, const RenderTarget& picture) const {
  if (!(seen.record.fade > 0.0)) return;
  const glm::dvec3 before_m = wall.lowerLeft_m + normalOf(wall);
  shade(wall, before_m, normalOf(wall), 0.0, seen.record.fade, picture);
}

/// Draws the shade over the whole wall: at no shade, the clear cone holds every direction.
void ComfortOverlay::shade(const Wall& wall, const glm::dvec3& eyeInRoom_m, const glm::dvec3& sight,
                           double shade, double black, const RenderTarget& picture) const {
  const GlStateGuard state(picture.framebuffer(), picture.size_px());
  blendOver();
  glUseProgram(program_);
  glBindVertexArray(vertexArray_);
  const auto place = [this](const char* name) { return glGetUniformLocation(program_, name); };
  const auto set = [](GLint at, const glm::dvec3& value) {
    glUniform3fv(at, 1, glm::value_ptr(glm::vec3(value)));
  };
  set(place("corner_m"), wall.lowerLeft_m - eyeInRoom_m);
  set(place("across_m"), wall.lowerRight_m - wall.lowerLeft_m);
  set(place("upwards_m"), wall.upperLeft_m - wall.lowerLeft_m);
  set(place("sight"), sight);
  glUniform1f(place("clear_rad"), static_cast<float>(glm::mix(kClearAtRest_rad, kClearFast_rad, shade)));
  glUniform1f(place("soft_rad"), static_cast<float>(kSoft_rad));
  glUniform1f(place("darkest"),
              static_cast<float>(shade > 0.0 ? kDarkest * std::min(1.0, 4.0 * shade) : 0.0));
  glUniform1f(place("black"), static_cast<float>(black));
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

/// Draws a grid of lines in the wall's plane, which rest whatever the board does.
void ComfortOverlay::drawFrame(const RoomGeometry& room, const Wall& wall, const glm::dvec3& eyeInRoom_m,
                               double shade, const RenderTarget& picture) {
  if (room.walls.empty() || wall.onHead) return;  // what hangs on the head does not rest
  const std::optional<glm::dmat4> clip = clipFromRoom(wall, eyeInRoom_m);
  if (!clip) return;
  const glm::dvec3 across_m = wall.lowerRight_m - wall.lowerLeft_m,
                   upwards_m = wall.upperLeft_m - wall.lowerLeft_m;
  const glm::vec4 colour(0.75F, 0.8F, 0.85F, static_cast<float>(0.6 * std::min(1.0, 4.0 * shade)));
  lines_.clear();
  for (int i = 0; i <= kParts; ++i) {
    const double share = static_cast<double>(i) / kParts;
    const glm::dvec3 foot_m = wall.lowerLeft_m + share * across_m,
                     side_m = wall.lowerLeft_m + share * upwards_m;
    lines_.push_back({foot_m, foot_m + upwards_m, kHalfLine_m, colour});
    lines_.push_back({side_m, side_m + across_m, kHalfLine_m, colour});
  }
  const GlStateGuard state(picture.framebuffer(), picture.size_px());
  blendOver();
  ribbons_.draw(lines_, *clip, picture.size_px());
}

}  // namespace carom
