#include "cave/spectator/solid_drawer.h"

#include <cstddef>
#include <vector>

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtk_glew.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "cave/gl/gl_program.h"
#include "shaders/solid_frag.h"
#include "shaders/solid_vert.h"

namespace carom {
namespace {

std::vector<SolidVertex> verticesOf(vtkPolyData& mesh) {
  std::vector<SolidVertex> vertices;
  vtkDataArray* normals = mesh.GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < mesh.GetNumberOfPoints(); ++i) {
    glm::dvec3 place_m(0.0), normal(0.0, 0.0, 1.0);
    mesh.GetPoint(i, glm::value_ptr(place_m));
    if (normals) normals->GetTuple(i, glm::value_ptr(normal));
    vertices.push_back({glm::vec3(place_m), glm::vec3(normal)});
  }
  return vertices;
}

/// Returns three corners per triangle; larger polygons become fans.
std::vector<unsigned> trianglesOf(vtkPolyData& mesh) {
  std::vector<unsigned> corners;
  const auto cells = vtk::TakeSmartPointer(mesh.GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);
    for (vtkIdType i = 2; i < count; ++i) {
      for (const vtkIdType id : {ids[0], ids[i - 1], ids[i]}) corners.push_back(static_cast<unsigned>(id));
    }
  }
  return corners;
}

}  // namespace

SolidDrawer::SolidDrawer() : program_(makeProgram("solid", shaders::solid_vert, shaders::solid_frag)) {}

Solid SolidDrawer::upload(vtkPolyData& mesh, const glm::vec3& colour) const {
  return upload(verticesOf(mesh), trianglesOf(mesh), colour);
}

Solid SolidDrawer::upload(std::span<const SolidVertex> vertices, std::span<const unsigned> triangles,
                          const glm::vec3& colour) const {
  Solid solid{
      {program_,
       {{"place_m", 3, offsetof(SolidVertex, place_m)}, {"normal", 3, offsetof(SolidVertex, normal)}}},
      {},
      static_cast<int>(triangles.size()),
      colour};
  solid.vertices.upload(vertices);
  solid.vertices.bind();
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, solid.triangles);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.size_bytes()), triangles.data(),
               GL_STATIC_DRAW);
  glBindVertexArray(0);
  return solid;
}

void SolidDrawer::begin(const OutsideView& view, const glm::dvec3& up, const glm::dvec3& right) const {
  glUseProgram(program_);
  setUniform(program_, "clipFromRoom", view.clipFromRoom);
  setUniform(program_, "camera_m", view.camera_m);
  setUniform(program_, "up", up);
  setUniform(program_, "toLamp", glm::normalize(glm::normalize(view.camera_m) + up - 0.5 * right));
}

void SolidDrawer::draw(const Solid& solid, const glm::dmat4& roomFromModel, float opacity) const {
  setUniform(program_, "roomFromModel", roomFromModel);
  setUniform(program_, "normalsToRoom", glm::inverseTranspose(glm::dmat3(roomFromModel)));
  setUniform(program_, "material", glm::vec4(solid.colour, opacity));
  solid.vertices.bind();
  glDrawElements(GL_TRIANGLES, solid.corners, GL_UNSIGNED_INT, nullptr);
}

}  // namespace carom
