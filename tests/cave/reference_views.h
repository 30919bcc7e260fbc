#pragma once
// From the engine's words to the reference's (reference/ray_reference.h), and pictures in which every body
// has a colour of its own.

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "cave/frame/bodies.h"
#include "cave/pictures/image.h"
#include "cave/render/wall_renderer.h"
#include "cave/room/wall.h"
#include "cave/scene/scene.h"
#include "engine/light/light_cone.h"
#include "reference/ray_reference.h"

namespace carom::test {

inline std::vector<reference::Leg> referenceLegs(const WorldLine& line) {
  const double c = line.lightSpeed_m_s();
  std::vector<reference::Leg> legs;
  for (const Knot& knot : line.knots()) {
    legs.push_back({{c * knot.turn.t_s, knot.turn.r_m},
                    knot.u / std::sqrt(1.0 + glm::dot(knot.u, knot.u)),
                    {c * knot.signal.t_s, knot.signal.r_m},
                    knot.deceleration_m_s2 / (c * c),
                    knot.spin.angle_rad,
                    knot.spin.omega_rad_s / c,
                    knot.spin.rim_u,
                    knot.spin.slowing_1_s / c});
  }
  return legs;
}

/// Without the legs that the eye cannot know of yet.
inline std::vector<reference::Leg> knownTo(const reference::Eye& eye, std::vector<reference::Leg> legs) {
  while (legs.size() > 1 && legs.back().signal.t >= eye.event.t) legs.pop_back();
  return legs;
}

inline reference::Mesh referenceMesh(vtkPolyData& data) {
  reference::Mesh mesh;
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) {
    const double* p = data.GetPoint(i);
    mesh.points.push_back({p[0], p[1], p[2]});
  }
  for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i) {
    vtkCell* cell = data.GetCell(i);
    for (int k = 2; k < static_cast<int>(cell->GetNumberOfPoints()); ++k) {
      mesh.triangles.push_back({static_cast<std::size_t>(cell->GetPointId(0)),
                                static_cast<std::size_t>(cell->GetPointId(k - 1)),
                                static_cast<std::size_t>(cell->GetPointId(k))});
    }
  }
  return mesh;
}

/// A mesh to draw; without normals that mean anything.
inline vtkSmartPointer<vtkPolyData> polyData(const reference::Mesh& mesh) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals, surface;
  normals->SetName("Normals");
  surface->SetName("surface");
  normals->SetNumberOfComponents(3);
  surface->SetNumberOfComponents(3);
  for (const Vec3& p : mesh.points) {
    points->InsertNextPoint(p.x, p.y, p.z);
    normals->InsertNextTuple3(0.0, 0.0, 1.0);
    surface->InsertNextTuple3(0.0, 0.0, 0.0);
  }
  vtkNew<vtkCellArray> cells;
  for (const auto& triangle : mesh.triangles) {
    cells->InsertNextCell({static_cast<vtkIdType>(triangle[0]), static_cast<vtkIdType>(triangle[1]),
                           static_cast<vtkIdType>(triangle[2])});
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetPointData()->SetNormals(normals);
  data->GetPointData()->AddArray(surface);
  return data;
}

/// A square wall in front of the eye, its middle towards `direction`.
inline Wall squareWall(const glm::dvec3& eye_m, const glm::dvec3& direction, double distance_m, double size_m,
                       int pixels) {
  const glm::dvec3 forward = glm::normalize(direction);
  const glm::dvec3 aside = std::abs(forward.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, aside)) * size_m;
  const glm::dvec3 up = glm::cross(right, forward);
  Wall wall;
  wall.lowerLeft_m = eye_m + forward * distance_m - 0.5 * (right + up);
  wall.lowerRight_m = wall.lowerLeft_m + right;
  wall.upperLeft_m = wall.lowerLeft_m + up;
  wall.pixels = glm::ivec2(pixels);
  return wall;
}

inline reference::Screen screenOf(const Wall& wall, const glm::dvec3& eyeInRoom_m) {
  return {wall.lowerLeft_m - eyeInRoom_m, wall.lowerRight_m - wall.lowerLeft_m,
          wall.upperLeft_m - wall.lowerLeft_m, static_cast<double>(wall.pixels.x),
          static_cast<double>(wall.pixels.y)};
}

/// What one of a scene's bodies is painted with: number 1 to 7, in the bits of red, green and blue.
inline glm::vec3 numberColour(int number) {
  return {number & 1 ? 1.0F : 0.0F, number & 2 ? 1.0F : 0.0F, number & 4 ? 1.0F : 0.0F};
}

inline int numberAt(const Image& image, int x, int y) {
  const std::uint8_t* rgb =
      &image.rgb[3 * (static_cast<std::size_t>(y) * image.size_px.x + static_cast<std::size_t>(x))];
  return (rgb[0] > 127 ? 1 : 0) + (rgb[1] > 127 ? 2 : 0) + (rgb[2] > 127 ? 4 : 0);
}

/// The parts of `scene` that belong to one body and are no decal, shining with a number.
inline void addNumbered(Scene& to, const Scene& scene, std::size_t body, int number) {
  for (ScenePart part : scene.parts) {
    if (part.body != body || part.paint == Paint::shadow) continue;
    part.paint = Paint::lamp;
    part.colour = numberColour(number);
    part.roughness = 0.0F;
    to.parts.push_back(part);
  }
}

/// One eye at a board event, moving with `beta`, its head frame by a rotation-free boost.
struct Look {
  Event observation;
  Vec3 beta{0.0};
  Vec3 inRoom_m{0.2, -0.1, 1.6};

  reference::Eye eye(double c_m_s) const { return {{c_m_s * observation.t_s, observation.r_m}, beta}; }
  Lorentz headFromBoard(double c_m_s) const { return Lorentz::boost(uFromBeta(-beta), c_m_s); }
};

/// The wall as it is really drawn. `lines` are those of the scene's bodies after the resting one.
inline Image drawn(Graphics& graphics, WallRenderer& renderer, std::span<const WorldLine> lines,
                   const Look& look, const Wall& wall) {
  const double c_m_s = lines.front().lightSpeed_m_s();
  std::vector<BodyView> views(1 + lines.size());
  viewBody(restingWorldLine(c_m_s), look.observation, look.headFromBoard(c_m_s), views[0]);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    viewBody(lines[i], look.observation, look.headFromBoard(c_m_s), views[i + 1]);
  }
  graphics.makeCurrent();
  RenderTarget picture(wall.pixels);
  renderer.look(look.headFromBoard(c_m_s), {look.observation, look.inRoom_m}, views);
  renderer.draw(wall, look.inRoom_m, picture);
  return readBack(picture);
}

}  // namespace carom::test
