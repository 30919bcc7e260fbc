#include "app/scenario/scenario_outline.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <string_view>

#include "app/toml/toml_values.h"
#include "cave/outlines/footprint.h"
#include "cave/outlines/mesh_from_above.h"
#include "engine/game/setup_check.h"
#include "engine/polygons/outline.h"

namespace carom {

namespace {

/// Gives the puck an outline of the size that `key` says.
void setOutline(const TomlTable& table, std::string_view key, Puck& puck,
                const std::vector<Vec2>& corners_m) {
  const double inertia = momentsOf(corners_m).inertia;
  if (!(inertia >= kLeastInertia && inertia <= 1.0)) {
    table.fault(key,
                fmt::format("the corners of puck '{}' are too near to each other, or too far from [0, 0], "
                            "for the digits of a number, expected them around its centre of mass",
                            puck.name));
    return;
  }
  puck.outline_m = corners_m;
  puck.radius_m = radiusOf_m(puck.outline_m);
  puck.inertia = inertia;
}

void takeCorners(const TomlTable& table, Puck& puck) {
  const auto points = table.points("outline_m");
  if (!points) return;
  std::vector<Vec2> corners_m;
  for (const PlacedPoint& point : *points) {
    if (std::isnan(point.at[0]) || std::isnan(point.at[1])) return;
    corners_m.push_back({point.at[0], point.at[1]});
  }
  if (const auto wrong = faultOf(corners_m)) {
    const FilePlace place =
        wrong->corner < points->size() ? (*points)[wrong->corner].place : table.place("outline_m");
    table.fault(place, fmt::format("outline_m of puck '{}': {}", puck.name, wrong->what));
    return;
  }
  setOutline(table, "outline_m", puck, corners_m);
}

/// Returns what a puck's mesh covers; none if there is a fault.
std::optional<Footprint> readFootprint(const TomlTable& table, const Puck& puck,
                                       const std::optional<PuckMesh>& mesh) {
  if (!mesh) {
    if (!table.has("mesh"))
      table.fault("outline", fmt::format("puck '{}' has no mesh, expected mesh = a file", puck.name));
    return {};
  }
  if (mesh->file.empty()) return {};  // there is no such file, which has been said
  try {
    return footprintOf(trianglesFromAbove(mesh->file.string()));
  } catch (const std::runtime_error& error) {
    table.fault("mesh", fmt::format("the mesh of puck '{}' gives no outline: {}", puck.name, error.what()));
    return {};
  }
}

/// Gives the puck the footprint of its mesh, so large that its farthest corner is at the radius.
void takeFootprint(const TomlTable& table, const Footprint& footprint, Puck& puck, PuckMesh& mesh) {
  mesh.place = {footprint.centre, puck.radius_m / footprint.radius};
  mesh.isInOnePiece = footprint.isInOnePiece;
  std::vector<Vec2> corners_m;
  for (const Vec2& corner : footprint.corners) corners_m.push_back(corner * mesh.place->scale);
  setOutline(table, "radius_m", puck, corners_m);
}

}  // namespace

void readShape(const TomlTable& table, Puck& puck, std::optional<PuckMesh>& mesh) {
  if (table.has("outline_m")) {
    table.refuse("outline", "stands beside outline_m, expected one of them");
    table.refuse(
        "radius_m",
        "stands beside outline_m, expected one of them: the radius of a puck with corners is that of its "
        "farthest corner");
    takeCorners(table, puck);
    return;
  }
  std::optional<Footprint> footprint;
  if (table.choice("outline", 1) == 0) footprint = readFootprint(table, puck, mesh);
  const bool outlineIsWrong = table.has("outline") && !footprint;
  if (outlineIsWrong && !table.has("radius_m")) return;  // the size of a shape that there is none of
  puck.radius_m = table.rightNumber("radius_m").value_or(0.0);
  if (footprint && puck.radius_m > 0.0) takeFootprint(table, *footprint, puck, *mesh);
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
