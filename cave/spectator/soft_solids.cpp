#include "cave/spectator/soft_solids.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "cave/spectator/room_simultaneity.h"

namespace carom {

SoftSolids::SoftSolids(const Scene& scene, const SolidDrawer& drawer) {
  for (const SoftModel& model : scene.soft)
    bodies_.push_back({model, drawer.upload({}, model.surface, model.colour)});
}

void SoftSolids::place(const Lorentz& boardFromRoom, const Event& event, const glm::dvec3& placeInRoom_m,
                       std::span<const SoftPast> bodies) {
  roomFromEye_ = glm::translate(glm::dmat4(1.0), placeInRoom_m);
  has_.assign(bodies.size(), 0);
  const SeenHow how{event, boardFromRoom.inverse(), {}, ViewTime::myNow};
  for (Body& body : bodies_) {
    const SoftModel& model = body.model;
    const bool isTold = model.told != nullptr;
    body.isPlaced = isTold || (model.body < bodies.size() && bodies[model.body].rows.rowCount() > 0);
    if (!body.isPlaced) continue;
    seen_.resize(model.vertices.size());
    if (isTold) {
      rows_.see(model, how, seen_);
    } else {
      rows_.see(model, bodies[model.body], how, Told::nothing, seen_);
      has_[model.body] = 1;
    }
    vertices_.clear();
    for (const SeenVertex& seen : seen_) {
      // As places of the body are at d = Λ dr at one time of the room, its surfaces look along Λᵀ n there.
      const glm::dmat3 bodyFromRoom = bodyFromRoomNow(boardFromRoom, glm::dvec3(seen.u));
      const glm::dvec3 normal = glm::normalize(glm::dvec3(seen.normal) * bodyFromRoom);
      vertices_.push_back({seen.drawn, glm::vec3(normal)});
      body.isPlaced = body.isPlaced && seen.boardTime_m >= SeenRows::kUnseen_m;
    }
    if (body.isPlaced) body.solid.vertices.upload(vertices_);
  }
}

void SoftSolids::draw(const SolidDrawer& drawer, float opacity) const {
  for (const Body& body : bodies_) {
    if (body.isPlaced) drawer.draw(body.solid, roomFromEye_, opacity);
  }
}

}  // namespace carom
