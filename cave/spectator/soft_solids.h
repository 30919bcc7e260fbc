#pragma once
// Soft pucks and told bodies that deform, in the room at one time of the room's own clock: every vertex where
// its rows have it then (cave/bodies/seen_rows.h), in the room's frame.

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "cave/bodies/seen_rows.h"
#include "cave/record/frame_state.h"
#include "cave/scene/scene.h"
#include "cave/spectator/solid_drawer.h"
#include "engine/spacetime/event.h"
#include "engine/spacetime/lorentz.h"

namespace carom {

class SoftSolids {
 public:
  /// Keeps the soft models of a scene. Created, used and destroyed with the drawing context current.
  SoftSolids(const Scene& scene, const SolidDrawer& drawer);

  /// Places the bodies for the time at which something at `placeInRoom_m` in the room is at this event of the
  /// board. `bodies` are those of every body of the scene, or none.
  void place(const Lorentz& boardFromRoom, const Event& event, const glm::dvec3& placeInRoom_m,
             std::span<const SoftPast> bodies);
  /// Draws those that have been placed, with this opacity.
  void draw(const SolidDrawer& drawer, float opacity) const;
  /// Whether a body is drawn here, and not as a rigid one.
  bool has(std::size_t body) const { return body < has_.size() && has_[body] != 0; }

 private:
  struct Body {
    SoftModel model;
    Solid solid;
    bool isPlaced = false;
  };
  std::vector<Body> bodies_;
  std::vector<char> has_;  // by body of the scene
  SeenRows rows_;
  std::vector<SeenVertex> seen_;
  std::vector<SolidVertex> vertices_;
  glm::dmat4 roomFromEye_{1.0};
};

}  // namespace carom
