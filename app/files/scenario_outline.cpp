#include "app/files/scenario_outline.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "app/files/toml_values.h"
#include "engine/collision/outline.h"

namespace carom {

namespace {

/// A square, for what else is to be checked of a puck whose corners are wrong.
const std::vector<Vec2> kPlaceholder_m{{-0.03, -0.03}, {0.03, -0.03}, {0.03, 0.03}, {-0.03, 0.03}};

}  // namespace

void readShape(const TomlTable& table, Puck& puck) {
  if (!table.has("outline_m")) {
    puck.radius_m = table.number("radius_m", kPositive);
    return;
  }
  if (table.has("radius_m"))
    table.fault("radius_m",
                "radius_m stands beside outline_m, expected one of them: the radius of a puck with "
                "corners is that of its farthest corner");
  if (table.has("radius_m")) table.number("radius_m", kPositive);
  bool known = true;
  const std::vector<PlacedPoint> points = table.boardPoints("outline_m");
  for (const PlacedPoint& point : points) {
    known = known && !std::isnan(point.at[0]) && !std::isnan(point.at[1]);
    puck.outline_m.push_back({point.at[0], point.at[1]});
  }
  if (known) {
    if (const auto wrong = faultOf(puck.outline_m)) {
      const FilePlace place =
          wrong->corner < points.size() ? points[wrong->corner].place : table.place("outline_m");
      table.fault(place, fmt::format("outline_m of puck '{}': {}", puck.name, wrong->what));
      known = false;
    }
  }
  if (!known) puck.outline_m = kPlaceholder_m;
  puck.radius_m = radiusOf_m(puck.outline_m);
  puck.inertia = momentsOf(puck.outline_m).inertia;
}

std::vector<Finding> oddOutline(const TomlTable& table, const Puck& puck) {
  constexpr double kBeside = 0.01;  // of the radius
  if (puck.outline_m.empty()) return {};
  const glm::dvec2 centre_m = momentsOf(puck.outline_m).centre;
  if (glm::length(centre_m) <= kBeside * puck.radius_m) return {};
  return {
      {.at = table.place("outline_m"),
       .text = fmt::format("the centre of mass of an even plate with the outline of puck '{}' is at ({:.6g}, "
                           "{:.6g}) m, expected the corners to be given from there",
                           puck.name, centre_m.x, centre_m.y)}};
}

}  // namespace carom
