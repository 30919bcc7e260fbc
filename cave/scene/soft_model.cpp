#include "cave/scene/soft_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "cave/scene/shadow_model.h"

namespace carom {
namespace {

/// Makes the lists of a model.
class Builder {
 public:
  Builder(const SoftMesh& mesh, bool isDisc, double height_m) : mesh_(mesh) {
    model_.height_m = height_m;
    model_.relaxed_m.assign(mesh.places().begin(), mesh.places().end());
    halfHeight_ = static_cast<float>(0.5 * height_m);
    // paint_soft.glsl: radius of a disc, or 0; half the distance of its lines; 0 on the faces, 1 on the side.
    paint_ = {isDisc ? static_cast<float>(mesh.reach_m()) : 0.0F, static_cast<float>(0.2 * shortest()), 0.0F};
  }

  SoftModel build() {
    const auto nodes = static_cast<std::uint32_t>(mesh_.places().size());
    for (const float z : {halfHeight_, -halfHeight_})
      for (std::uint32_t node = 0; node < nodes; ++node) model_.points.push_back({node, z});
    addFaces(nodes);
    addSide(nodes);
    addShadows();
    return std::move(model_);
  }

 private:
  /// The half extent across, which five lines divide.
  double shortest() const {
    glm::dvec2 most{0.0};
    for (const glm::dvec2& place : mesh_.places()) most = glm::max(most, glm::abs(place));
    return std::min(most.x, most.y);
  }

  std::uint32_t add(const SoftModel::Vertex& vertex, const glm::vec3& painted) {
    const SoftModel::Point& at = model_.points[vertex.point];
    const glm::dvec2 relaxed = mesh_.places()[at.node];
    model_.vertices.push_back(vertex);
    model_.painted.push_back({{relaxed, at.z_m}, glm::vec3(0.0F), painted, {255, 255, 255, 255}});
    return static_cast<std::uint32_t>(model_.vertices.size() - 1);
  }

  void addFaces(std::uint32_t nodes) {
    for (std::uint32_t point = 0; point < 2 * nodes; ++point)
      add({.point = point, .faces = static_cast<std::int8_t>(point < nodes ? 1 : -1)}, paint_);
    for (const SoftMesh::Triangle& triangle : mesh_.triangles()) {
      const auto [a, b, c] = std::array{static_cast<std::uint32_t>(triangle.nodes[0]),
                                        static_cast<std::uint32_t>(triangle.nodes[1]),
                                        static_cast<std::uint32_t>(triangle.nodes[2])};
      model_.surface.insert(model_.surface.end(), {a, b, c, nodes + a, nodes + c, nodes + b});
    }
  }

  SoftModel::Vertex outwards(std::uint32_t point, std::size_t k) const {
    const auto hull = mesh_.hull();
    return {.point = point,
            .before = static_cast<std::uint32_t>(hull[(k + hull.size() - 1) % hull.size()]),
            .after = static_cast<std::uint32_t>(hull[(k + 1) % hull.size()])};
  }

  void addSide(std::uint32_t nodes) {
    const auto hull = mesh_.hull();
    const auto first = static_cast<std::uint32_t>(model_.vertices.size());
    const auto count = static_cast<std::uint32_t>(hull.size());
    const glm::vec3 painted(paint_.x, paint_.y, 1.0F);
    for (std::uint32_t k = 0; k < count; ++k) {
      const auto node = static_cast<std::uint32_t>(hull[k]);
      add(outwards(node, k), painted);
      add(outwards(nodes + node, k), painted);
    }
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t here = first + 2 * k, next = first + 2 * ((k + 1) % count);
      model_.surface.insert(model_.surface.end(), {here, here + 1, next, next, here + 1, next + 1});
    }
  }

