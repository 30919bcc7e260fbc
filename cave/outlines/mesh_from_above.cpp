#include "cave/outlines/mesh_from_above.h"

#include <array>

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>

#include "cave/mesh/mesh_file.h"

namespace carom {

std::vector<glm::dvec2> trianglesFromAbove(const std::string& path) {
  const vtkSmartPointer<vtkPolyData> mesh = readMeshFile(path);
  std::vector<glm::dvec2> corners;
  const auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);
    for (vtkIdType i = 0; i < count; ++i) {
      std::array<double, 3> place{};
      mesh->GetPoint(ids[i], place.data());
      corners.emplace_back(place[0], place[1]);
    }
  }
  return corners;
}

}  // namespace carom
