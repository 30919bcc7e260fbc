#pragma once
// Where bodies are in the room at one moment of the room's own time: not what is seen, but what is there, for
// those who rest in the room.

#include <optional>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "engine/spacetime/event.h"
#include "engine/spacetime/lorentz.h"
#include "engine/spacetime/world_line.h"

namespace carom {

class RoomSimultaneity {
 public:
  /// The moment at which something in the room at `placeInRoom_m` is at this event of the board.
  RoomSimultaneity(const Lorentz& boardFromRoom, const Event& event, const glm::dvec3& placeInRoom_m);

  /// Takes points of the body, given from its centre in its rest frame (axes as the board's), to the room:
  /// the body as it stands there at that moment, contracted along its motion through the room. None if it has
  /// not appeared yet. While a body is turning, as if all its points moved as its centre does.
  std::optional<glm::dmat4> roomFromBody(const WorldLine& line) const;

 private:
  Motion at(const WorldLine& line) const;

  Lorentz boardFromRoom_, roomFromBoard_;
  Event event_;
  glm::dvec3 placeInRoom_m_;
};

}  // namespace carom
