#include "app/rig/rig_screen.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "app/file_keys/rig_keys.h"
#include "app/toml/toml_values.h"
#include "cave/mesh_files/measured.h"
#include "cave/room/rectangle.h"
#include "cave/screen/curved_screen.h"

namespace carom {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kEyes_m = 1.7;         // above the floor, where the height of eyes is not known
constexpr double kReach_m = 1.5;        // of somebody who walks
constexpr double kBoardBefore_m = 3.0;  // from the eyes, where no screen stands

/// Returns places before a cylinder where eyes may be: about its axis.
std::vector<glm::dvec3> eyesBefore(const CylinderScreen& screen, const RoomAxes& axes) {
  const double atEyes_m = glm::dot(kEyes_m * axes.up - screen.foot_m, screen.axis);
  const glm::dvec3 middle_m =
      screen.foot_m + std::clamp(atEyes_m, screen.bottom_m, screen.top_m) * screen.axis;
  return eyesAround(middle_m, axes.up, std::min(kReach_m, 0.5 * screen.radius_m));
}

/// Returns such places before a dome: about the vertical through its centre.
std::vector<glm::dvec3> eyesBefore(const DomeScreen& screen, const RoomAxes& axes) {
  const double reach_m = std::min(kReach_m, 0.5 * screen.radius_m);
  const double above_m = kEyes_m - glm::dot(screen.centre_m, axes.up);
  return eyesAround(screen.centre_m + std::clamp(above_m, -reach_m, reach_m) * axes.up, axes.up, reach_m);
}

CylinderScreen readCylinder(const TomlTable& table, const RoomAxes& axes, double unit_m) {
  CylinderScreen screen;
  screen.foot_m = toVec3(table.numbers<3>("foot")) * unit_m;
  const glm::dvec3 axis = toVec3(table.numbers<3>("axis"));
  if (glm::length(axis) > 0.0)
    screen.axis = glm::normalize(axis);
  else
    table.fault("axis", "the axis has no length, expected a direction such as [0, 1, 0]");
  screen.ahead = aheadOf(screen.axis, axes);
  screen.radius_m = table.number("radius") * unit_m;
  screen.from_rad = table.number("from_deg") * kDegree;
  screen.to_rad = table.number("to_deg") * kDegree;
  screen.bottom_m = table.number("bottom") * unit_m;
  screen.top_m = table.number("top") * unit_m;
  const double turn_deg = (screen.to_rad - screen.from_rad) / kDegree;
  if (!(turn_deg > 0.0 && turn_deg <= 360.0))
    table.fault("to_deg",
                fmt::format("the screen turns by {:g}° from from_deg to to_deg, expected more than 0 and "
                            "at most 360°",
                            turn_deg));
  if (!(screen.top_m > screen.bottom_m))
    table.fault("top", "the top is not above the bottom, expected a higher one");
  return screen;
}

/// Unit vectors at a right angle: an axis that leans forward from upright, and the front to which it leans.
struct Leaning {
  glm::dvec3 axis, front;
};

Leaning readLeaning(const TomlTable& table, const RoomAxes& axes) {
  const double tilt_rad = table.number("tilt_deg") * kDegree,
               heading_rad = table.number("heading_deg") * kDegree;
  const glm::dvec3 heading = std::cos(heading_rad) * axes.forward + std::sin(heading_rad) * axes.right;
  return {std::cos(tilt_rad) * axes.up + std::sin(tilt_rad) * heading,
          std::cos(tilt_rad) * heading - std::sin(tilt_rad) * axes.up};
}

DomeScreen readDome(const TomlTable& table, const RoomAxes& axes, double unit_m) {
  DomeScreen screen;
  screen.centre_m = toVec3(table.numbers<3>("centre")) * unit_m;
  screen.radius_m = table.number("radius") * unit_m;
  screen.fov_rad = table.number("fov_deg") * kDegree;
  const Leaning leaning = readLeaning(table, axes);
  screen.axis = leaning.axis;
  screen.front = leaning.front;
  return screen;
}

SkyText readSky(const TomlTable& table, const RoomAxes& axes, double unit_m) {
  const Leaning leaning = readLeaning(table, axes);
  SkyText text{{static_cast<SkyKind>(table.choice("kind")), table.number("fov_deg") * kDegree, leaning.axis,
                leaning.front, kEyes_m * axes.up},
               {{}, glm::cross(leaning.front, leaning.axis)}};
  if (table.has("from")) text.sky.middle_m = toVec3(table.numbers<3>("from")) * unit_m;
  if (table.has("from")) text.eyes.from_m = text.sky.middle_m;
  return text;
}

MeasuredScreen readMeasured(const TomlFile& file, const TomlTable& table, bool isGrid, double unit_m) {
  MeasuredScreen screen;
  screen.isGrid = isGrid;
  screen.unit_m = table.has("unit") ? kMetresPerUnit[table.choice("unit")] : unit_m;
  screen.rows = static_cast<GridRows>(table.choice("rows"));
  screen.roomFromScreen = readPose(table, "room_from_screen", unit_m);
  if (!isGrid) table.refuse("rows", "is of a grid, expected none");
  screen.file = file.existingFile(table, "file", isGrid ? InputKind::screenGrid : InputKind::screenMesh,
                                  Reach::anywhere);
  const std::string ending = screen.file.extension().string();
  const bool isKnown = isGrid ? ending == ".pfm" || ending == ".vwf" : ending == ".obj";
  if (!screen.file.empty() && !isKnown)
    table.fault("file", fmt::format("file is '{}', expected a file ending in {}",
                                    screen.file.filename().string(), isGrid ? ".pfm or .vwf" : ".obj"));
  return screen;
}

/// Returns the place at the height of the eyes where a line from them meets a screen, `turn_rad` to the right
/// of ahead and `rise_rad` above, or none.
std::optional<glm::dvec3> onScreens_m(const Rig& rig, const glm::dvec3& eyes_m, double turn_rad,
                                      double rise_rad) {
  const RoomAxes& axes = rig.axes;
  const glm::dvec3 along =
      std::cos(rise_rad) * (std::cos(turn_rad) * axes.forward + std::sin(turn_rad) * axes.right) +
      std::sin(rise_rad) * axes.up;
  for (const Wall& wall : rig.walls) {
    if (!wall.screen) continue;
    const auto place = hit(wall.screen->mesh, eyes_m, along);
    if (place) return wall.sky ? eyes_m + kBoardBefore_m * along : place->inRoom_m;
  }
  return std::nullopt;
}

Wall board(const glm::dvec3& lowerLeft_m, const glm::dvec3& lowerRight_m, const glm::dvec3& upperLeft_m) {
  constexpr double kPerMetre = 480.0;  // pixels: an eye at 3 m resolves a little more
  constexpr double kMost_px = 4096.0;
  Wall wall;
  wall.name = "panel";
  wall.lowerLeft_m = lowerLeft_m;
  wall.lowerRight_m = lowerRight_m;
  wall.upperLeft_m = upperLeft_m;
  const glm::dvec2 size_m(glm::distance(lowerLeft_m, lowerRight_m), glm::distance(lowerLeft_m, upperLeft_m));
  wall.pixels = glm::ivec2(glm::clamp(kPerMetre * size_m, 64.0, kMost_px));
  return wall;
}

/// Returns a board between the places that are seen 30° to the left and right of ahead, as high as the screen
/// there reaches, at most as high as a picture of 16:9.
std::optional<Wall> chordOf(const Rig& rig) {
  constexpr double kHalf_rad = 30.0 * kDegree, kStep_rad = 1.0 * kDegree;
  const glm::dvec3 eyes_m = kEyes_m * rig.axes.up;
  const auto left = onScreens_m(rig, eyes_m, -kHalf_rad, 0.0),
             right = onScreens_m(rig, eyes_m, kHalf_rad, 0.0);
  if (!left || !right) return std::nullopt;
  const double width_m = glm::distance(*left, *right);
  const auto reach_m = [&](double side) {  // along the board, as high or low as the screen is seen beside it
    double height_m = 0.0;
    for (double rise = kStep_rad; rise < 60.0 * kDegree; rise += kStep_rad) {
      const auto place = onScreens_m(rig, eyes_m, -kHalf_rad, side * rise);
      if (!place) break;
      height_m = std::abs(glm::dot(*place - *left, rig.axes.up));
    }
    return height_m;
  };
  const double below_m = std::min(reach_m(-1.0), 9.0 / 16.0 * width_m * 0.5);
  const double above_m = std::min(reach_m(1.0), 9.0 / 16.0 * width_m - below_m);
  if (!(below_m + above_m > 0.1)) return std::nullopt;
  return board(*left - below_m * rig.axes.up, *right - below_m * rig.axes.up, *left + above_m * rig.axes.up);
}

}  // namespace

