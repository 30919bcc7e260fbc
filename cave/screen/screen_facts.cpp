#include "cave/screen/screen_facts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <variant>

#include <glm/geometric.hpp>

namespace carom {
namespace {

/// Returns the triangles that reach over the middle line of the window along an axis.
ScreenMesh acrossMiddle(const ScreenMesh& mesh, int axis) {
  ScreenMesh across;
  std::copy_if(mesh.begin(), mesh.end(), std::back_inserter(across), [&](const ScreenTriangle& t) {
    const auto [low, high] =
        std::minmax({t[0].inWindow[1 - axis], t[1].inWindow[1 - axis], t[2].inWindow[1 - axis]});
    return low <= 0.5 && high >= 0.5;
  });
  return across;
}

/// Returns the length of the screen along an axis of the window, through its middle.
double lengthAlong_m(const ScreenMesh& whole, int axis) {
  constexpr int kSteps = 256;
  const ScreenMesh mesh = acrossMiddle(whole, axis);
  double length_m = 0.0;
  std::optional<glm::dvec3> before_m;
  for (int i = 0; i <= kSteps; ++i) {
    glm::dvec2 place(0.5);
    place[axis] = static_cast<double>(i) / kSteps;
    const std::optional<glm::dvec3> at_m = inRoom_m(mesh, place);
    if (at_m && before_m) length_m += glm::distance(*at_m, *before_m);
    before_m = at_m;
  }
  return length_m;
}

/// Returns the angle of a cylinder; of others the angle between the normal that is farthest from the first
/// one and the one farthest from that.
double turns_rad(const CurvedScreen& screen, const std::vector<glm::dvec3>& normals) {
  if (const auto* cylinder = std::get_if<CylinderScreen>(&screen.shape))
    return cylinder->to_rad - cylinder->from_rad;
  const auto farthestFrom = [&](const glm::dvec3& normal) {
    return *std::min_element(normals.begin(), normals.end(), [&](const glm::dvec3& a, const glm::dvec3& b) {
      return glm::dot(a, normal) < glm::dot(b, normal);
    });
  };
  const glm::dvec3 one = farthestFrom(normals.front());
  return std::acos(std::clamp(glm::dot(one, farthestFrom(one)), -1.0, 1.0));
}

/// Returns whether the middle of the screen's window is farther from the eyes than the screen's mean place.
bool meshBendsRound(const ScreenMesh& mesh, const glm::dvec3& eyes_m) {
  glm::dvec3 middle_m(0.0);
  const ScreenPoint* central = &mesh.front()[0];
  for (const ScreenTriangle& t : mesh) {
    for (const ScreenPoint& point : t) {
      middle_m += point.inRoom_m / (3.0 * static_cast<double>(mesh.size()));
      if (glm::distance(point.inWindow, glm::dvec2(0.5)) < glm::distance(central->inWindow, glm::dvec2(0.5)))
        central = &point;
    }
  }
  return bendsRound(central->inRoom_m - middle_m, eyes_m - middle_m, facingOf(mesh));
}

}  // namespace

glm::dvec3 facingOf(const ScreenMesh& mesh) {
  glm::dvec3 area(0.0);
  for (const ScreenTriangle& t : mesh) {
    const double side = windowArea(t) < 0.0 ? -1.0 : 1.0;
    area += side * glm::cross(t[1].inRoom_m - t[0].inRoom_m, t[2].inRoom_m - t[0].inRoom_m);
  }
  return area;
}

bool bendsRound(const glm::dvec3& central_m, const glm::dvec3& eyes_m, const glm::dvec3& facing) {
  constexpr double kBends_m = 0.005;
  const glm::dvec3 normal = glm::normalize(facing);
  return glm::dot(central_m, normal) * glm::dot(eyes_m, normal) < 0.0 &&
         std::abs(glm::dot(central_m, normal)) > kBends_m;
}

ScreenFacts factsOf(const CurvedScreen& screen, const glm::ivec2& window_px, const glm::dvec3& eyes_m) {
  ScreenFacts facts;
  facts.width_m = lengthAlong_m(screen.mesh, 0);
  facts.height_m = lengthAlong_m(screen.mesh, 1);
  facts.leastPerMetre = facts.nearest_m = std::numeric_limits<double>::infinity();
  double leastSquarely = 1.0, mostSquarely = -1.0;
  const double window_px2 = static_cast<double>(window_px.x) * window_px.y;
  double shown_px2 = 0.0, texels = 0.0;
  std::vector<glm::dvec3> normals;
  for (const ScreenTriangle& t : screen.mesh) {
    const double side = windowArea(t) < 0.0 ? -1.0 : 1.0;
    const glm::dvec3 area = side * glm::cross(t[1].inRoom_m - t[0].inRoom_m, t[2].inRoom_m - t[0].inRoom_m);
    const double area_m2 = 0.5 * glm::length(area), area_px2 = 0.5 * std::abs(windowArea(t)) * window_px2;
    if (!(area_m2 > 0.0)) continue;
    normals.push_back(glm::normalize(area));
    shown_px2 += area_px2;
    const double perMetre = std::sqrt(area_px2 / area_m2);
    facts.leastPerMetre = std::min(facts.leastPerMetre, perMetre);
    facts.mostPerMetre = std::max(facts.mostPerMetre, perMetre);
    const glm::dvec3 toEyes_m = eyes_m - (t[0].inRoom_m + t[1].inRoom_m + t[2].inRoom_m) / 3.0;
    const double squarely = glm::dot(normals.back(), glm::normalize(toEyes_m));
    leastSquarely = std::min(leastSquarely, squarely);
    mostSquarely = std::max(mostSquarely, squarely);
    facts.nearest_m = std::min(facts.nearest_m, glm::length(toEyes_m));
    facts.farthest_m = std::max(facts.farthest_m, glm::length(toEyes_m));
  }
  for (const FlatPiece& piece : screen.pieces)
    texels += static_cast<double>(piece.wall.pixels.x) * piece.wall.pixels.y;
  facts.isMirrored = mostSquarely <= 0.0 && meshBendsRound(screen.mesh, eyes_m);
  facts.isBehind = mostSquarely <= 0.0 && !facts.isMirrored;
  facts.mostIncidence_rad =
      std::acos(std::clamp(facts.isMirrored ? -mostSquarely : leastSquarely, -1.0, 1.0));
  facts.turns_rad = turns_rad(screen, normals);
  facts.covered = shown_px2 / window_px2;
  facts.texelsPerPixel = texels / shown_px2;
  return facts;
}

}  // namespace carom
