#include "app/stage/sky_rig.h"

#include <algorithm>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cave/room/room_geometry.h"
#include "cave/screen/sky_screen.h"

namespace carom {
namespace {

constexpr double kTexelsPerPixel = 1.25, kEyes_m = 1.7;
constexpr int kTallestWindow_px = 900;

glm::ivec2 sizeOf_px(const SkyPicture& picture) {
  const int size = picture.size_px;
  if (picture.kind == SkyKind::equirectangular) return {size, size / 2};
  return {picture.kind == SkyKind::cubemap ? 6 * size : size, size};
}

}  // namespace

Rig withSky(Rig rig, const SkyPicture& picture) {
  if (isHeadset(rig))
    throw std::runtime_error("--sky: this session was played with a headset, expected one of a room's walls");
  rig.panel = frontWall(roomGeometryOf(rig));
  const glm::dvec3 middle_m = picture.eye_m.value_or(kEyes_m * rig.axes.up);
  const Sky sky{picture.kind, std::numbers::pi, rig.axes.up, rig.axes.forward, middle_m};
  Wall wall;
  wall.name = "sky";
  wall.pixels = sizeOf_px(picture);
  wall.screen = std::make_shared<CurvedScreen>(screenOf(sky, wall.pixels, kTexelsPerPixel));
  wall.sky = SkyEyes{picture.eye_m, glm::cross(sky.front, sky.axis)};
  const int eyes = picture.twoEyes ? 2 : 1;
  const double scale = std::min(1.0, static_cast<double>(kTallestWindow_px) / (eyes * wall.pixels.y));
  wall.window = {.size_px = glm::max(glm::ivec2(glm::dvec2(wall.pixels) * scale), 1)};
  const glm::ivec2 place_px = wall.window.size_px;
  rig.walls = {wall};
  if (picture.twoEyes) {
    rig.walls.push_back(wall);
    rig.walls[0].name = "sky-left";
    rig.walls[0].stereo = StereoMode::left;
    rig.walls[1].name = "sky-right";
    rig.walls[1].stereo = StereoMode::right;
    rig.walls[1].window.position_px.y = place_px.y;
  }
  rig.oneWindow = WindowPlacement{.size_px = {place_px.x, eyes * place_px.y}, .border = true};
  rig.nodes.clear();
  return rig;
}

}  // namespace carom
