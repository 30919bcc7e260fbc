#pragma once
// Where bodies are in the room at one time of the room's own clock: not their seen places, but those for
// observers at rest in the room.

#include <optional>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "engine/spacetime/event.h"
#include "engine/spacetime/lorentz.h"
#include "engine/spacetime/world_line.h"

namespace carom {

/// Returns the transform of what is apart in the room at one time of the room's clock to the rest frame, axes
/// as the board's, of a body that moves with γβ = `u` on the board: d = Λ dr.
glm::dmat3 bodyFromRoomNow(const Lorentz& boardFromRoom, const glm::dvec3& u);

class RoomSimultaneity {
 public:
  /// Sets the time at which something at `placeInRoom_m` in the room is at this event of the board.
  RoomSimultaneity(const Lorentz& boardFromRoom, const Event& event, const glm::dvec3& placeInRoom_m);

  /// Returns the transform that takes points of the body, given from its centre in its rest frame (axes as
  /// the board's), to the room: the body as it is there at that time, contracted along its motion through the
  /// room. Returns none if the body has not appeared yet. While a body turns, all its points are treated as
  /// moving with its centre.
  std::optional<glm::dmat4> roomFromBody(const WorldLine& line) const;

  /// Returns how long ago an event is by then.
  double since_s(const Event& event) const { return -(roomFromBoard_ * (event - event_)).dt_s; }
  /// Returns the transform of roomFromBody for a body that is seen to be at an event, and moves with γβ =
  /// `u`.
  glm::dmat4 roomFrom(const Event& centre, const Vec3& u) const;

 private:
  Motion at(const WorldLine& line) const;

  Lorentz boardFromRoom_, roomFromBoard_;
  Event event_;
  glm::dvec3 placeInRoom_m_;
};

}  // namespace carom