glm::dvec3 aheadOf(const glm::dvec3& axis, const RoomAxes& axes) {
  const glm::dvec3 ahead = axes.forward - glm::dot(axes.forward, axis) * axis;
  return glm::length(ahead) > 1e-3 ? glm::normalize(ahead) : axes.right;
}

double sagittaFor_m(const ScreenFormula& shape) {
  // As shares of the radius: a whole cylinder takes 57 pieces, half a sphere 36.
  constexpr double kOfCylinder = 0.0015, kOfDome = 0.06;
  double least_m = 0.0;
  if (const auto* cylinder = std::get_if<CylinderScreen>(&shape)) least_m = kOfCylinder * cylinder->radius_m;
  if (const auto* dome = std::get_if<DomeScreen>(&shape)) least_m = kOfDome * dome->radius_m;
  return std::max(kUsualSagitta_m, least_m);
}

std::optional<ScreenText> readScreen(const TomlFile& file, const TomlTable& wallTable, const RoomAxes& axes,
                                     double unit_m) {
  const auto table = wallTable.table("screen");
  const auto sky = table ? std::nullopt : wallTable.table("sky");
  const auto refuse = [&](std::initializer_list<const char*> keys, const char* why) {
    for (const char* key : keys) wallTable.refuse(key, why);
  };
  if (!table) refuse({"facet_sagitta"}, "is of a wall with a screen, expected none");
  if (!table && !sky) {
    refuse({"texels_per_pixel"}, "is of a wall with a screen or a sky, expected none");
    return std::nullopt;
  }
  refuse({"lower_left", "lower_right", "upper_left", "upper_right", "skewed"},
         "is of a flat wall, expected none beside screen or sky");
  ScreenText text;
  text.texelsPerPixel = wallTable.number("texels_per_pixel");
  if (!table) {
    text.shape = readSky(*sky, axes, unit_m);
    return text;
  }
  refuse({"warp", "warp_red", "warp_green", "warp_blue"}, "is of a flat wall, expected none beside screen");
  refuse({"sky"}, "is of a wall without a screen, expected one of them");
  const std::size_t shape = table->choice("shape");
  constexpr std::size_t kDome = 1, kGrid = 3;
  if (shape == 0)
    text.shape = readCylinder(*table, axes, unit_m);
  else if (shape == kDome)
    text.shape = readDome(*table, axes, unit_m);
  else
    text.shape = readMeasured(file, *table, shape == kGrid, unit_m);
  if (wallTable.has("facet_sagitta")) text.sagitta_m = wallTable.number("facet_sagitta") * unit_m;
  return text;
}

