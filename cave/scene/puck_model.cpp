#include "cave/scene/puck_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTransform.h>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "cave/mesh/mesh_builder.h"
#include "cave/mesh/smooth_surface.h"
#include "cave/mesh_input/mesh_library.h"
#include "cave/scene/shadow_model.h"

namespace carom {
namespace {

constexpr int kSectors = 72;
constexpr float kLacquer = 0.14F, kPaint = 0.18F;  // roughness

/// How finely a puck is divided: the finest mesh as its roundness and slow light need, coarser ones ever
/// less.
struct Fineness {
  double cell_m = 0.0;
  int halvings = 0;  ///< how often its sectors, rings and the steps of its round edges were halved

  int halved(int count, int least) const { return std::max(least, count >> halvings); }
};

/// Returns the number of sectors around a puck of this radius. The rim lies outside its chords by
/// r (1 − cos(π/n)) = π² r/2n²: 29 µm with 72 sectors for a carom ball's radius, and hardly more up to three
/// times that radius; even larger pucks leave vertices for finer cells.
int sectorsOf(double radius_m, const Fineness& fineness) {
  constexpr double kFarthestOut_m = 30e-6;
  constexpr int kMostForRoundness = 128, kFewest = 12;
  const int round =
      static_cast<int>(std::ceil(std::numbers::pi * std::sqrt(0.5 * radius_m / kFarthestOut_m)));
  return std::max(fineness.halved(std::max(kSectors, std::min(round, kMostForRoundness)), kFewest),
                  cellsFor(2.0 * std::numbers::pi * radius_m, fineness.cell_m));
}

/// Adds a ring of the puck, from (radius, z) to (radius, z); its outer side is to the right of that
/// direction.
void addRing(MeshBuilder& mesh, const glm::dvec2& from, const glm::dvec2& to, const glm::dvec3& surface,
             const Fineness& fineness) {
  mesh.addPatch(sectorsOf(surface.x, fineness), cellsFor(glm::distance(from, to), fineness.cell_m),
                [&](double u, double v) {
                  const double angle_rad = 2.0 * std::numbers::pi * u;
                  const glm::dvec2 p = from + v * (to - from);
                  return PatchPoint{{p.x * std::cos(angle_rad), p.x * std::sin(angle_rad), p.y}, surface};
                });
}

/// Adds a ring with a slope of 45° that is shaded as if it were round: its normals turn by a right angle,
/// starting at `from_rad` above outwards.
void addRoundRing(MeshBuilder& mesh, const glm::dvec2& from, const glm::dvec2& to, double from_rad,
                  const glm::dvec3& surface, const Fineness& fineness) {
  constexpr int kSteps = 4;
  mesh.addPatch(sectorsOf(surface.x, fineness),
                std::max(fineness.halved(kSteps, 1), cellsFor(glm::distance(from, to), fineness.cell_m)),
                [&](double u, double v) {
                  const double angle_rad = 2.0 * std::numbers::pi * u;
                  const double rise_rad = from_rad + 0.5 * std::numbers::pi * v;
                  const glm::dvec2 p = from + v * (to - from), n(std::cos(rise_rad), std::sin(rise_rad));
                  const glm::dvec2 out(std::cos(angle_rad), std::sin(angle_rad));
                  return PatchPoint{{p.x * out, p.y}, surface, {n.x * out, n.y}};
                });
}

/// Returns the transform that moves the middle of the mesh's box to the origin and scales it to the radius,
/// or does to x and y as `place` says.
vtkSmartPointer<vtkTransform> fitTo(vtkPolyData& mesh, double radius_m,
                                    const std::optional<MeshPlace>& place) {
  std::array<double, 6> box{};
  mesh.GetBounds(box.data());
  const glm::dvec3 middle(0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]), 0.5 * (box[4] + box[5]));
  auto transform = vtkSmartPointer<vtkTransform>::New();
  if (place) {
    transform->Scale(glm::value_ptr(glm::dvec3(place->scale)));
    transform->Translate(-place->centre.x, -place->centre.y, -middle.z);
    return transform;
  }
  double widest = 0.0;
  for (vtkIdType i = 0; i < mesh.GetNumberOfPoints(); ++i) {
    std::array<double, 3> p{};
    mesh.GetPoint(i, p.data());
    widest = std::max(widest, std::hypot(p[0] - middle.x, p[1] - middle.y));
  }
  if (radius_m > 0.0 && widest > 0.0) transform->Scale(glm::value_ptr(glm::dvec3(radius_m / widest)));
  transform->Translate(-middle.x, -middle.y, -middle.z);
  return transform;
}

