#pragma once
// Small scenes whose light is baked, and the bytes of that light.

#include <string>

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <glm/vec3.hpp>

#include "cave/mesh/mesh_builder.h"
#include "cave/scene/scene_builder.h"

namespace carom::test {

/// A floor with a wide slab above it, and lamps above that, but the last one below it.
inline Scene slabOver(double height_m) {
  MeshBuilder floor, slab;
  floor.addFlat({-1.0, -1.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, 0.5);
  slab.addFlat({-100.0, -100.0, height_m}, {200.0, 0.0, 0.0}, {0.0, 200.0, 0.0}, 100.0);
  Scene scene;
  scene.parts = {{kRestingBody, floor.build(), Paint::floor}};
  scene.casters = {{kRestingBody, slab.build(), Paint::plain}};
  scene.lamps_m = {glm::dvec3(0.0, 0.0, 2.0 * height_m), glm::dvec3(0.0, 0.0, -1.0),
                   glm::dvec3(0.0, 0.0, 0.5 * height_m)};
  return scene;
}

/// A floor in the shadow of a square plate that hides a part of the hall and of each lamp from it.
inline Scene plateOver(double height_m) {
  Scene scene = slabOver(height_m);
  MeshBuilder floor, plate;
  floor.addFlat({-1.0, -1.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, 0.03);
  plate.addFlat({-0.5, -0.4, height_m}, {1.0, 0.0, 0.0}, {0.0, 0.8, 0.0}, 1.0);
  scene.parts = {{kRestingBody, floor.build(), Paint::floor}};
  scene.casters = {{kRestingBody, plate.build(), Paint::plain}};
  scene.lamps_m = {glm::dvec3(0.0, 0.0, 1.9), glm::dvec3(0.4, 0.1, 1.7), glm::dvec3(-0.7, 0.3, 2.1)};
  return scene;
}

inline std::string bytesOf(vtkPolyData& mesh) {
  vtkDataArray* const lit = mesh.GetPointData()->GetArray("lit");
  if (!lit) return "the mesh is not lit";
  return {static_cast<const char*>(lit->GetVoidPointer(0)),
          static_cast<std::size_t>(lit->GetNumberOfValues())};
}

}  // namespace carom::test
