#include "cave/outlines/mesh_from_above.h"

#include <array>
#include <span>

#include "cave/mesh_input/mesh_file.h"
#include "cave/mesh_input/polygons.h"

namespace carom {

std::vector<glm::dvec2> trianglesFromAbove(const std::string& path) {
  const vtkSmartPointer<vtkPolyData> mesh = readMeshFile(path);
  std::vector<glm::dvec2> corners;
  forEachPolygon(*mesh->GetPolys(), [&](std::span<const vtkIdType> ids) {
    for (const vtkIdType id : ids) {
      std::array<double, 3> place{};
      mesh->GetPoint(id, place.data());
      corners.emplace_back(place[0], place[1]);
    }
  });
  return corners;
}

}  // namespace carom