/// Divides triangles until no edge is longer than asked. Each pass halves every edge that is too long, so
/// that the triangles on both sides of an edge agree and no crack opens. Stops before a pass that would make
/// more vertices than asked.
vtkSmartPointer<vtkPolyData> dividedTo(const Tessellation& tessellation, vtkSmartPointer<vtkPolyData> mesh) {
  constexpr int kMostPasses = 24;
  const auto most = static_cast<vtkIdType>(tessellation.mostVertices);
  for (int pass = 0; pass < kMostPasses && mesh->GetNumberOfPoints() <= most; ++pass) {
    const auto halved = meshLibrary().longEdgesHalved(*mesh, tessellation.edge_m());
    const vtkIdType points = halved->GetNumberOfPoints();
    if (points == mesh->GetNumberOfPoints() || points > most) break;
    mesh = halved;
  }
  return mesh;
}

constexpr int kCoarserPucks = 3;
/// Light, which is computed at vertices, needs cells of this size.
constexpr double kLitCell_m = 0.05;

/// Returns a puck. A coarser one has few vertices on its lower side, which is seen of ghosts at most.
vtkSmartPointer<vtkPolyData> puckMesh(double radius_m, double height_m, const Fineness& fineness) {
  const double r = radius_m;
  const double z = 0.5 * height_m;
  const double bevel = std::min(0.08 * r, 0.3 * z);
  const glm::dvec3 onFace(r, 0.0, z);
  const glm::dvec3 onRim(r, 1.0, z);
  MeshBuilder mesh;
  const auto ring = [&](const glm::dvec2& from, const glm::dvec2& to, const glm::dvec3& surface) {
    addRing(mesh, from, to, surface, fineness);
  };
  const bool finest = fineness.halvings == 0;
  addRoundRing(mesh, {r - bevel, -z}, {r, -z + bevel}, -0.5 * std::numbers::pi, onRim, fineness);
  if (finest) ring({r, -z + bevel}, {r, 0.0}, onRim);
  ring({r, finest ? 0.0 : -z + bevel}, {r, z - bevel}, onRim);
  addRoundRing(mesh, {r, z - bevel}, {r - bevel, z}, 0.0, onFace, fineness);
  const int rings = fineness.halved(4, 2);
  for (int i = 0; i < rings; ++i) {
    const double outer = (r - bevel) * (rings - i) / rings, inner = (r - bevel) * (rings - i - 1) / rings;
    ring({outer, z}, {inner, z}, onFace);
    if (finest) ring({inner, -z}, {outer, -z}, onFace);
  }
  if (finest) return mesh.build();
  mesh.addPatch(sectorsOf(r, fineness), 2, [&](double u, double v) {
    const double angle_rad = 2.0 * std::numbers::pi * u, from_m = v * (r - bevel);
    return PatchPoint{{from_m * std::cos(angle_rad), from_m * std::sin(angle_rad), -z}, onFace};
  });
  return mesh.build();
}

}  // namespace