  /// Adds the shadow of each light, as cave/scene/shadow_model.h has those of rigid discs: soft across the
  /// rim, then dark as far as the middle.
  void addShadows() {
    const auto hull = mesh_.hull();
    const auto z = static_cast<float>(kShadowAboveCloth_m - 0.5 * model_.height_m);
    const auto firstPoint = static_cast<std::uint32_t>(model_.points.size());
    for (const int node : hull) model_.points.push_back({static_cast<std::uint32_t>(node), z});
    const auto middle = static_cast<std::uint32_t>(model_.points.size());
    model_.points.push_back({nearestToMiddle(), z});
    for (int light = 0; light < kShadowLights; ++light) {
      const bool isHall = light == kShadowOfHall;
      const double in_m = isHall ? 0.0 : shadowSoftOf_m(model_.height_m);
      const double out_m = isHall ? hallShadowReachOf_m(model_.height_m) : in_m;
      const auto firstVertex = static_cast<std::uint32_t>(model_.vertices.size());
      for (std::size_t k = 0; k < hull.size(); ++k) {
        const double radius_m = glm::length(mesh_.places()[static_cast<std::size_t>(hull[k])]);
        SoftModel::Vertex vertex = outwards(firstPoint + static_cast<std::uint32_t>(k), k);
        vertex.middle = middle;
        for (const double reach : {1.0 + out_m / radius_m, std::max(0.0, 1.0 - in_m / radius_m), 0.0}) {
          vertex.reach = static_cast<float>(reach);
          add(vertex,
              {reach > 1.0 ? 1.0F : 0.0F, static_cast<float>(light), static_cast<float>(model_.height_m)});
        }
      }
      addRings(firstVertex, static_cast<std::uint32_t>(hull.size()));
    }
  }

  /// Two rings of squares between vertices that come three and three, from the outermost to the innermost.
  void addRings(std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t k = 0; k < count; ++k) {
      for (std::uint32_t ring = 0; ring < 2; ++ring) {
        const std::uint32_t here = first + 3 * k + ring, next = first + 3 * ((k + 1) % count) + ring;
        model_.shadow.insert(model_.shadow.end(), {here, next, here + 1, here + 1, next, next + 1});
      }
    }
  }

  std::uint32_t nearestToMiddle() const {
    const auto places = mesh_.places();
    const auto nearest = std::min_element(places.begin(), places.end(), [](const auto& a, const auto& b) {
      return glm::dot(a, a) < glm::dot(b, b);
    });
    return static_cast<std::uint32_t>(nearest - places.begin());
  }

  const SoftMesh& mesh_;
  SoftModel model_;
  float halfHeight_ = 0.0F;
  glm::vec3 paint_{0.0F};
};

}  // namespace

double SoftModel::reach_m() const {
  double reach2 = 0.0;
  for (const glm::dvec2& place : relaxed_m) reach2 = std::max(reach2, glm::dot(place, place));
  return std::sqrt(reach2 + 0.25 * height_m * height_m);
}

SoftModel softModel(const SoftMesh& mesh, bool isDisc, double height_m, std::size_t body,
                    const glm::vec3& colour) {
  SoftModel model = Builder(mesh, isDisc, height_m).build();
  model.body = body;
  model.colour = colour;
  return model;
}

SoftModel toldModel(std::shared_ptr<const ToldShape> shape, const glm::vec3& colour) {
  constexpr float kPoint_m = 0.006F;  // half a point's diagonal
  constexpr std::array<glm::vec3, 6> kCorners{glm::vec3(1, 0, 0),  glm::vec3(0, 1, 0), glm::vec3(-1, 0, 0),
                                              glm::vec3(0, -1, 0), glm::vec3(0, 0, 1), glm::vec3(0, 0, -1)};
  SoftModel model;
  const auto count = static_cast<std::uint32_t>(shape->history.vertexCount());
  const bool isMesh = !shape->triangles.empty();
  for (std::uint32_t point = 0; point < count; ++point) {
    model.points.push_back({point, 0.0F});
    const auto first = static_cast<std::uint32_t>(model.vertices.size());
    for (std::size_t k = 0; k < (isMesh ? 1 : kCorners.size()); ++k) {
      model.vertices.push_back({.point = point});
      const glm::vec3 beside = isMesh ? glm::vec3(0.0F) : kPoint_m * kCorners[k];
      model.painted.push_back({beside, glm::vec3(0.0F), glm::vec3(0.0F), {255, 255, 255, 255}});
    }
    for (std::uint32_t k = 0; k < 4 && !isMesh; ++k) {
      const std::uint32_t here = first + k, next = first + (k + 1) % 4;
      model.surface.insert(model.surface.end(), {here, next, first + 4, next, here, first + 5});
    }
  }
  for (const auto& [a, b, c] : shape->triangles) model.surface.insert(model.surface.end(), {a, b, c});
  model.colour = colour;
  model.told = std::move(shape);
  return model;
}

}  // namespace carom
