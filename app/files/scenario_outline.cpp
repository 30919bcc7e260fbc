#include "app/files/scenario_outline.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <string_view>

#include "app/files/toml_values.h"
#include "cave/outlines/footprint.h"
#include "cave/outlines/mesh_from_above.h"
#include "engine/collision/outline.h"

namespace carom {

namespace {

/// A square, for what else is to be checked of a puck whose corners are wrong.
const std::vector<Vec2> kPlaceholder_m{{-0.03, -0.03}, {0.03, -0.03}, {0.03, 0.03}, {-0.03, 0.03}};

void setOutline(Puck& puck, const std::vector<Vec2>& corners_m) {
  puck.outline_m = corners_m;
  puck.radius_m = radiusOf_m(puck.outline_m);
  puck.inertia = momentsOf(puck.outline_m).inertia;
}

void takeCorners(const TomlTable& table, Puck& puck) {
  bool known = true;
  const std::vector<PlacedPoint> points = table.boardPoints("outline_m");
  std::vector<Vec2> corners_m;
  for (const PlacedPoint& point : points) {
    known = known && !std::isnan(point.at[0]) && !std::isnan(point.at[1]);
    corners_m.push_back({point.at[0], point.at[1]});
  }
  if (known) {
    if (const auto wrong = faultOf(corners_m)) {
      const FilePlace place =
          wrong->corner < points.size() ? points[wrong->corner].place : table.place("outline_m");
      table.fault(place, fmt::format("outline_m of puck '{}': {}", puck.name, wrong->what));
      known = false;
    }
  }
  setOutline(puck, known ? corners_m : kPlaceholder_m);
}

/// Gives the puck the footprint of its mesh, so large that its farthest corner is at the radius.
void takeFootprint(const TomlTable& table, Puck& puck, std::optional<PuckMesh>& mesh) {
  if (!mesh) {
    if (!table.has("mesh"))
      table.fault("outline", fmt::format("puck '{}' has no mesh, expected mesh = a file", puck.name));
    return;
  }
  try {
    const Footprint footprint = footprintOf(trianglesFromAbove(mesh->file.string()));
    mesh->place = {footprint.centre, puck.radius_m / footprint.radius};
    mesh->isInOnePiece = footprint.isInOnePiece;
    std::vector<Vec2> corners_m;
    for (const Vec2& corner : footprint.corners) corners_m.push_back(corner * mesh->place->scale);
    setOutline(puck, corners_m);
  } catch (const std::runtime_error& error) {
    table.fault("mesh", fmt::format("the mesh of puck '{}' gives no outline: {}", puck.name, error.what()));
  }
}

}  // namespace

void readShape(const TomlTable& table, Puck& puck, std::optional<PuckMesh>& mesh) {
  constexpr std::array<std::string_view, 1> kOutlines{"mesh"};
  const bool ofMesh = table.has("outline");
  if (ofMesh) table.choice("outline", kOutlines);
  if (!table.has("outline_m")) {
    puck.radius_m = table.number("radius_m", kPositive);
    if (ofMesh) takeFootprint(table, puck, mesh);
    return;
  }
  if (ofMesh) table.fault("outline", "outline stands beside outline_m, expected one of them");
  if (table.has("radius_m")) {
    table.fault("radius_m",
                "radius_m stands beside outline_m, expected one of them: the radius of a puck with "
                "corners is that of its farthest corner");
    table.number("radius_m", kPositive);
  }
  takeCorners(table, puck);
}

std::vector<Finding> oddOutline(const TomlTable& table, const Puck& puck,
                                const std::optional<PuckMesh>& mesh) {
  constexpr double kBeside = 0.01;  // of the radius
  if (puck.outline_m.empty()) return {};
  std::vector<Finding> odd;
  const glm::dvec2 centre_m = momentsOf(puck.outline_m).centre;
  if (glm::length(centre_m) > kBeside * puck.radius_m) {
    odd.push_back({.at = table.place("outline_m"),
                   .text = fmt::format(
                       "the centre of mass of an even plate with the outline of puck '{}' is at ({:.6g}, "
                       "{:.6g}) m, expected the corners to be given from there",
                       puck.name, centre_m.x, centre_m.y)});
  }
  if (!mesh || !mesh->place) return odd;
  if (!mesh->isInOnePiece) {
    odd.push_back(
        {.at = table.place("mesh"),
         .text = fmt::format("the mesh of puck '{}' covers several pieces of the table, so the puck collides "
                             "by the hull around them, expected one piece",
                             puck.name)});
  }
  if (puck.outline_m.size() > kEnoughCorners) {
    odd.push_back(
        {.at = table.place("outline"),
         .text = fmt::format("the footprint of puck '{}' needs {} corners to be right to {} % of the radius, "
                             "so its collisions take longer, expected at most {}",
                             puck.name, puck.outline_m.size(), 100.0 * kFootprintOutwards, kEnoughCorners)});
  }
  return odd;
}

}  // namespace carom
