#include "cave/puck_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include <vtkAdaptiveSubdivisionFilter.h>
#include <vtkCleanPolyData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataNormals.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTriangleFilter.h>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "cave/mesh_builder.h"

namespace carom {
namespace {

constexpr int kSectors = 72;
constexpr double kShadowHeight_m = 0.0005;  // above the cloth

/// Around a puck of this radius.
int sectorsOf(double radius_m, double cell_m) {
  return std::max(kSectors, cellsFor(2.0 * std::numbers::pi * radius_m, cell_m));
}

/// A ring of the puck, from (radius, z) to (radius, z); outer side to the right of the way.
void addRing(MeshBuilder& mesh, const glm::dvec2& from, const glm::dvec2& to, const glm::dvec3& surface,
             double cell_m) {
  mesh.addPatch(sectorsOf(surface.x, cell_m), cellsFor(glm::distance(from, to), cell_m),
                [&](double u, double v) {
                  const double angle_rad = 2.0 * std::numbers::pi * u;
                  const glm::dvec2 p = from + v * (to - from);
                  return PatchPoint{{p.x * std::cos(angle_rad), p.x * std::sin(angle_rad), p.y}, surface};
                });
}

ScenePart shadowPart(double radius_m, double height_m, std::size_t body, double cell_m) {
  MeshBuilder shadow;
  const double reach_m = radius_m + 0.9 * height_m;
  const double z = kShadowHeight_m - 0.5 * height_m;
  const auto addDisc = [&](double outer_m, double inner_m, double outerShade, double innerShade) {
    const int sectors = std::max(kSectors / 2, cellsFor(2.0 * std::numbers::pi * reach_m, cell_m));
    shadow.addPatch(sectors, std::max(2, cellsFor(outer_m - inner_m, cell_m)), [&](double u, double v) {
      const double angle_rad = 2.0 * std::numbers::pi * u;
      const double r = outer_m + v * (inner_m - outer_m);
      return PatchPoint{{r * std::cos(angle_rad), r * std::sin(angle_rad), z},
                        {outerShade + v * (innerShade - outerShade), 0.0, 0.0}};
    });
  };
  addDisc(reach_m, 0.95 * radius_m, 1.0, 0.0);
  addDisc(0.95 * radius_m, 0.0, 0.0, 0.0);
  return {body, shadow.build(), Paint::shadow, glm::vec3(0.0F), 0.0F};
}

/// Moves the box's middle to the origin and scales to the radius.
vtkSmartPointer<vtkTransform> fitTo(vtkPolyData& mesh, double radius_m) {
  std::array<double, 6> box{};
  mesh.GetBounds(box.data());
  const glm::dvec3 middle(0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]), 0.5 * (box[4] + box[5]));
  double widest = 0.0;
  for (vtkIdType i = 0; i < mesh.GetNumberOfPoints(); ++i) {
    std::array<double, 3> p{};
    mesh.GetPoint(i, p.data());
    widest = std::max(widest, std::hypot(p[0] - middle.x, p[1] - middle.y));
  }
  auto transform = vtkSmartPointer<vtkTransform>::New();
  if (radius_m > 0.0 && widest > 0.0) transform->Scale(glm::value_ptr(glm::dvec3(radius_m / widest)));
  transform->Translate(-middle.x, -middle.y, -middle.z);
  return transform;
}

/// Triangles whose edges are no longer than asked, halved in passes: in a pass every edge that is too long,
/// so that triangles on both sides of an edge agree and no crack opens. Stops before a pass that would make
/// more vertices than asked.
vtkSmartPointer<vtkPolyData> dividedTo(const Tessellation& tessellation, vtkSmartPointer<vtkPolyData> mesh) {
  constexpr int kMostPasses = 24;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    vtkNew<vtkAdaptiveSubdivisionFilter> halved;
    halved->SetInputData(mesh);
    halved->SetMaximumEdgeLength(tessellation.edge_m());
    halved->SetMaximumNumberOfPasses(1);
    halved->Update();
    const vtkIdType points = halved->GetOutput()->GetNumberOfPoints();
    if (points == mesh->GetNumberOfPoints() || points > static_cast<vtkIdType>(tessellation.mostVertices))
      break;
    mesh = halved->GetOutput();
  }
  return mesh;
}

}  // namespace

