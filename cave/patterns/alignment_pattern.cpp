#include "cave/patterns/alignment_pattern.h"

#include <cmath>

#include <vtk_glew.h>
#include <glm/common.hpp>

#include "cave/gl/gl_program.h"
#include "cave/gl/gl_state_guard.h"
#include "cave/screen/curved_screen.h"
#include "cave/screen/sky_screen.h"
#include "shaders/seam_frag.h"
#include "shaders/seam_vert.h"

namespace carom {

namespace {

/// Returns the corners of a wall's triangles, three by three.
std::vector<SeamCorner> cornersOf(const Wall& wall) {
  std::vector<SeamCorner> corners;
  if (wall.screen) {
    // Directions are shown as places that many metres from the middle.
    constexpr double kAway_m = 3.0;
    const glm::dvec3& middle_m = wall.screen->eyesMiddle_m;
    const double share = wall.sky ? kAway_m / kSky_m : 1.0;
    for (const ScreenTriangle& triangle : wall.screen->mesh) {
      for (const ScreenPoint& point : triangle)
        corners.push_back({point.inWindow, glm::mix(middle_m, point.inRoom_m, share)});
    }
    return corners;
  }
  const glm::dvec3 across_m = wall.lowerRight_m - wall.lowerLeft_m,
                   upwards_m = wall.upperLeft_m - wall.lowerLeft_m;
  // One triangle that reaches beyond the window covers it.
  for (const glm::dvec2& place : {glm::dvec2(0.0), glm::dvec2(2.0, 0.0), glm::dvec2(0.0, 2.0)})
    corners.push_back({place, wall.lowerLeft_m + place.x * across_m + place.y * upwards_m});
  return corners;
}

}  // namespace

AlignmentPattern::AlignmentPattern()
    : program_(makeProgram("seam", shaders::seam_vert, shaders::seam_frag)),
      corners_(program_, {{"inWindow", 2, offsetof(SeamCorner, inWindow)},
                          {"inRoom_m", 3, offsetof(SeamCorner, inRoom_m)}}) {}

void AlignmentPattern::draw(const Wall& wall, double time_s, RenderTarget& picture) {
  const std::vector<SeamCorner> corners = cornersOf(wall);
  corners_.upload(corners);
  if (wall.screen) picture.clear();
  const GlStateGuard state(picture.framebuffer(), picture.size_px());
  glUseProgram(program_);
  corners_.bind();
  setUniform(program_, "first_m", glm::dvec3(std::fmod(kSpeed_m_s * time_s, kPeriod_m)));
  setUniform(program_, "period_m", static_cast<float>(kPeriod_m));
  setUniform(program_, "halfLine_m", static_cast<float>(kHalfLine_m));
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size()));
}

}  // namespace carom
