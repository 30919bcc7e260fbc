#include "cave/bodies/soft_drawer.h"

#include <algorithm>
#include <cstdint>

#include <vtk_glew.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>

namespace carom {
namespace {

void attribute(GLuint at, int size, GLenum type, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(at);
  glVertexAttribPointer(at, size, type, type == GL_FLOAT ? GL_FALSE : GL_TRUE, static_cast<GLsizei>(stride),
                        reinterpret_cast<const void*>(offset));
}

}  // namespace

SoftDrawer::SoftDrawer(const Scene& scene) : models_(scene.soft), has_(scene.bodyCount, 0) {
  std::vector<MeshVertex> painted;
  std::vector<std::uint32_t> indices;
  for (const SoftModel& model : models_) {
    Place place{painted.size(), indices.size() * sizeof(std::uint32_t), 0};
    painted.insert(painted.end(), model.painted.begin(), model.painted.end());
    indices.insert(indices.end(), model.surface.begin(), model.surface.end());
    place.shadow = indices.size() * sizeof(std::uint32_t);
    indices.insert(indices.end(), model.shadow.begin(), model.shadow.end());
    places_.push_back(place);
  }
  glBindBuffer(GL_ARRAY_BUFFER, painted_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(painted.size() * sizeof(MeshVertex)), painted.data(),
               GL_STATIC_DRAW);
  for (Layer& layer : layers_) {
    layer.vertices.resize(painted.size());
    layer.bounds.resize(models_.size());
    describe(layer);
  }
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
               indices.data(), GL_STATIC_DRAW);
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

/// Makes the inputs of shaders (kVertexInputs of body_program.h) those of a layer, and leaves its array
/// bound.
void SoftDrawer::describe(const Layer& layer) const {
  glBindVertexArray(layer.array);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  glBindBuffer(GL_ARRAY_BUFFER, painted_);
  attribute(0, 3, GL_FLOAT, sizeof(MeshVertex), offsetof(MeshVertex, place_m));
  attribute(2, 3, GL_FLOAT, sizeof(MeshVertex), offsetof(MeshVertex, surface));
  attribute(3, 4, GL_UNSIGNED_BYTE, sizeof(MeshVertex), offsetof(MeshVertex, lit));
  glBindBuffer(GL_ARRAY_BUFFER, layer.buffer);
  attribute(1, 3, GL_FLOAT, sizeof(SeenVertex), offsetof(SeenVertex, normal));
  attribute(4, 4, GL_FLOAT, sizeof(SeenVertex), offsetof(SeenVertex, drawn));
  attribute(5, 4, GL_FLOAT, sizeof(SeenVertex), offsetof(SeenVertex, u));
}

void SoftDrawer::look(const Lorentz& headFromBoard, const EyeView& eye, const Switches& switches,
                      const SoftLook& soft) {
  told_ = soft.told;
  for (const SoftModel& model : models_)
    if (!model.told)
      has_[model.body] = model.body < soft.bodies.size() && soft.bodies[model.body].rows.rowCount() > 0;
  for (Layer& layer : layers_) {
    for (SeenBound& bound : layer.bounds) bound.radius = -1.0;
  }
  see(ViewTime::seen, eye.observation, headFromBoard, switches, soft.bodies);
  if (soft.boardNow) see(ViewTime::boardNow, *soft.boardNow, headFromBoard, switches, soft.bodies);
  if (soft.myNow) see(ViewTime::myNow, *soft.myNow, headFromBoard, switches, soft.bodies);
}

void SoftDrawer::see(ViewTime moment, const Event& observation, const Lorentz& headFromBoard,
                     const Switches& switches, std::span<const SoftPast> bodies) {
  Layer& layer = layers_[static_cast<std::size_t>(moment)];
  const SeenHow how{observation, headFromBoard, switches, moment};
  for (std::size_t k = 0; k < models_.size(); ++k) {
    const SoftModel& model = models_[k];
    if (!model.told && !has(model.body)) continue;
    const auto to = std::span(layer.vertices).subspan(places_[k].firstVertex, model.vertices.size());
    layer.bounds[k] =
        model.told ? seenRows_.see(model, how, to) : seenRows_.see(model, bodies[model.body], how, told_, to);
  }
}

void SoftDrawer::upload() {
  for (const ViewTime moment : kViewTimes) {
    const Layer& layer = layerOf(moment);
    const auto isDrawn = [](const SeenBound& bound) { return bound.radius >= 0.0; };
    if (std::none_of(layer.bounds.begin(), layer.bounds.end(), isDrawn)) continue;
    glBindBuffer(GL_ARRAY_BUFFER, layer.buffer);
    const auto bytes = [](std::size_t vertices) {
      return static_cast<GLsizeiptr>(vertices * sizeof(SeenVertex));
    };
    glBufferData(GL_ARRAY_BUFFER, bytes(layer.vertices.size()), nullptr, GL_STREAM_DRAW);
    for (std::size_t k = 0; k < models_.size(); ++k) {
      const std::size_t first = places_[k].firstVertex;
      if (isDrawn(layer.bounds[k]))
        glBufferSubData(GL_ARRAY_BUFFER, bytes(first), bytes(models_[k].vertices.size()),
                        layer.vertices.data() + first);
    }
    glBindBuffer(GL_ARRAY_BUFFER, 0);
  }
}

/// The four planes through the eye that bound the wall: clip w ± x ≥ 0 and w ± y ≥ 0. They are linear in the
/// drawn place, so a sphere is outside of one if it is there by its radius times the length of the plane's
/// normal.
bool SoftDrawer::mayShow(ViewTime moment, std::size_t model, const glm::dmat4& clipFromDrawn,
                         double beyond_m) const {
  const SeenBound& bound = layerOf(moment).bounds[model];
  if (bound.radius < 0.0) return false;
  const glm::dvec4 w = glm::row(clipFromDrawn, 3);
  for (const int axis : {0, 1}) {
    for (const double side : {-1.0, 1.0}) {
      const glm::dvec4 plane = w + side * glm::row(clipFromDrawn, axis);
      const double distance = glm::dot(plane, glm::dvec4(bound.middle, 1.0));
      if (distance < -(bound.radius + beyond_m) * glm::length(glm::dvec3(plane))) return false;
    }
  }
  return true;
}

void SoftDrawer::drawTriangles(std::size_t number, bool isShadow) const {
  const SoftModel& of = models_[number];
  const Place& place = places_[number];
  const std::size_t count = isShadow ? of.shadow.size() : of.surface.size();
  const std::size_t from = isShadow ? place.shadow : place.surface;
  glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                           reinterpret_cast<void*>(from), static_cast<GLint>(place.firstVertex));
}

}  // namespace carom
