#include "cave/scene/table_model.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace carom {
namespace {

constexpr double kRailTop_m = 0.045;     // above the cloth
constexpr double kRailMiddle_m = 0.105;  // outwards from the cushion's edge: the place of diamonds and clocks
constexpr double kRailEnd_m = 0.175;
constexpr double kClockWidth_m = 0.26;
constexpr double kTableCell_m = 0.05;

const glm::vec3 kClothColour(0.030F, 0.185F, 0.085F);
const glm::vec3 kWoodColour(0.23F, 0.085F, 0.034F);

/// One of the four sides: `outwards` points away from the cloth, and along × outwards points up.
struct Side {
  glm::dvec2 along;
  glm::dvec2 outwards;
  double halfLength_m;
  double fromCentre_m;
  double diamondSpacing_m;
};

std::array<Side, 4> sidesOf(const Board& board) {
  const double x = 0.5 * board.length_m;
  const double y = 0.5 * board.width_m;
  const double onLong = board.length_m / 8.0;
  const double onShort = board.width_m / 4.0;
  return {Side{{1, 0}, {0, 1}, x, y, onLong}, Side{{0, 1}, {-1, 0}, y, x, onShort},
          Side{{-1, 0}, {0, -1}, x, y, onLong}, Side{{0, -1}, {1, 0}, y, x, onShort}};
}

/// Returns the number of cells along a side of the cloth: as many as the frame's outer edge needs, and the
/// same in all parts that meet there.
int cellsAlong(double side_m, double cell_m) { return tiledCells(side_m + 2.0 * kRailEnd_m, cell_m); }

/// Adds a strip of the frame around the cloth, mitred at the corners, with the profile from `from` to `to` in
/// (outwards, z).
void addStrip(MeshBuilder& mesh, const Board& board, const glm::dvec2& from, const glm::dvec2& to,
              double cell_m) {
  const bool diamonds = from.y == kRailTop_m && to.y == kRailTop_m;
  for (const Side& side : sidesOf(board)) {
    mesh.addPatch(cellsAlong(2.0 * side.halfLength_m, cell_m), tiledCells(glm::distance(from, to), cell_m),
                  [&](double u, double v) {
                    const glm::dvec2 p = from + v * (to - from);
                    const double along_m = (2.0 * u - 1.0) * (side.halfLength_m + p.x);
                    const glm::dvec2 place = along_m * side.along + (side.fromCentre_m + p.x) * side.outwards;
                    return PatchPoint{{place, p.y},
                                      {along_m, p.x - kRailMiddle_m, diamonds ? side.diamondSpacing_m : 0.0}};
                  });
  }
}

void addProfile(MeshBuilder& mesh, const Board& board, const std::vector<glm::dvec2>& profile,
                double cell_m) {
  for (std::size_t i = 0; i + 1 < profile.size(); ++i)
    addStrip(mesh, board, profile[i], profile[i + 1], cell_m);
}

/// Adds a square leg that is narrower at its foot.
void addLeg(MeshBuilder& mesh, const glm::dvec2& at, double top_m, double floor_m, double cell_m) {
  const std::array<glm::dvec2, 4> corners{{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec2 a = corners[i];
    const glm::dvec2 b = corners[(i + 1) % 4];
    mesh.addPatch(tiledCells(0.15, std::min(0.075, cell_m)),
                  tiledCells(top_m - floor_m, std::min(0.075, cell_m)), [&](double u, double v) {
                    const double half_m = 0.075 - 0.03 * v;
                    const glm::dvec2 place = at + half_m * (b + u * (a - b));
                    return PatchPoint{{place, top_m + v * (floor_m - top_m)},
                                      {0.3 * static_cast<double>(i), 0.05 * u, 0.0}};
                  });
  }
}

void addLegs(MeshBuilder& mesh, const Board& board, double floor_m, double cell_m) {
  const double x = 0.5 * board.length_m - 0.12;
  const double y = 0.5 * board.width_m - 0.10;
  for (const double sx : {-1.0, 0.0, 1.0}) {
    if (sx == 0.0 && board.length_m < 2.2) continue;
    for (const double sy : {-1.0, 1.0}) addLeg(mesh, {sx * x, sy * y}, -0.30, floor_m, cell_m);
  }
}

ScenePart clothPart(const glm::dvec2& size_m, double cell_m) {
  MeshBuilder cloth;
  cloth.addPatch(cellsAlong(size_m.x, cell_m), cellsAlong(size_m.y, cell_m), [&](double u, double v) {
    return PatchPoint{{(u - 0.5) * size_m.x, (v - 0.5) * size_m.y, 0.0}, {size_m, 0.0}};
  });
  return {kRestingBody, cloth.build(), Paint::cloth, kClothColour, 0.0F};
}

}  // namespace

std::vector<ScenePart> tableParts(const Board& board, double floor_m) {
  constexpr double cell_m = kTableCell_m;
  MeshBuilder cushions;
  addProfile(cushions, board, {{0.0, 0.0}, {0.0, 0.034}, {0.012, 0.040}, {0.05, kRailTop_m}}, cell_m);
  MeshBuilder wood;
  addProfile(wood, board,
             {{0.05, kRailTop_m},
              {0.16, kRailTop_m},
              {kRailEnd_m, 0.030},
              {kRailEnd_m, -0.10},
              {0.13, -0.13},
              {0.05, -0.13},
              {0.0, -0.32},
              {-0.30, -0.32}},
             cell_m);
  addLegs(wood, board, floor_m, cell_m);

  ClockMaker clocks;
  for (const Side& side : sidesOf(board)) {
    // The clocks stand at the quarters of the long rails, out of the way of a person at their middle.
    const glm::dvec2 middle = (side.fromCentre_m + kRailMiddle_m) * side.outwards;
    const bool isLong = side.outwards.x == 0.0;
    const double aside_m = isLong ? 0.5 * side.halfLength_m : 0.0;
    for (const double sign : isLong ? std::vector{-1.0, 1.0} : std::vector{1.0}) {
      clocks.add({middle + sign * aside_m * side.along, kRailTop_m}, {side.outwards, 0.0}, kClockWidth_m,
                 cell_m);
    }
  }
  std::vector<ScenePart> parts;
  parts.push_back(clothPart({board.length_m, board.width_m}, cell_m));
  parts.push_back({kRestingBody, cushions.build(), Paint::plain, 0.85F * kClothColour, 0.0F});
  parts.push_back({kRestingBody, wood.build(), Paint::wood, kWoodColour, 0.14F});
  for (ScenePart& part : clocks.parts()) parts.push_back(std::move(part));
  return parts;
}

std::vector<ScenePart> openPlaneParts(double size_m) { return {clothPart({size_m, size_m}, kTableCell_m)}; }

void ClockMaker::add(const glm::dvec3& foot_m, const glm::dvec3& facing, double width_m, double cell_m) {
  cell_m = std::max(cell_m, width_m / 8.0);
  const glm::dvec3 up(0.0, 0.0, 1.0);
  const double height_m = 0.46 * width_m;
  const double depth_m = 0.10 * width_m;
  for (const double sign : {1.0, -1.0}) {
    const glm::dvec3 out = sign * facing;
    const glm::dvec3 right = glm::cross(up, out);  // for a person who looks at this face
    const glm::dvec3 corner = foot_m + 0.5 * depth_m * out - 0.5 * width_m * right;
    // The whole side is one face with a painted bezel: two layers would intersect once light bends them. The
    // digits' field is 0.9 times as wide as the side and, as body_vert.glsl relies on, 0.4 times as high as
    // it is wide.
    const double field_m = 0.9 * width_m;
    faces_.addPatch(tiledCells(width_m, cell_m), tiledCells(height_m, cell_m), [&](double u, double v) {
      return PatchPoint{
          corner + u * width_m * right + v * height_m * up,
          {2.0 + 4.0 * (u - 0.5) * width_m / field_m, 0.5 + (v - 0.5) * height_m / (0.4 * field_m), field_m}};
    });
    // One of the narrow sides and, once, the top.
    cases_.addFlat(corner + width_m * right, -depth_m * out, height_m * up, cell_m);
    if (sign > 0.0) cases_.addFlat(corner + height_m * up, width_m * right, -depth_m * out, cell_m);
  }
}

std::vector<ScenePart> ClockMaker::parts() const {
  return {{kRestingBody, cases_.build(), Paint::plain, glm::vec3(0.035F, 0.033F, 0.030F), 0.2F},
          {kRestingBody, faces_.build(), Paint::clock, glm::vec3(1.0F, 0.50F, 0.09F), 0.0F}};
}

}  // namespace carom
