#pragma once
// Whether a surface of triangles is closed and oriented.

#include <map>
#include <utility>

#include "engine/sculpture/solid.h"

namespace carom::test {

/// Returns how many edges are not there once in each direction: 0 for a closed surface, all of whose
/// triangles have the same side out.
inline int openEdges(const SolidMesh& solid) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& triangle : solid.triangles) {
    for (int k = 0; k < 3; ++k) ++edges[{triangle[k], triangle[(k + 1) % 3]}];
  }
  int open = 0;
  for (const auto& [edge, times] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    open += times != 1 || back == edges.end() || back->second != 1;
  }
  return open;
}

}  // namespace carom::test
