#pragma once
// How a body is drawn whose points move by themselves: a soft puck, as the mesh of its simulation extruded to
// its height, with rings and spokes or squares printed on it and its shadows on the cloth; or a told body
// that deforms.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/mesh/mesh_vertex.h"
#include "engine/light/sampled_history.h"
#include "engine/soft/soft_mesh.h"

namespace carom {

/// A told deforming body: its history, and the triangles of its mesh, by its vertices. Without triangles its
/// points are drawn.
struct ToldShape {
  SampledHistory history;
  std::vector<std::array<std::uint32_t, 3>> triangles{};
};

struct SoftModel {
  static constexpr std::size_t kNoBody = std::numeric_limits<std::size_t>::max();

  /// A point whose seen place is solved for: a node of the rows, at a height above the plane of centres.
  struct Point {
    std::uint32_t node = 0;
    float z_m = 0.0F;
  };
  /// A drawn vertex. It is at a point or, of a shadow, on the way from a point under the middle through one
  /// under the hull, by `reach` of the distance between them.
  struct Vertex {
    std::uint32_t point = 0;
    std::uint32_t middle = 0;
    float reach = 1.0F;
    std::int8_t faces = 0;                ///< 1: up, −1: down, 0: outwards
    std::uint32_t before = 0, after = 0;  ///< of one that faces outwards: the nodes beside it on the hull
  };

  /// Of a told body, whose points are its vertices; a drawn vertex is at its point or, in the frame in which
  /// walls draw, beside it by its painted place.
  std::shared_ptr<const ToldShape> told{};
  std::size_t body = kNoBody;         ///< of the scene; none of a told body
  glm::vec3 colour{1.0F};             ///< linear, the share reflected
  double height_m = 0.0;              ///< of the puck
  std::vector<glm::dvec2> relaxed_m;  ///< the places of the nodes in the relaxed body
  std::vector<Point> points;
  std::vector<Vertex> vertices;
  std::vector<MeshVertex>
      painted;  ///< the same as shaders take them: relaxed places, and what the paints want
  std::vector<std::uint32_t> surface, shadow;  ///< triangles

  double reach_m() const;  ///< of the farthest point from the relaxed centre
};

/// Returns the model of a soft puck with this mesh.
SoftModel softModel(const SoftMesh& mesh, bool isDisc, double height_m, std::size_t body,
                    const glm::vec3& colour);

/// Returns the model of a told body.
SoftModel toldModel(std::shared_ptr<const ToldShape> shape, const glm::vec3& colour);

}  // namespace carom
