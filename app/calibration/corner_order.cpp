#include "app/calibration/corner_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

namespace carom {
namespace {

constexpr std::size_t kMostCorners = 40;  // 59280 triples

/// Returns three touches that span a large triangle, by index.
std::array<std::size_t, 3> wideTriple(std::span<const PointPair> pairs) {
  const auto farthest = [&](const auto& measure) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < pairs.size(); ++i) {
      if (measure(pairs[i].inB_m) > measure(pairs[best].inB_m)) best = i;
    }
    return best;
  };
  const glm::dvec3 start_m = pairs[0].inB_m;
  const std::size_t first = farthest([&](const glm::dvec3& p) { return glm::distance(p, start_m); });
  const glm::dvec3 first_m = pairs[first].inB_m;
  const std::size_t second = farthest([&](const glm::dvec3& p) { return glm::distance(p, first_m); });
  const glm::dvec3 along_m = pairs[second].inB_m - first_m;
  const std::size_t third =
      farthest([&](const glm::dvec3& p) { return glm::length(glm::cross(p - first_m, along_m)); });
  return {first, second, third};
}

/// Gives each touch the nearest corner under a motion; empty if two touches get the same or one is too far.
std::vector<std::size_t> nearestCorners(std::span<const PointPair> pairs, const Pose& roomFromTracker,
                                        double most_m) {
  std::vector<std::size_t> corner;
  std::vector<bool> taken(pairs.size(), false);
  for (const PointPair& touch : pairs) {
    const glm::dvec3 at_m = roomFromTracker * touch.inB_m;
    const auto nearest = std::min_element(pairs.begin(), pairs.end(), [&](const auto& a, const auto& b) {
      return glm::distance(a.inA_m, at_m) < glm::distance(b.inA_m, at_m);
    });
    const auto index = static_cast<std::size_t>(nearest - pairs.begin());
    if (taken[index] || !(glm::distance(nearest->inA_m, at_m) <= most_m)) return {};
    taken[index] = true;
    corner.push_back(index);
  }
  return corner;
}

std::size_t movedIn(const std::vector<std::size_t>& corner) {
  std::size_t moved = 0;
  for (std::size_t i = 0; i < corner.size(); ++i) moved += corner[i] == i ? 0 : 1;
  return moved;
}

double largestMissOf(std::span<const PointPair> pairs, const std::vector<std::size_t>& corner) {
  std::vector<PointPair> reordered;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    reordered.push_back({pairs[corner[i]].inA_m, pairs[i].inB_m});
  }
  double largest_m = 0.0;
  for (const glm::dvec3& miss_m : fitRigid(reordered).misses_m) {
    largest_m = std::max(largest_m, glm::length(miss_m));
  }
  return largest_m;
}

}  // namespace

CornerOrder likeliestOrder(std::span<const PointPair> pairs, double most_m) {
  CornerOrder best;
  const std::size_t count = pairs.size();
  if (count < 3 || count > kMostCorners) return best;
  const std::array<std::size_t, 3> triple = wideTriple(pairs);
  const auto side_m = [&](std::size_t i, std::size_t j) {
    return glm::distance(pairs[triple[i]].inB_m, pairs[triple[j]].inB_m);
  };
  const auto sideFits = [&](std::size_t a, std::size_t b, double length_m) {
    return std::abs(glm::distance(pairs[a].inA_m, pairs[b].inA_m) - length_m) <= 2.0 * most_m;
  };
  // Three touches, taken for any three corners as far apart, give a motion; it gives all others a corner.
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = 0; b < count; ++b) {
      if (a == b || !sideFits(a, b, side_m(0, 1))) continue;
      for (std::size_t c = 0; c < count; ++c) {
        if (c == a || c == b || !sideFits(a, c, side_m(0, 2)) || !sideFits(b, c, side_m(1, 2))) continue;
        const std::array<PointPair, 3> guess{{{pairs[a].inA_m, pairs[triple[0]].inB_m},
                                              {pairs[b].inA_m, pairs[triple[1]].inB_m},
                                              {pairs[c].inA_m, pairs[triple[2]].inB_m}}};
        const auto corner = nearestCorners(pairs, fitRigid(guess).aFromB, 2.0 * most_m);
        if (corner.empty()) continue;
        const double largest_m = largestMissOf(pairs, corner);
        if (!(largest_m <= most_m)) continue;
        if (best.corner.empty() || movedIn(corner) < movedIn(best.corner)) best = {corner, largest_m};
      }
    }
  }
  return best;
}

}  // namespace carom