namespace {

template <class Shape>
CurvedScreen screenOf(const Shape& shape, const ScreenText& text, const glm::ivec2& window_px,
                      const RoomAxes& axes) {
  const std::vector<glm::dvec3> eyes_m = eyesBefore(shape, axes);
  CurvedScreen screen =
      curvedScreen(meshOf(shape, window_px), {window_px, text.texelsPerPixel, text.sagitta_m, eyes_m});
  screen.shape = shape;
  return screen;
}

CurvedScreen screenOf(const SkyText& sky, const ScreenText& text, const glm::ivec2& window_px,
                      const RoomAxes& /*axes*/) {
  return screenOf(sky.sky, window_px, text.texelsPerPixel);
}

CurvedScreen screenOf(const MeasuredScreen& measured, const ScreenText& text, const glm::ivec2& window_px,
                      const RoomAxes& axes) {
  return screenOf(measured, {window_px, text.texelsPerPixel, text.sagitta_m, axes.up, kEyes_m, kReach_m});
}

/// Returns the place of the screen that is nearest to a corner of the window.
glm::dvec3 cornerOf_m(const ScreenMesh& mesh, const glm::dvec2& corner) {
  const ScreenPoint* nearest = &mesh.front()[0];
  for (const ScreenTriangle& triangle : mesh) {
    for (const ScreenPoint& point : triangle)
      if (glm::distance(point.inWindow, corner) < glm::distance(nearest->inWindow, corner)) nearest = &point;
  }
  return nearest->inRoom_m;
}

}  // namespace

