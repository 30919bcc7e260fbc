#pragma once
// Meshes from formulas: patches of a surface, divided into cells fine enough to bend where light makes
// straight edges look curved.

#include <array>
#include <functional>
#include <limits>
#include <vector>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace carom {

/// A point of a patch: its place (metres) and the data that the paint needs there.
struct PatchPoint {
  glm::dvec3 place{0.0};
  glm::dvec3 surface{0.0};
  glm::dvec3 normal{0.0};  ///< unit vector; 0: use the patch's own normal
};

class MeshBuilder {
 public:
  /// Adds the patch at(u, v), u and v in [0, 1], in cellsU × cellsV cells. Its outer side faces ∂u × ∂v.
  void addPatch(int cellsU, int cellsV, const std::function<PatchPoint(double u, double v)>& at);

  /// Adds a flat parallelogram from `corner` along `alongU` and `alongV`, in cells no larger than `cell_m`
  /// that part into tiles (cave/mesh/surface_tiles.h), as those of addTurned.
  void addFlat(const glm::dvec3& corner, const glm::dvec3& alongU, const glm::dvec3& alongV, double cell_m);

  /// Adds a surface of revolution about the vertical through `foot`, from each `profile[i]` = (radius, height
  /// above the foot) to the next. Each step has its own rings of facets; the outer side is to the right of
  /// the profile's direction. It has at least `sectors` cells around, none larger than `cell_m`.
  void addTurned(const glm::dvec3& foot, const std::vector<glm::dvec2>& profile, int sectors, double cell_m);

  std::size_t pointCount() const { return points_.size(); }

  /// Returns points, normals, triangles and the point array "surface", in single precision. The field array
  /// "patches" has three whole numbers for each patch: its first point, cellsU and cellsV.
  vtkSmartPointer<vtkPolyData> build() const;

 private:
  struct Point {
    PatchPoint patch;
    glm::dvec3 normal{0.0};  // unit vector
  };
  std::vector<Point> points_;
  std::vector<std::array<int, 3>> patches_;
  std::vector<std::array<std::size_t, 3>> triangles_;
};

/// Cell size of models that are divided as little as possible.
inline constexpr double kAnyCell_m = std::numeric_limits<double>::infinity();

/// Returns how many cells of at most `cell_m` a length needs.
int cellsFor(double length_m, double cell_m);
/// Returns the least such number that parts into tiles (cave/mesh/surface_tiles.h).
int tiledCells(double length_m, double cell_m);

}  // namespace carom
