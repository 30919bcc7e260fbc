#include "cave/bodies/flat_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cave/mesh/tessellation.h"

namespace carom {
namespace {

/// Returns the largest sin χ/D² within the angle of sine `sine` and cosine `cosine` around `chi` from the
/// motion.
double mostBend(double speed_u, double cosChi, double sine, double cosine) {
  const double gamma = std::sqrt(1.0 + speed_u * speed_u);
  const double peak = (gamma - std::sqrt(gamma * gamma + 8.0 * speed_u * speed_u)) / (2.0 * speed_u);
  const double sinChi = std::sqrt(std::max(0.0, 1.0 - cosChi * cosChi));
  const double low = cosChi <= -cosine ? -1.0 : cosChi * cosine - sinChi * sine;  // cos(χ + α)
  const double high = cosChi >= cosine ? 1.0 : cosChi * cosine + sinChi * sine;   // cos(χ − α)
  const double worst = std::clamp(peak, low, high);
  const double doppler = gamma + speed_u * worst;
  return std::sqrt(std::max(0.0, 1.0 - worst * worst)) / (doppler * doppler);
}

/// Returns the cosine of the angle between `way` and `u` when that is made larger by the angle of this sine,
/// up to π.
double farthestCosine(const glm::dvec3& way, const glm::dvec3& u, double sine) {
  const double cosine = std::sqrt(1.0 - sine * sine);
  const double cosChi = glm::dot(way, u) / (glm::length(way) * glm::length(u));
  return cosChi <= -cosine ? -1.0 : cosChi * cosine - std::sqrt(std::max(0.0, 1.0 - cosChi * cosChi)) * sine;
}

}  // namespace

double longestFlat_m(const Extent& box, const glm::dvec3& eye_m, const glm::dvec3& u) {
  const double speed_u = glm::length(u);
  if (speed_u < 1e-9) return std::numeric_limits<double>::infinity();
  const glm::dvec3 middle_m = 0.5 * (box.low_m + box.high_m) - eye_m;
  const double radius_m = 0.5 * glm::distance(box.low_m, box.high_m), distance_m = glm::length(middle_m);
  const double nearest_m =
      std::max(kNearestToSurface_m, glm::distance(glm::clamp(eye_m, box.low_m, box.high_m), eye_m));
  const bool within = distance_m <= radius_m;
  const double sine = within ? 0.0 : radius_m / distance_m;
  const double bend = within ? mostBend(speed_u, 0.0, 1.0, 0.0)
                             : mostBend(speed_u, glm::dot(u, middle_m) / (speed_u * distance_m), sine,
                                        std::sqrt(1.0 - sine * sine));
  return nearest_m * std::sqrt(8.0 / (speed_u * bend));
}

double worstOff_rad(const SeenCaps& seen, double reach_m, double cell_m, double off_m) {
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  const auto view = seen.restView();
  if (!view) return kUnknown;
  const double distance_m = glm::length(view->eye_m), nearest_m = distance_m - reach_m;
  if (!(nearest_m > kNearestToSurface_m)) return kUnknown;
  const double speed_u = glm::length(view->u);
  if (speed_u < 1e-9) return off_m / nearest_m;
  const double leastDoppler = std::sqrt(1.0 + speed_u * speed_u) +
                              speed_u * farthestCosine(-view->eye_m, view->u, reach_m / distance_m);
  const double share =
      cell_m / longestFlat_m({glm::dvec3(-reach_m), glm::dvec3(reach_m)}, view->eye_m, view->u);
  return off_m / (nearest_m * leastDoppler) + share * share;
}

}  // namespace carom
