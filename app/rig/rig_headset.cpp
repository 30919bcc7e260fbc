#include "app/rig/rig_headset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "app/toml/toml_values.h"
#include "cave/room/headset_walls.h"
#include "cave/room/rectangle.h"

namespace carom {
namespace {

constexpr glm::ivec2 kEye_px{1024, 1024};  // until the headset tells

/// Reads the corners and the pixels of the board; the rest is as in the shipped rig.
Wall readBoard(const TomlTable& headset, double unit_m) {
  Wall board;
  board.name = "board";
  const auto place = [&](const TomlTable& table, std::string_view key) {
    return toVec3(table.numbers<3>(key)) * unit_m;
  };
  if (const auto table = headset.requiredTable("board")) {
    board.lowerLeft_m = place(*table, "lower_left");
    board.lowerRight_m = place(*table, "lower_right");
    board.upperLeft_m = place(*table, "upper_left");
    const auto pixels = table->numbers<2>("pixels");
    board.pixels = {static_cast<int>(pixels[0]), static_cast<int>(pixels[1])};
    const ThreeCorners corners{{board.lowerRight_m, board.lowerLeft_m, board.upperLeft_m},
                               {"lower_right", "lower_left", "upper_left"}};
    if (const auto fault = rectangleFault(board.name, corners))
      table->fault(corners.names[fault->corner], fault->what);
    else if (!(normalOf(board).z > std::sqrt(0.5)))
      table->fault(table->place(),
                   "the board does not face somebody who looks forward, expected that it does");
  }
  return board;
}

}  // namespace

void readHeadset(const TomlTable& root, const TomlTable& table, double unit_m, Rig& rig) {
  for (const char* key : {"head", "hand", "viewer", "tracker", "wall", "node", "frame_lock", "panel"})
    root.refuse(key, "has no meaning in the rig of a headset, expected none");
  if (rig.axes.up.y != 1.0)
    root.fault("axes", "a headset measures along 'x-right y-up z-back', expected these axes");
  rig.board = readBoard(table, unit_m);
  TrackerSetup& tracker = rig.trackers.emplace_back();
  tracker.name = "headset";
  tracker.kind = TrackerKind::headset;
  rig.viewers.front().hand = HandSetup{{.tracker = 0, .sensor = 1}, {}};
}

void placeEyes(Rig& rig) {
  if (!rig.oneWindow) rig.oneWindow = {.position_px = {40, 40}, .size_px = {1280, 640}, .border = true};
  const glm::ivec2 half_px{rig.oneWindow->size_px.x / 2, rig.oneWindow->size_px.y};
  for (const Eye side : {Eye::left, Eye::right}) {
    const double aside = side == Eye::left ? -0.5 : 0.5;
    const Vec3 place_m =
        rig.axes.up * kStandingEyes_m + aside * rig.viewers.front().head.eyeSeparation_m * rig.axes.right;
    Wall wall =
        wallBefore({{place_m, {1.0, 0.0, 0.0, 0.0}}, {}}, kEyeWalls[side == Eye::left ? 0 : 1], kEye_px);
    wall.stereo = side == Eye::left ? StereoMode::left : StereoMode::right;
    wall.onHead = true;
    wall.pictureNames = {"headset"};
    wall.window = {.position_px = {side == Eye::left ? 0 : half_px.x, 0}, .size_px = half_px};
    rig.walls.push_back(wall);
  }
}

void fitEyes(Rig& rig, glm::ivec2 eye_px) {
  glm::ivec2& mirror_px = rig.oneWindow->size_px;
  const int width_px = std::max(1, mirror_px.y * eye_px.x / eye_px.y);
  mirror_px.x = 2 * width_px;
  for (std::size_t eye = 0; eye < 2; ++eye) {
    Wall& wall = rig.walls[eye];
    wall.pixels = eye_px;
    wall.window.position_px.x = static_cast<int>(eye) * width_px;
    wall.window.size_px.x = width_px;
  }
}

}  // namespace carom
