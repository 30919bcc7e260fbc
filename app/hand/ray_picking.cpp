#include "app/hand/ray_picking.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {
namespace {

/// The position of a ray relative to a ball.
struct Passing {
  double along_m = 0.0;     ///< from the hand to where the ray is nearest to its centre; below 0: behind
  double missedBy_m = 0.0;  ///< from there to its surface; below 0: hit
};

Passing passing(const HandRay& ray, const Vec3& centre_m, double radius_m) {
  const Vec3 way_m = centre_m - ray.from_m;
  const double along_m = glm::dot(way_m, ray.along);
  return {along_m, glm::length(way_m - along_m * ray.along) - radius_m};
}

/// Returns a rank, smaller is better: hits come first, by distance, then near misses, by angle. Nothing if
/// the ball is not picked.
std::optional<double> rankOf(const Passing& by) {
  if (!(by.along_m > 0.0)) return std::nullopt;
  if (by.missedBy_m <= 0.0) return -1.0 / by.along_m;
  const double missedBy_rad = std::atan2(by.missedBy_m, by.along_m);
  return missedBy_rad <= RayPicking::kNear_rad ? std::optional(missedBy_rad) : std::nullopt;
}

/// Returns the distance along the ray from the hand to the plane z = 0 of the board, as it is in the room.
double toCloth_m(const HandRay& ray, const EyeView& head, const Lorentz& boardFromRoom) {
  const auto height_m = [&](const Vec3& inRoom_m) {
    return (boardFromRoom * Displacement{0.0, inRoom_m}).dr_m.z;
  };
  const double above_m = head.observation.r_m.z + height_m(ray.from_m - head.seenFromInRoom_m);
  const double sinks = -height_m(ray.along);
  return above_m > 0.0 && sinks > 0.0 ? above_m / sinks : std::numeric_limits<double>::infinity();
}

}  // namespace

Vec3 RayPicking::seenInRoom_m(const WorldLine& body, const Sight& sight) {
  const EyeView& eye = sight.observer.of(sight.eye);
  const Lorentz& headFromBoard = sight.observer.headFromBoard;
  viewBody(body, eye.observation, headFromBoard, view_, sight.switches);
  const Vec3 seen_m = seenFromEye(view_, emissionIn(view_, Vec3(0.0)));
  const Lorentz drawnFromSeen = ViewFrame(headFromBoard, sight.switches).drawnFromSeen;
  return eye.seenFromInRoom_m + kernel::rayThrough(drawnFromSeen.matrix(), seen_m);
}

PickResult RayPicking::at(const HandRay& ray, std::span<const WorldLine> pucks, const Sight& sight,
                          const Lorentz& boardFromRoom) {
  PickResult pointed;
  double best = std::numeric_limits<double>::infinity();
  double length_m = std::min(toCloth_m(ray, sight.observer.middle, boardFromRoom), kLongest_m);
  for (std::size_t puck = 0; puck < pucks.size(); ++puck) {
    const Passing by = passing(ray, seenInRoom_m(pucks[puck], sight), pucks[puck].radius_m());
    pointed.behind = pointed.behind || rankOf({-by.along_m, by.missedBy_m});
    const std::optional<double> rank = rankOf(by);
    if (!rank || !(*rank < best)) continue;
    best = *rank;
    pointed.puck = puck;
    length_m = by.along_m;
  }
  pointed.behind = pointed.behind && !pointed.puck;
  pointed.end_m = ray.from_m + length_m * ray.along;
  return pointed;
}

}  // namespace carom