std::optional<ScreenFault> curve(const ScreenText& text, const RoomAxes& axes, Wall& wall) {
  std::shared_ptr<CurvedScreen> screen;
  try {
    screen = std::make_shared<CurvedScreen>(
        std::visit([&](const auto& shape) { return screenOf(shape, text, wall.pixels, axes); }, text.shape));
  } catch (const std::runtime_error& fault) {
    return ScreenFault{true, fault.what()};
  }
  const ScreenMesh& mesh = screen->mesh;
  wall.lowerLeft_m = cornerOf_m(mesh, {0, 0});
  wall.lowerRight_m = cornerOf_m(mesh, {1, 0});
  wall.upperLeft_m = cornerOf_m(mesh, {0, 1});
  if (const auto* sky = std::get_if<SkyText>(&text.shape)) wall.sky = sky->eyes;
  wall.screen = std::move(screen);
  if (!wall.screen->pieces.empty()) return std::nullopt;
  return ScreenFault{
      false, fmt::format("the screen is deeper than {:.0f} mm in more than {} flat pieces, expected a larger "
                         "facet_sagitta",
                         text.sagitta_m * 1e3, kMostPieces)};
}

void refuseScreen(const ScreenFault& fault, const TomlTable& wallTable) {
  if (const auto screen = wallTable.table("screen"); fault.isOfFile && screen)
    screen->fault("file", fault.what);
  else
    wallTable.fault("facet_sagitta", fault.what);
}

std::optional<Wall> readPanel(const TomlTable& root, double unit_m) {
  const auto table = root.table("panel");
  if (!table) return std::nullopt;
  const auto corner = [&](std::string_view key) { return toVec3(table->numbers<3>(key)) * unit_m; };
  return board(corner("lower_left"), corner("lower_right"), corner("upper_left"));
}

void settlePanel(const TomlTable& root, Rig& rig) {
  if (const auto table = root.table("panel")) {
    const Wall& panel = *rig.panel;
    const ThreeCorners corners{{panel.lowerRight_m, panel.lowerLeft_m, panel.upperLeft_m},
                               {"lower_right", "lower_left", "upper_left"}};
    if (const auto fault = rectangleFault(panel.name, corners))
      table->fault(corners.names[fault->corner], fault->what);
    else if (!(-glm::dot(normalOf(panel), rig.axes.forward) > std::sqrt(0.5)))
      table->fault(table->place(),
                   "the panel does not face somebody who looks forward, expected that it does");
    else if (!(glm::dot(panel.lowerLeft_m, rig.axes.forward) > 0.0))
      table->fault(table->place(), "the panel is behind the head, expected one ahead");
    return;
  }
  const bool isCurved = std::any_of(rig.walls.begin(), rig.walls.end(),
                                    [](const Wall& wall) { return wall.screen != nullptr; });
  RoomGeometry flat{{}, rig.axes.up, rig.axes.forward};
  std::copy_if(rig.walls.begin(), rig.walls.end(), std::back_inserter(flat.walls),
               [](const Wall& wall) { return !wall.screen; });
  if (isCurved && !frontWall(flat)) rig.panel = chordOf(rig);
}

}  // namespace carom