glm::vec3 colourOf(const std::string& name, std::size_t index) {
  static const std::map<std::string, glm::vec3> kNamed{
      {"white", {0.64F, 0.62F, 0.57F}},  {"yellow", {0.85F, 0.52F, 0.03F}}, {"red", {0.62F, 0.030F, 0.025F}},
      {"blue", {0.035F, 0.13F, 0.60F}},  {"green", {0.05F, 0.42F, 0.10F}},  {"orange", {0.80F, 0.22F, 0.02F}},
      {"violet", {0.30F, 0.06F, 0.50F}}, {"black", {0.035F, 0.035F, 0.04F}}};
  static const std::array<glm::vec3, 6> kPalette{{{0.05F, 0.45F, 0.55F},
                                                  {0.80F, 0.22F, 0.02F},
                                                  {0.30F, 0.06F, 0.50F},
                                                  {0.55F, 0.62F, 0.05F},
                                                  {0.75F, 0.12F, 0.32F},
                                                  {0.035F, 0.13F, 0.60F}}};
  const auto named = kNamed.find(name);
  return named != kNamed.end() ? named->second : kPalette[index % kPalette.size()];
}

std::vector<ScenePart> puckParts(double radius_m, double height_m, std::size_t body, const glm::vec3& colour,
                                 double cell_m) {
  const double r = radius_m;
  const double z = 0.5 * height_m;
  const double bevel = std::min(0.08 * r, 0.3 * z);
  const glm::dvec3 onFace(r, 0.0, z);
  const glm::dvec3 onRim(r, 1.0, z);
  MeshBuilder mesh;
  const auto ring = [&](const glm::dvec2& from, const glm::dvec2& to, const glm::dvec3& surface) {
    addRing(mesh, from, to, surface, cell_m);
  };
  ring({r - bevel, -z}, {r, -z + bevel}, onRim);
  ring({r, -z + bevel}, {r, 0.0}, onRim);
  ring({r, 0.0}, {r, z - bevel}, onRim);
  ring({r, z - bevel}, {r - bevel, z}, onFace);
  const std::array<double, 5> rings{1.0, 0.75, 0.5, 0.25, 0.0};
  for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
    ring({rings[i] * (r - bevel), z}, {rings[i + 1] * (r - bevel), z}, onFace);
    ring({rings[i + 1] * (r - bevel), -z}, {rings[i] * (r - bevel), -z}, onFace);
  }
  return {shadowPart(radius_m, height_m, body, cell_m), {body, mesh.build(), Paint::puck, colour, 0.5F}};
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
  return {body, mesh.build(), Paint::bands, colour, 0.3F};
}

ScenePart meshPart(const vtkSmartPointer<vtkPolyData>& read, double radius_m, std::size_t body,
                   const glm::vec3& colour, const Tessellation& tessellation) {
  vtkNew<vtkTransformPolyDataFilter> fitted;
  fitted->SetInputData(read);
  fitted->SetTransform(fitTo(*read, radius_m));
  vtkNew<vtkCleanPolyData> cleaned;
  cleaned->SetInputConnection(fitted->GetOutputPort());
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cleaned->GetOutputPort());
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(dividedTo(tessellation, triangles->GetOutput()));
  normals->SetFeatureAngle(40.0);
  normals->Update();

  const vtkSmartPointer<vtkPolyData> mesh = normals->GetOutput();
  vtkNew<vtkFloatArray> surface;
  surface->SetName("surface");
  surface->SetNumberOfComponents(3);
  surface->SetNumberOfTuples(mesh->GetNumberOfPoints());
  surface->Fill(0.0);
  mesh->GetPointData()->AddArray(surface);
  return {body, mesh, Paint::plain, colour, 0.3F};
}

}  // namespace carom
