#include "cave/scene/outline_model.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <vector>

namespace carom {

vtkSmartPointer<vtkPolyData> prismOver(std::span<const glm::dvec2> corners_m, double height_m) {
  const auto count = static_cast<vtkIdType>(corners_m.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const double z : {-0.5 * height_m, 0.5 * height_m})
    for (const glm::dvec2& corner : corners_m) points->InsertNextPoint(corner.x, corner.y, z);
  std::vector<vtkIdType> top, bottom;
  for (vtkIdType k = 0; k < count; ++k) {
    top.push_back(count + k);
    bottom.push_back(count - 1 - k);
  }
  vtkNew<vtkCellArray> faces;
  faces->InsertNextCell(count, top.data());
  faces->InsertNextCell(count, bottom.data());
  for (vtkIdType k = 0; k < count; ++k) {
    const vtkIdType next = (k + 1) % count;
    const vtkIdType side[]{k, next, count + next, count + k};
    faces->InsertNextCell(4, side);
  }
  auto prism = vtkSmartPointer<vtkPolyData>::New();
  prism->SetPoints(points);
  prism->SetPolys(faces);
  return prism;
}

}  // namespace carom
