#include "cave/mesh/tessellation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

#include "engine/base/bisection.h"

namespace carom {
namespace {

constexpr double kPi = std::numbers::pi;

/// Returns the bend of the edge whose middle is `chi` from straight behind the head and half of whose angle
/// is `a`, as explained in the header.
double bendAt(double chi, double a, double expEta) {
  const double chiEnd = std::acos(std::cos(chi) * std::cos(a));
  const double omega = std::atan2(std::tan(a), std::sin(chi));
  const auto seen = [&](double angle) {
    return 2.0 * std::atan2(expEta * std::sin(0.5 * angle), std::cos(0.5 * angle));
  };
  const double seenEnd = seen(chiEnd);
  const double drawn = std::atan2(std::sin(seenEnd) * std::cos(omega), std::cos(seenEnd));
  return std::abs(seen(chi) - drawn);
}

/// Returns the x in [low, high] with f(x) = `value`, by bisection; f must increase.
template <typename F>
double whereReached(const F& f, double value, double low, double high) {
  constexpr int kSteps = 60;
  return bisect({low, high}, kSteps, [&](double x) { return !(f(x) > value); }).low;
}

/// Returns the smallest angle of a pixel in this corner: across the line of sight it is pitch/distance; along
/// the slant of the wall it is also shorter by the cosine of the angle of incidence, height/distance.
double pixelAt(const glm::dvec3& corner_m, double pitch_m, double height_m) {
  const double distance_m = glm::length(corner_m);
  return pitch_m * height_m / (distance_m * distance_m);
}

}  // namespace

double worstBend_rad(double edge_m, double beta, double nearest_m) {
  const double a = std::atan(0.5 * edge_m / nearest_m);
  const double expEta = std::exp(std::atanh(beta));
  // There is one peak over χ; as edges grow, it moves from where sin χ/D² is largest towards 0.
  constexpr int kDirections = 400;
  double worst = 0.0;
  int at = 1;
  for (int i = 1; i < kDirections; ++i) {
    const double bend = bendAt(kPi * i / kDirections, a, expEta);
    if (bend > worst) {
      worst = bend;
      at = i;
    }
  }
  double low = kPi * (at - 1) / kDirections, high = kPi * (at + 1) / kDirections;
  constexpr int kSteps = 40;  // to a thousandth of the first step, which suffices since the peak is flat
  for (int i = 0; i < kSteps; ++i) {
    const double left = low + (high - low) / 3.0, right = high - (high - low) / 3.0;
    if (bendAt(left, a, expEta) < bendAt(right, a, expEta)) {
      low = left;
    } else {
      high = right;
    }
  }
  return std::max(worst, bendAt(0.5 * (low + high), a, expEta));
}

double longestEdge_m(double tolerance_rad, double beta, double nearest_m) {
  return whereReached([&](double edge_m) { return worstBend_rad(edge_m, beta, nearest_m); }, tolerance_rad,
                      0.0, nearest_m);
}

double fastestHead_beta(double edge_m, double tolerance_rad) {
  return whereReached([&](double beta) { return worstBend_rad(edge_m, beta); }, tolerance_rad, 0.0,
                      kFastestHead_beta);
}

double finestPixel_rad(std::span<const Wall> walls, const glm::dvec3& eyeInRoom_m) {
  double finest = std::numeric_limits<double>::infinity();
  for (const Wall& wall : walls) {
    const glm::dvec3 along = wall.lowerRight_m - wall.lowerLeft_m, up = wall.upperLeft_m - wall.lowerLeft_m;
    const double pitch_m = std::min(glm::length(along) / wall.pixels.x, glm::length(up) / wall.pixels.y);
    const glm::dvec3 corner = wall.lowerLeft_m - eyeInRoom_m;
    const double height_m = glm::dot(glm::normalize(glm::cross(up, along)), corner);
    if (!(height_m > 0.0)) continue;
    for (const glm::dvec3& other : {glm::dvec3(0.0), along, up, along + up}) {
      finest = std::min(finest, pixelAt(corner + other, pitch_m, height_m));
    }
  }
  return std::isfinite(finest) ? finest : 0.001;
}

}  // namespace carom
