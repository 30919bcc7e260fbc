#include "cave/scene/hall_model.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cave/mesh/mesh_builder.h"
#include "cave/scene/table_model.h"

namespace carom {
namespace {

constexpr double kHallCell_m =
    1.0 / 6.0;  // the same for all parts that meet: different cells would leave cracks
constexpr double kColumnCell_m = 0.3;
constexpr float kPolish = 0.12F;  // roughness of the floor's stone

ScenePart floorPart(const Hall& hall, double cell_m) {
  MeshBuilder floor;
  floor.addPatch(tiledCells(hall.size_m.x, cell_m), tiledCells(hall.size_m.y, cell_m),
                 [&](double u, double v) {
                   const glm::dvec2 place((u - 0.5) * hall.size_m.x, (v - 0.5) * hall.size_m.y);
                   return PatchPoint{{place, hall.floor_m}};
                 });
  return {kRestingBody, floor.build(), Paint::floor, glm::vec3(0.50F, 0.43F, 0.34F), kPolish};
}

/// Returns the middles of the flat lamps under the ceiling.
std::array<glm::dvec2, 16> ceilingLamps(const Hall& hall) {
  std::array<glm::dvec2, 16> middles;
  for (std::size_t i = 0; i < middles.size(); ++i) {
    const double row = static_cast<double>(i / 4), column = static_cast<double>(i % 4);
    middles[i] = {(row - 1.5) * 0.26 * hall.size_m.x, (column - 1.5) * 0.25 * hall.size_m.y};
  }
  return middles;
}

/// Returns what those lamps add to the ceiling's light.
double lightBesideLamps(const Hall& hall, const glm::dvec2& place) {
  double light = 0.0;
  for (const glm::dvec2& lamp : ceilingLamps(hall)) {
    const glm::dvec2 way = (place - lamp) / glm::dvec2(1.0, 0.7);
    light += std::exp(-glm::dot(way, way));
  }
  return 0.75 * light;
}

ScenePart ceilingPart(const Hall& hall, double cell_m) {
  MeshBuilder ceiling;
  const double z = hall.floor_m + hall.size_m.z;
  ceiling.addPatch(tiledCells(hall.size_m.x, cell_m), tiledCells(hall.size_m.y, cell_m),
                   [&](double u, double v) {
                     const glm::dvec2 place((0.5 - u) * hall.size_m.x, (v - 0.5) * hall.size_m.y);
                     return PatchPoint{{place, z}, {place, -lightBesideLamps(hall, place)}};
                   });
  return {kRestingBody, ceiling.build(), Paint::panels, kHallColours[4], 0.0F};
}

/// Returns the wall in the direction `outwards`, `half_m` from the middle.
ScenePart wallPart(const Hall& hall, const glm::dvec2& outwards, const glm::vec3& colour, double cell_m) {
  const glm::dvec2 along(outwards.y, -outwards.x);  // to the right, for a person who looks at the wall
  const double half_m = 0.5 * (outwards.x == 0.0 ? hall.size_m.y : hall.size_m.x);
  const double width_m = outwards.x == 0.0 ? hall.size_m.x : hall.size_m.y;
  MeshBuilder wall;
  wall.addPatch(tiledCells(width_m, cell_m), tiledCells(hall.size_m.z, cell_m), [&](double u, double v) {
    const double along_m = (u - 0.5) * width_m;
    const double up_m = v * hall.size_m.z;
    return PatchPoint{{half_m * outwards + along_m * along, hall.floor_m + up_m}, {along_m, up_m, 1.1}};
  });
  return {kRestingBody, wall.build(), Paint::panels, colour, 0.0F};
}

/// Returns round columns in two rows along the walls towards ±y, with base and capital.
ScenePart columnsPart(const Hall& hall) {
  MeshBuilder columns;
  const double top_m = hall.size_m.z;
  const std::vector<glm::dvec2> profile{{0.30, 0.0},          {0.30, 0.25},         {0.20, 0.32},
                                        {0.20, top_m - 0.45}, {0.32, top_m - 0.25}, {0.32, top_m}};
  for (const double sy : {-1.0, 1.0}) {
    for (int i = 0; i < 4; ++i) {
      const double x = (i - 1.5) * 0.26 * hall.size_m.x;
      columns.addTurned({x, sy * (0.5 * hall.size_m.y - 0.9), hall.floor_m}, profile, 20, kColumnCell_m);
    }
  }
  return {kRestingBody, columns.build(), Paint::plain, glm::vec3(0.60F, 0.56F, 0.48F), 0.35F};
}

std::vector<ScenePart> wallClocks(const Hall& hall, double cell_m) {
  ClockMaker clocks;
  const double z = hall.floor_m + 2.6;
  const double x = 0.5 * hall.size_m.x - 0.1;
  const double y = 0.5 * hall.size_m.y - 0.1;
  // The clocks are off the middle, where a split wall has its line: there is one for each half.
  for (const double aside_m : {-0.95, 0.95}) {
    clocks.add({aside_m, y, z}, {0, -1, 0}, 1.1, cell_m);
    clocks.add({aside_m, -y, z}, {0, 1, 0}, 1.1, cell_m);
    clocks.add({x, aside_m, z}, {-1, 0, 0}, 1.1, cell_m);
    clocks.add({-x, aside_m, z}, {1, 0, 0}, 1.1, cell_m);
  }
  return clocks.parts();
}

/// Returns flat lamps under the ceiling.
ScenePart ceilingLampsPart(const Hall& hall, double cell_m) {
  MeshBuilder lamps;
  const double z = hall.floor_m + hall.size_m.z - 0.03;
  for (const glm::dvec2& middle : ceilingLamps(hall)) {
    const glm::dvec3 corner(middle.x + 0.6, middle.y - 0.2, z);
    lamps.addFlat(corner, {-1.2, 0.0, 0.0}, {0.0, 0.4, 0.0}, cell_m);
  }
  return {kRestingBody, lamps.build(), Paint::lamp, glm::vec3(1.0F, 0.97F, 0.92F), 0.0F};
}

}  // namespace

std::vector<ScenePart> hallParts(const Hall& hall) {
  constexpr double cell_m = kHallCell_m;
  std::vector<ScenePart> parts = wallClocks(hall, cell_m);
  parts.push_back(columnsPart(hall));
  parts.push_back(wallPart(hall, {0, 1}, kHallColours[2], cell_m));
  parts.push_back(wallPart(hall, {0, -1}, kHallColours[3], cell_m));
  parts.push_back(wallPart(hall, {1, 0}, kHallColours[0], cell_m));
  parts.push_back(wallPart(hall, {-1, 0}, kHallColours[1], cell_m));
  parts.push_back(floorPart(hall, cell_m));
  parts.push_back(ceilingLampsPart(hall, cell_m));
  parts.push_back(ceilingPart(hall, cell_m));
  return parts;
}

std::vector<ScenePart> lampParts(std::span<const glm::dvec3> lamps_m, double ceiling_m) {
  constexpr double cell_m = 0.1;
  MeshBuilder shades;
  MeshBuilder bulbs;
  for (const glm::dvec3& lamp : lamps_m) {
    shades.addTurned(lamp, {{0.22, 0.0}, {0.12, 0.10}, {0.03, 0.15}, {0.008, 0.16}}, 24, cell_m);
    shades.addTurned(lamp, {{0.008, 0.16}, {0.008, ceiling_m - lamp.z}}, 6, cell_m);
    bulbs.addTurned(lamp, {{0.0, 0.0}, {0.11, 0.0}, {0.22, 0.0}}, 24, cell_m);
  }
  return {{kRestingBody, shades.build(), Paint::plain, glm::vec3(0.03F, 0.10F, 0.06F), 0.18F},
          {kRestingBody, bulbs.build(), Paint::lamp, glm::vec3(2.6F, 2.3F, 1.9F), 0.0F}};
}

}  // namespace carom
