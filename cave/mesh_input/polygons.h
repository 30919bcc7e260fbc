#pragma once
// The polygons of a mesh of VTK.

#include <span>

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace carom {

/// Calls `polygon` for each of these polygons with its corners: numbers of points.
template <typename Polygon>
void forEachPolygon(vtkCellArray& polygons, const Polygon& polygon) {
  const auto cells = vtk::TakeSmartPointer(polygons.NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCurrentCell(count, corners);
    polygon(std::span(corners, static_cast<std::size_t>(count)));
  }
}

/// Returns the mesh of these points whose polygons have their `corners` one after the other; polygon i has
/// those from ends[i] to ends[i + 1].
inline vtkSmartPointer<vtkPolyData> surfaceOf(vtkPoints* points, vtkIdTypeArray* ends,
                                              vtkIdTypeArray* corners) {
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(ends, corners);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polygons);
  return mesh;
}

}  // namespace carom
