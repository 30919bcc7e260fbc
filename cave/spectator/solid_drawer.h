#pragma once
// Draws meshes of one colour in soft light of their own, not in the game's light.

#include <span>

#include <vtkPolyData.h>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "cave/gl/gl_objects.h"
#include "cave/spectator/outside_view.h"

namespace carom {

struct SolidVertex {
  glm::vec3 place_m{0.0F}, normal{0.0F};
};

/// A mesh on the graphics card.
struct Solid {
  VertexStream<SolidVertex> vertices;
  GlBuffer triangles;
  int corners = 0;
  glm::vec3 colour{1.0F};  ///< linear light, the share reflected
};

class SolidDrawer {
 public:
  /// Created and destroyed with the drawing context current.
  SolidDrawer();

  Solid upload(vtkPolyData& mesh, const glm::vec3& colour) const;
  /// Does the same for vertices, which may be uploaded anew, and the corners of triangles.
  Solid upload(std::span<const SolidVertex> vertices, std::span<const unsigned> triangles,
               const glm::vec3& colour) const;

  /// Begins drawing, within a GlStateGuard. `up`, `right`: the room's axes, which set the direction of the
  /// light.
  void begin(const OutsideView& view, const glm::dvec3& up, const glm::dvec3& right) const;
  /// Draws a solid with this opacity, if blending is on.
  void draw(const Solid& solid, const glm::dmat4& roomFromModel, float opacity = 1.0F) const;

 private:
  GlProgram program_;
};

}  // namespace carom
