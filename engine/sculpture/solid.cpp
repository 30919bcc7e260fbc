#include "engine/sculpture/solid.h"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace carom {
namespace {

constexpr int kBallDivisions = 2;
constexpr std::uint32_t kRodSides = 8;

/// Returns a direction at a right angle to another.
Vec3 across(const Vec3& direction) {
  const Vec3 other = std::abs(direction.z) < 0.9 ? Vec3(0.0, 0.0, 1.0) : Vec3(1.0, 0.0, 0.0);
  return glm::normalize(glm::cross(direction, other));
}

/// Divides each triangle into four, with the new points on the unit sphere.
SolidMesh divided(const SolidMesh& coarse) {
  SolidMesh fine{coarse.points, {}};
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [found, isNew] =
        middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(fine.points.size()));
    if (isNew) fine.points.push_back(glm::normalize(fine.points[a] + fine.points[b]));
    return found->second;
  };
  for (const auto& [a, b, c] : coarse.triangles) {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.triangles.insert(fine.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return fine;
}

}  // namespace

double volume_m3(const SolidMesh& solid) {
  double sum = 0.0;
  for (const auto& [a, b, c] : solid.triangles)
    sum += glm::dot(solid.points[a], glm::cross(solid.points[b], solid.points[c]));
  return sum / 6.0;
}

SolidMesh ball(const Vec3& middle_m, double radius_m) {
  SolidMesh solid{{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}, {}};
  for (std::uint32_t side = 0; side < 4; ++side) {
    const std::uint32_t next = (side + 1) % 4;
    solid.triangles.push_back({side, next, 4});
    solid.triangles.push_back({next, side, 5});
  }
  for (int division = 0; division < kBallDivisions; ++division) solid = divided(solid);
  for (Vec3& point : solid.points) point = middle_m + point * radius_m;
  return solid;
}

SolidMesh box(const Vec3& low_m, const Vec3& high_m) {
  SolidMesh solid;
  for (int corner = 0; corner < 8; ++corner)
    solid.points.emplace_back((corner & 1 ? high_m : low_m).x, (corner & 2 ? high_m : low_m).y,
                              (corner & 4 ? high_m : low_m).z);
  solid.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                     {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return solid;
}

// The ring at a point is the last one, moved along the path onto the plane in which the two directions meet.
SolidMesh rod(std::span<const Vec3> path_m, double radius_m) {
  SolidMesh solid;
  Vec3 along = glm::normalize(path_m[1] - path_m[0]);
  const Vec3 first = across(along), second = glm::cross(along, first);
  for (std::uint32_t k = 0; k < kRodSides; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kRodSides;
    solid.points.push_back(path_m[0] + (first * std::cos(angle) + second * std::sin(angle)) * radius_m);
  }
  for (std::size_t i = 1; i < path_m.size(); ++i) {
    const Vec3 next = i + 1 < path_m.size() ? glm::normalize(path_m[i + 1] - path_m[i]) : along;
    const Vec3 sum = along + next, normal = glm::dot(sum, sum) > 1e-6 ? glm::normalize(sum) : along;
    const std::size_t below = solid.points.size() - kRodSides;
    for (std::uint32_t k = 0; k < kRodSides; ++k) {
      const Vec3 from = solid.points[below + k];
      solid.points.push_back(from + along * (glm::dot(path_m[i] - from, normal) / glm::dot(along, normal)));
    }
    along = next;
    for (std::uint32_t k = 0; k < kRodSides; ++k) {
      const auto a = static_cast<std::uint32_t>(below + k),
                 b = static_cast<std::uint32_t>(below + (k + 1) % kRodSides);
      solid.triangles.push_back({a, b, a + kRodSides});
      solid.triangles.push_back({b, b + kRodSides, a + kRodSides});
    }
  }
  const auto last = static_cast<std::uint32_t>(solid.points.size() - kRodSides);
  for (std::uint32_t k = 1; k + 1 < kRodSides; ++k) {
    solid.triangles.push_back({0, k + 1, k});
    solid.triangles.push_back({last, last + k, last + k + 1});
  }
  return solid;
}

}  // namespace carom
