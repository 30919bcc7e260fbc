#pragma once
// Pucks and boards of scenes, and the edges of their meshes.

#include <vtkIdList.h>
#include <vtkNew.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "cave/scene/scene_builder.h"

namespace carom::test {

inline const std::vector<BodyLooks> kPucks{
    {"white", "", 0.0305, 0.02}, {"yellow", "", 0.0305, 0.02}, {"red", "", 0.0305, 0.02}};

inline BilliardSetup boardOf(double length_m, double width_m) {
  BilliardSetup setup;
  setup.board = Board{length_m, width_m};
  return setup;
}

/// Every edge of these parts with how many triangles it has: ends as places, so that seams between patches
/// count as one edge.
inline std::map<std::array<float, 6>, int> edgesOf(std::span<const ScenePart> parts) {
  std::map<std::array<float, 6>, int> edges;
  for (const ScenePart& part : parts) {
    for (vtkIdType cell = 0; cell < part.mesh->GetNumberOfCells(); ++cell) {
      vtkNew<vtkIdList> ids;
      part.mesh->GetCellPoints(cell, ids);
      std::array<std::array<float, 3>, 3> corners{};
      for (int i = 0; i < 3; ++i) {
        std::array<double, 3> place{};
        part.mesh->GetPoint(ids->GetId(i), place.data());
        for (std::size_t k = 0; k < 3; ++k)
          corners[i][k] = static_cast<float>(std::round(place[k] * 1e6));  // µm
      }
      for (int i = 0; i < 3; ++i) {
        const auto& [a, b] = std::minmax(corners[i], corners[(i + 1) % 3]);
        if (a != b) ++edges[{a[0], a[1], a[2], b[0], b[1], b[2]}];
      }
    }
  }
  return edges;
}

inline double longestOf(const std::map<std::array<float, 6>, int>& edges) {
  double longest_m = 0.0;
  for (const auto& [ends, count] : edges) {
    longest_m =
        std::max(longest_m, 1e-6 * std::hypot(ends[0] - ends[3], ends[1] - ends[4], ends[2] - ends[5]));
  }
  return longest_m;
}

}  // namespace carom::test
