#include "cave/scene/person_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkTransform.h>
#include <glm/common.hpp>

#include "cave/mesh/mesh_builder.h"
#include "cave/mesh_input/mesh_library.h"

namespace carom {
namespace {

constexpr float kRoughness = 0.35F;
constexpr glm::vec3 kGlasses(0.02F), kWood(0.60F, 0.28F, 0.08F), kHair(0.055F, 0.028F, 0.014F);

/// Returns shoulders without arms below a head, wider than deep; as headParts. More of a person would have to
/// be guessed.
vtkSmartPointer<vtkPolyData> shoulders() {
  constexpr std::array<glm::dvec2, 8> kProfile{{{0.0, -0.62},
                                                {0.17, -0.62},
                                                {0.185, -0.50},
                                                {0.23, -0.33},
                                                {0.225, -0.27},
                                                {0.17, -0.215},
                                                {0.07, -0.185},
                                                {0.062, -0.09}}};  // radius, height
  constexpr double kDeep = 0.68;
  constexpr int kAround = 32, kUp = 28;
  MeshBuilder mesh;
  mesh.addPatch(kAround, kUp, [&](double u, double v) {
    const double place = v * (kProfile.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(place), kProfile.size() - 2);
    const glm::dvec2 at = glm::mix(kProfile[i], kProfile[i + 1], place - static_cast<double>(i));
    const double angle_rad = 2.0 * std::numbers::pi * u;
    return PatchPoint{{at.x * std::cos(angle_rad), kDeep * at.x * std::sin(angle_rad) - kBehindEyes_m, at.y}};
  });
  return mesh.build();
}

/// Returns a stick along x that the hand holds behind its middle.
vtkSmartPointer<vtkPolyData> stick() {
  constexpr int kAround = 12, kAlong = 24;
  constexpr double kBehind_m = 0.45, kLength_m = 1.2, kThick_m = 0.016, kThin_m = 0.008;
  MeshBuilder mesh;
  mesh.addPatch(kAround, kAlong, [&](double u, double v) {
    const double angle_rad = 2.0 * std::numbers::pi * u, radius_m = glm::mix(kThick_m, kThin_m, v);
    return PatchPoint{
        {v * kLength_m - kBehind_m, -radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad)}};
  });
  return mesh.build();
}

/// Returns a mesh turned so that it looks along x instead of y.
vtkSmartPointer<vtkPolyData> alongX(vtkPolyData& mesh) {
  vtkNew<vtkTransform> turn;
  turn->RotateZ(-90.0);
  return meshLibrary().transformed(mesh, *turn);
}

/// Returns how far a mesh reaches from its origin, with room for rounding to floats.
double reachOf(vtkPolyData& mesh) {
  double reach_m = 0.0;
  for (vtkIdType i = 0; i < mesh.GetNumberOfPoints(); ++i)
    reach_m = std::max(reach_m, vtkMath::Norm(mesh.GetPoint(i)));
  return reach_m * (1.0 + 1e-6);
}

}  // namespace

void addEllipsoid(MeshBuilder& mesh, const glm::dvec3& middle_m, const glm::dvec3& radii_m) {
  constexpr int kAround = 32, kUp = 20;
  mesh.addPatch(kAround, kUp, [&](double u, double v) {
    const double east = 2.0 * M_PI * u, north = M_PI * (v - 0.5);
    return PatchPoint{middle_m + radii_m * glm::dvec3(std::cos(east) * std::cos(north),
                                                      std::sin(east) * std::cos(north), std::sin(north))};
  });
}

void addLimb(MeshBuilder& mesh, const glm::dvec3& from_m, const glm::dvec3& to_m, double fromRadius_m,
             double toRadius_m) {
  constexpr int kAround = 24, kAlong = 6;
  const glm::dvec3 along = glm::normalize(to_m - from_m);
  const glm::dvec3 across = glm::normalize(glm::cross(along, glm::dvec3(0.0, 1.0, 0.1))),
                   beside = glm::cross(along, across);
  mesh.addPatch(kAround, kAlong, [&](double u, double v) {
    const double angle_rad = 2.0 * std::numbers::pi * u;
    return PatchPoint{glm::mix(from_m, to_m, v) +
                      glm::mix(fromRadius_m, toRadius_m, v) *
                          (std::cos(angle_rad) * across + std::sin(angle_rad) * beside)};
  });
}

std::vector<ModelPart> headParts() {
  MeshBuilder skull, glasses, hair;
  addEllipsoid(skull, {0.0, -kBehindEyes_m, 0.01}, {0.078, 0.10, 0.125});
  addEllipsoid(skull, {0.0, 0.015, -0.035}, {0.016, 0.035, 0.024});
  addEllipsoid(hair, {0.0, -kBehindEyes_m - 0.014, 0.037}, {0.083, 0.103, 0.112});
  for (const double side : {-1.0, 1.0}) {
    addEllipsoid(skull, {side * 0.078, -kBehindEyes_m - 0.005, -0.02}, {0.011, 0.022, 0.034});
    addEllipsoid(glasses, {side * 0.033, 0.004, 0.0}, {0.030, 0.014, 0.024});
    addEllipsoid(glasses, {side * 0.078, -0.045, 0.0}, {0.004, 0.055, 0.006});
  }
  return {{skull.build(), kSkin}, {glasses.build(), kGlasses}, {hair.build(), kHair}};
}

void addPeople(Scene& scene) {
  scene.firstPerson = scene.bodyCount;
  std::vector<ModelPart> head = headParts();
  for (ModelPart& part : head) part.mesh = alongX(*part.mesh);
  const auto coat = alongX(*shoulders()), cue = stick();
  MeshBuilder ball;
  addEllipsoid(ball, glm::dvec3(0.0), glm::dvec3(0.045));
  const auto hand = ball.build();
  scene.reach_m.resize(scene.bodyCount);
  const auto add = [&](const vtkSmartPointer<vtkPolyData>& mesh, const glm::vec3& colour) {
    scene.parts.push_back({scene.bodyCount, mesh, Paint::plain, colour, kRoughness});
    if (scene.reach_m.size() == scene.bodyCount) scene.reach_m.push_back(0.0);
    scene.reach_m.back() = std::max(scene.reach_m.back(), reachOf(*mesh));
  };
  for (const glm::vec3& colour : kCoatColours) {
    for (const ModelPart& part : head) add(part.mesh, part.colour);
    add(coat, colour);
    ++scene.bodyCount;
    add(hand, kSkin);
    ++scene.bodyCount;
    add(cue, kWood);
    ++scene.bodyCount;
  }
}

}  // namespace carom
