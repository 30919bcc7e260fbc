#pragma once
// Which puck a hand points to. What counts is where the person sees it, wherever it may be by now.

#include <cstddef>
#include <optional>
#include <span>

#include "cave/frame/frame_state.h"
#include "engine/light/light_cone.h"
#include "engine/spacetime/observer.h"
#include "engine/spacetime/world_line.h"

namespace carom {

/// A ray that starts at a hand. Room frame; `along` is a unit vector.
struct HandRay {
  Vec3 from_m{0.0};
  Vec3 along{0.0};
};

/// What a ray meets.
struct PickResult {
  std::optional<std::size_t> puck;  ///< the first one, counted as in the game
  bool behind = false;              ///< none, but there is one the other way
  Vec3 end_m{0.0};                  ///< where the ray ends: on the puck, on the cloth, or in the air
};

class RayPicking {
 public:
  /// A ray that passes a puck by no more than this still means it: a hand that is held out freely trembles by
  /// half a degree, and a puck of 3 cm five metres away is no larger than that.
  static constexpr double kNear_rad = 0.02;
  /// Where it meets nothing, a ray ends in the air, farther away than a table is long.
  static constexpr double kLongest_m = 5.0;

  /// The sight of a frame: the eye by which is aimed (an index into `observer.eyes`), and what is switched
  /// off.
  struct Sight {
    const ObserverView& observer;
    std::size_t eye;
    const Switches& switches;
  };

  /// Where the eye sees a body's centre, as the walls draw it. Room frame.
  Vec3 seenInRoom_m(const WorldLine& body, const Sight& sight);

  /// Of the pucks that the ray goes through the first; else, of those it passes closely, the one it passes
  /// most closely as seen from the hand. The cloth is where the room has it: for the horizontal motion of a
  /// platform also where it is seen.
  PickResult at(const HandRay& ray, std::span<const WorldLine> pucks, const Sight& sight,
                const Lorentz& boardFromRoom);

 private:
  BodyView view_;  // scratch
};

}  // namespace carom