std::vector<ScenePart> puckParts(double radius_m, double height_m, std::size_t body, const glm::vec3& colour,
                                 double cell_m) {
  ScenePart puck{body, puckMesh(radius_m, height_m, {cell_m}), Paint::puck, colour, kLacquer};
  for (int halvings = 1; halvings <= kCoarserPucks; ++halvings) {
    // Light bends them less than roundness shows: their cells may be larger than their sectors are wide.
    const Fineness fineness{std::min(cell_m * (1 << (2 * halvings)), kLitCell_m), halvings};
    const double turn_rad = std::numbers::pi / sectorsOf(radius_m, fineness);
    puck.coarser.push_back(
        {puckMesh(radius_m, height_m, fineness), 0.0, radius_m * (1.0 - std::cos(turn_rad))});
  }
  return {discShadow(radius_m, height_m, body, cell_m), std::move(puck)};
}

ScenePart rodPart(std::size_t body, const glm::vec3& colour, double cell_m) {
  constexpr double kLength_m = 1.0;
  constexpr double kRadius_m = 0.025;
  MeshBuilder mesh;
  const auto around = [&](double angle_rad, double radius_m, double x) {
    return PatchPoint{{x, radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad)}, {x, 0.0, 0.0}};
  };
  const double turn = 2.0 * std::numbers::pi;
  const int sectors = std::max(20, cellsFor(turn * kRadius_m, cell_m));
  const int across = cellsFor(kRadius_m, cell_m);
  mesh.addPatch(sectors, cellsFor(kLength_m, std::min(0.025, cell_m)),
                [&](double u, double v) { return around(turn * u, kRadius_m, (v - 0.5) * kLength_m); });
  mesh.addPatch(sectors, across,
                [&](double u, double v) { return around(turn * u, (1.0 - v) * kRadius_m, 0.5 * kLength_m); });
  mesh.addPatch(sectors, across,
                [&](double u, double v) { return around(turn * u, v * kRadius_m, -0.5 * kLength_m); });
  return {body, mesh.build(), Paint::bands, colour, kPaint};
}

ScenePart meshPart(const vtkSmartPointer<vtkPolyData>& read, double radius_m, std::size_t body,
                   const glm::vec3& colour, const Tessellation& tessellation,
                   const std::optional<MeshPlace>& place) {
  const auto fitted = meshLibrary().transformed(*read, *fitTo(*read, radius_m, place));
  return surfacePart(fitted, body, colour, tessellation);
}

ScenePart surfacePart(const vtkSmartPointer<vtkPolyData>& whole, std::size_t body, const glm::vec3& colour,
                      const Tessellation& tessellation) {
  const bool hasOnlyTriangles = whole->GetPolys()->IsHomogeneous() == 3;
  const auto merged = withPointsMerged(hasOnlyTriangles ? *whole : *meshLibrary().cutToTriangles(*whole));
  const vtkSmartPointer<vtkPolyData> mesh = withNormals(*dividedTo(tessellation, merged));

  vtkNew<vtkFloatArray> surface;
  surface->SetName("surface");
  surface->SetNumberOfComponents(3);
  surface->SetNumberOfTuples(mesh->GetNumberOfPoints());
  surface->Fill(0.0);
  mesh->GetPointData()->AddArray(surface);
  return {body, mesh, Paint::plain, colour, kPaint};
}

void paintSectors(ScenePart& part, int sectors, double radius_m) {
  vtkDataArray& surface = *part.mesh->GetPointData()->GetArray("surface");
  surface.FillComponent(0, sectors);
  surface.FillComponent(1, radius_m);
  part.paint = Paint::sectors;
}

void paintMaterial(ScenePart& part, Material material) {
  constexpr float kPolishedMetal = 0.1F, kPlanedWood = 0.3F;
  if (material == Material::metal) {
    part.paint = Paint::metal;
    part.roughness = kPolishedMetal;
  } else if (material == Material::wood) {
    part.paint = Paint::wood;
    part.roughness = kPlanedWood;
    vtkPolyData& mesh = *part.mesh;
    vtkDataArray& surface = *mesh.GetPointData()->GetArray("surface");
    for (vtkIdType i = 0; i < mesh.GetNumberOfPoints(); ++i) {
      surface.SetComponent(i, 0, mesh.GetPoint(i)[0]);
      surface.SetComponent(i, 1, mesh.GetPoint(i)[1]);
    }
  }
}

}  // namespace carom
