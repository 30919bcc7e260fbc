#include "cave/overlay/room_overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <vtk_glew.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "cave/gl/gl_program.h"
#include "cave/gl/gl_state_guard.h"
#include "cave/room/off_axis.h"
#include "shaders/grid_frag.h"
#include "shaders/stereo_vert.h"

namespace carom {
namespace {

/// Returns the place and the strength of the grid around one point.
glm::vec3 warningOf(const Wall& wall, const glm::dvec3& place_m) {
  const NearestOnWall nearest = nearestOn(wall, place_m);
  return {glm::vec2(nearest.place_m), static_cast<float>(warningAt(nearest.distance_m))};
}

}  // namespace

NearestOnWall nearestOn(const Wall& wall, const glm::dvec3& place_m) {
  const glm::dvec2 size_m = sizeOf_m(wall);
  const glm::dvec3 across = (wall.lowerRight_m - wall.lowerLeft_m) / size_m.x;
  const glm::dvec3 upwards = (wall.upperLeft_m - wall.lowerLeft_m) / size_m.y;
  const glm::dvec3 from_m = place_m - wall.lowerLeft_m;
  const glm::dvec2 on_m =
      glm::clamp(glm::dvec2(glm::dot(from_m, across), glm::dot(from_m, upwards)), glm::dvec2(0.0), size_m);
  return {on_m, glm::length(from_m - on_m.x * across - on_m.y * upwards)};
}

double warningAt(double distance_m) {
  return 1.0 - glm::smoothstep(RoomOverlay::kWarnFully_m, RoomOverlay::kWarnFrom_m, distance_m);
}

RoomOverlay::RoomOverlay()
    : program_(makeProgram("warning grid", shaders::stereo_vert, shaders::grid_frag)),
      sizeAt_(glGetUniformLocation(program_, "size_m")),
      warningsAt_(glGetUniformLocation(program_, "warnings")) {
  glUseProgram(program_);
  setUniform(program_, "step_m", static_cast<float>(kGrid_m));
  setUniform(program_, "halfLine_m", static_cast<float>(kHalfLine_m));
  setUniform(program_, "reach_m", static_cast<float>(kReach_m));
  glUseProgram(0);
}

void RoomOverlay::draw(const RoomGeometry& room, const Wall& wall, bool isFront,
                       const glm::dvec3& eyeInRoom_m, const SeenFrame& seen, const RenderTarget& picture) {
  if (!wall.onHead) drawGrid(wall, seen, picture);
  if (seen.record.controls.trackerCross) drawMarks(room, wall, isFront, eyeInRoom_m, seen, picture);
}

/// Draws the grid in the wall's plane, where every eye sees it at the same place of the picture.
void RoomOverlay::drawGrid(const Wall& wall, const SeenFrame& seen, const RenderTarget& picture) const {
  std::array<glm::vec3, 2> warnings{warningOf(wall, seen.self.observer.middle.positionInRoom_m), {}};
  if (seen.self.tracked.handKnown) warnings[1] = warningOf(wall, seen.self.tracked.roomFromHand.position_m);
  if (!(std::max(warnings[0].z, warnings[1].z) > 0.0F)) return;
  const GlStateGuard state(picture.framebuffer(), picture.size_px());
  blendOver();
  glUseProgram(program_);
  glBindVertexArray(vertexArray_);
  glUniform2fv(sizeAt_, 1, glm::value_ptr(glm::vec2(sizeOf_m(wall))));
  glUniform3fv(warningsAt_, 2, glm::value_ptr(warnings[0]));
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void RoomOverlay::addCross(const Pose& roomFromCross) {
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 arm_m(0.0);
    arm_m[axis] = kAxis_m;
    glm::vec4 colour(0.1F, 0.1F, 0.1F, 1.0F);
    colour[axis] = 1.0F;
    marks_.push_back({roomFromCross.position_m, roomFromCross * arm_m, kHalfAxis_m, colour});
  }
}

/// Adds the bars. Both are placed on the wall and then moved along the lines of sight of the point between
/// the eyes, so that both look equally large from there.
void RoomOverlay::addBars(const Wall& wall, const glm::dvec3& eyes_m) {
  const glm::dvec3 across_m = wall.lowerRight_m - wall.lowerLeft_m,
                   upwards_m = wall.upperLeft_m - wall.lowerLeft_m;
  const double far_m = glm::dot(glm::normalize(glm::cross(across_m, upwards_m)), eyes_m - wall.lowerLeft_m);
  constexpr double kHalfBar_m = 0.02;
  if (!(far_m > 1.5 * kBarsOff_m)) return;
  for (const double side : {-1.0, 1.0}) {  // the left one behind the wall
    const double share = 1.0 - side * kBarsOff_m / far_m;
    const glm::dvec3 foot_m = wall.lowerLeft_m + (0.5 + 0.08 * side) * across_m + 0.4 * upwards_m;
    const auto pushed = [&](const glm::dvec3& onWall_m) { return eyes_m + share * (onWall_m - eyes_m); };
    marks_.push_back(
        {pushed(foot_m), pushed(foot_m + 0.12 * upwards_m), share * kHalfBar_m, glm::vec4(0.95F)});
  }
}

void RoomOverlay::drawMarks(const RoomGeometry& room, const Wall& wall, bool isFront,
                            const glm::dvec3& eyeInRoom_m, const SeenFrame& seen,
                            const RenderTarget& picture) {
  const std::optional<glm::dmat4> clip = clipFromRoom(wall, eyeInRoom_m);
  if (!clip) return;
  const glm::dvec3& eyes_m = seen.self.observer.middle.positionInRoom_m;
  const Tracked& tracked = seen.self.tracked;
  marks_.clear();
  if (isFront) addBars(wall, eyes_m);
  if (tracked.headKnown) {
    Pose ahead = tracked.roomFromHeadSensor * room.viewers.front().sensorFromEyes;
    ahead.position_m = eyes_m + ahead.orientation * (kAhead_m * room.forward);
    addCross(ahead);
    addCross(tracked.roomFromHeadSensor);
  }
  if (tracked.handKnown) addCross(tracked.roomFromHand);
  std::sort(marks_.begin(), marks_.end(), [&](const Ribbon& a, const Ribbon& b) {  // the far ones first
    return glm::distance(a.to_m, eyeInRoom_m) > glm::distance(b.to_m, eyeInRoom_m);
  });
  const GlStateGuard state(picture.framebuffer(), picture.size_px());
  blendOver();
  ribbons_.draw(marks_, *clip, picture.size_px());
}

}  // namespace carom
