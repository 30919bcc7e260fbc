#pragma once
// Finds the puck that a hand points to, at the position where the viewer sees it, not where it is by now.

#include <cstddef>
#include <optional>
#include <span>

#include "cave/record/frame_state.h"
#include "engine/light/light_cone.h"
#include "engine/spacetime/observer.h"
#include "engine/spacetime/world_line.h"

namespace carom {

/// A ray from a hand. Room frame; `along` is a unit vector.
struct HandRay {
  Vec3 from_m{0.0};
  Vec3 along{0.0};
};

/// The object that a ray hits, and where it ends.
struct PickResult {
  std::optional<std::size_t> puck;  ///< index in the game of the first puck hit
  bool behind = false;              ///< no puck is hit, but there is one in the opposite direction
  Vec3 end_m{0.0};                  ///< end of the ray: on the puck, on the cloth, or in the air
};

class RayPicking {
 public:
  /// A ray that misses a puck by up to this angle still picks it: an outstretched hand trembles by half a
  /// degree, and a puck of 3 cm at five metres is no larger than that.
  static constexpr double kNear_rad = 0.02;
  /// Length of a ray that hits nothing; longer than a table.
  static constexpr double kLongest_m = 5.0;

  /// The view of a frame: the eye used for aiming, and the effects that are switched off.
  struct Sight {
    const ObserverView& observer;
    Eye eye;
    const Switches& switches;
  };

  /// Returns where the eye sees a body's centre, as drawn on the walls. Room frame.
  Vec3 seenInRoom_m(const WorldLine& body, const Sight& sight);

  /// Returns the first puck that the ray intersects; otherwise, of those within kNear_rad, the one closest to
  /// the ray in angle from the hand. The cloth is at its position in the room, which for horizontal motion of
  /// the platform is also where it is seen.
  PickResult at(const HandRay& ray, std::span<const WorldLine> pucks, const Sight& sight,
                const Lorentz& boardFromRoom);

 private:
  BodyView view_;  // scratch
};

}  // namespace carom
