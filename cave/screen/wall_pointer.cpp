#include "cave/screen/wall_pointer.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cave/screen/curved_screen.h"

namespace carom {
namespace {

/// Returns the eye whose half of the pane contains `share`, and makes `share` a fraction of that half.
Eye halve(double& share) {
  const bool second = share >= 0.5;
  share = 2.0 * share - (second ? 1.0 : 0.0);
  return second ? Eye::right : Eye::left;
}

Eye onlyEye(StereoMode mode) {
  if (mode == StereoMode::left) return Eye::left;
  return mode == StereoMode::right ? Eye::right : Eye::middle;
}

}  // namespace

double outside_px(const Viewport& pane, const glm::dvec2& pointer_px) {
  const glm::dvec2 from_px(pane.position_px), to_px(pane.position_px + pane.size_px);
  return glm::distance(pointer_px, glm::clamp(pointer_px, from_px, to_px));
}

std::optional<PointedWall> pointedIn(const Wall& wall, const Viewport& pane, const glm::dvec2& pointer_px,
                                     bool beyond) {
  glm::dvec2 share = (pointer_px - glm::dvec2(pane.position_px)) / glm::dvec2(pane.size_px);  // right, down
  const bool inside = share.x >= 0.0 && share.y >= 0.0 && share.x < 1.0 && share.y < 1.0;
  if (!inside && !beyond) return std::nullopt;
  Eye eye = onlyEye(wall.stereo);
  if (wall.stereo == StereoMode::sideBySide) eye = halve(share.x);  // as shaders/stereo_frag.glsl
  if (wall.stereo == StereoMode::topBottom) eye = halve(share.y);
  if (wall.flip == Flip::horizontal || wall.flip == Flip::both) share.x = 1.0 - share.x;
  if (wall.flip == Flip::vertical || wall.flip == Flip::both) share.y = 1.0 - share.y;
  glm::dvec2 inPicture(share.x, 1.0 - share.y);
  if (wall.screen) {
    const auto onScreen_m = inRoom_m(wall.screen->mesh, glm::clamp(inPicture, 0.0, 1.0));
    if (!onScreen_m) return std::nullopt;
    return PointedWall{*onScreen_m, eye, 0, wall.sky ? wall.sky->from_m : std::nullopt};
  }
  if (wall.skewed) {
    const glm::dvec3 place = pictureFromWindow(*wall.skewed) * glm::dvec3(inPicture, 1.0);
    if (!(place.z > 0.0)) return std::nullopt;  // so far beyond the pane that the screen's plane has ended
    inPicture = glm::dvec2(place) / place.z;
  }
  return PointedWall{wall.lowerLeft_m + inPicture.x * (wall.lowerRight_m - wall.lowerLeft_m) +
                         inPicture.y * (wall.upperLeft_m - wall.lowerLeft_m),
                     eye};
}

}  // namespace carom
