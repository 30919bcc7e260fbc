#include "cave/mesh/mesh_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <glm/geometric.hpp>

#include "cave/mesh/surface_tiles.h"

namespace carom {
namespace {

/// Returns ∂u × ∂v by central differences, away from the patch's border, where it may degenerate (a disc's
/// middle).
glm::dvec3 normalAt(const std::function<PatchPoint(double, double)>& at, double u, double v) {
  constexpr double kStep = 1e-4;
  u = std::clamp(u, 2 * kStep, 1 - 2 * kStep);
  v = std::clamp(v, 2 * kStep, 1 - 2 * kStep);
  const glm::dvec3 du = at(u + kStep, v).place - at(u - kStep, v).place;
  const glm::dvec3 dv = at(u, v + kStep).place - at(u, v - kStep).place;
  return glm::normalize(glm::cross(du, dv));
}

vtkSmartPointer<vtkFloatArray> makeArray(const char* name, std::size_t count) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  return array;
}

void setTuple(vtkFloatArray& array, std::size_t i, const glm::dvec3& value) {
  array.SetTuple3(static_cast<vtkIdType>(i), value.x, value.y, value.z);
}

}  // namespace

int cellsFor(double length_m, double cell_m) {
  constexpr double kMost = 1000.0;  // cells per side: a board of kilometres must not take all memory
  return std::max(1, static_cast<int>(std::ceil(std::min(length_m / cell_m - 1e-9, kMost))));
}

int tiledCells(double length_m, double cell_m) { return tiledCells(cellsFor(length_m, cell_m)); }

void MeshBuilder::addPatch(int cellsU, int cellsV, const std::function<PatchPoint(double, double)>& at) {
  const std::size_t first = points_.size();
  patches_.push_back({static_cast<int>(first), cellsU, cellsV});
  for (int j = 0; j <= cellsV; ++j) {
    for (int i = 0; i <= cellsU; ++i) {
      const double u = static_cast<double>(i) / cellsU;
      const double v = static_cast<double>(j) / cellsV;
      const PatchPoint point = at(u, v);
      points_.push_back({point, point.normal == glm::dvec3(0.0) ? normalAt(at, u, v) : point.normal});
    }
  }
  const std::size_t row = static_cast<std::size_t>(cellsU) + 1;
  const auto length_m = [&](std::size_t p, std::size_t q) {
    return glm::distance(points_[p].patch.place, points_[q].patch.place);
  };
  for (std::size_t j = 0; j < static_cast<std::size_t>(cellsV); ++j) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(cellsU); ++i) {
      const std::size_t a = first + j * row + i;
      const std::size_t b = a + 1, c = b + row, d = a + row;
      const bool alongAc = length_m(a, c) <= length_m(b, d);  // along the shorter diagonal
      triangles_.push_back({a, b, alongAc ? c : d});
      triangles_.push_back({alongAc ? a : b, c, d});
    }
  }
}

void MeshBuilder::addFlat(const glm::dvec3& corner, const glm::dvec3& alongU, const glm::dvec3& alongV,
                          double cell_m) {
  addPatch(tiledCells(glm::length(alongU), cell_m), tiledCells(glm::length(alongV), cell_m),
           [&](double u, double v) { return PatchPoint{corner + u * alongU + v * alongV}; });
}

void MeshBuilder::addTurned(const glm::dvec3& foot, const std::vector<glm::dvec2>& profile, int sectors,
                            double cell_m) {
  double widest_m = 0.0;
  for (const glm::dvec2& p : profile) widest_m = std::max(widest_m, p.x);
  const int around = tiledCells(std::max(sectors, cellsFor(2.0 * std::numbers::pi * widest_m, cell_m)));
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const int along = tiledCells(glm::distance(profile[i], profile[i + 1]), cell_m);
    addPatch(around, along, [&](double u, double v) {
      const double angle_rad = 2.0 * std::numbers::pi * u;
      const glm::dvec2 p = profile[i] + v * (profile[i + 1] - profile[i]);
      return PatchPoint{foot + glm::dvec3(p.x * std::cos(angle_rad), p.x * std::sin(angle_rad), p.y)};
    });
  }
}

vtkSmartPointer<vtkPolyData> MeshBuilder::build() const {
  const auto places = makeArray("places", points_.size());
  const auto normals = makeArray("Normals", points_.size());
  const auto surfaces = makeArray("surface", points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    setTuple(*places, i, points_[i].patch.place);
    setTuple(*normals, i, points_[i].normal);
    setTuple(*surfaces, i, points_[i].patch.surface);
  }
  vtkNew<vtkPoints> points;
  points->SetData(places);
  vtkNew<vtkCellArray> cells;
  for (const auto& triangle : triangles_) {
    cells->InsertNextCell({static_cast<vtkIdType>(triangle[0]), static_cast<vtkIdType>(triangle[1]),
                           static_cast<vtkIdType>(triangle[2])});
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  mesh->GetPointData()->SetNormals(normals);
  mesh->GetPointData()->AddArray(surfaces);
  vtkNew<vtkIntArray> patches;
  patches->SetName("patches");
  patches->SetNumberOfComponents(3);
  for (const auto& patch : patches_) patches->InsertNextTypedTuple(patch.data());
  mesh->GetFieldData()->AddArray(patches);
  return mesh;
}

}  // namespace carom
