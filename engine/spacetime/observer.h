#pragma once
// What an observer is at one moment: a tracked head, the events at which its eyes receive light, and where
// the room that carries it starts. Their world lines are in observers.h. Theory: app/doc/physics.md, The
// celerity clock.

#include <array>
#include <numbers>

#include <glm/gtc/quaternion.hpp>

#include "engine/base/pose.h"
#include "engine/spacetime/event.h"
#include "engine/spacetime/lorentz.h"

namespace carom {

/// The initial position and motion of the platform that carries the room. Board frame.
struct ObserverStart {
  Vec3 position_m{0.0, -1.6, -0.75};         ///< of the room's floor origin
  double facing_rad = std::numbers::pi / 2;  ///< of the room's forward, anticlockwise from +x
  Vec3 beta{0.0};                            ///< v/c of the platform
};

/// Returns the room's attitude and motion on the board at the start of a game: the axes of its floor (right,
/// forward and up), boosted by the platform's β.
Lorentz startingRoom(const ObserverStart& start, const RoomAxes& axes, double lightSpeed_m_s);

/// The tracked head at one drawn frame. Room frame.
struct Head {
  Pose roomFromHead;       ///< of the midpoint between the eyes; head axes x right
  Vec3 celerity_m_s{0.0};  ///< filtered dx/dτ of that midpoint
};

/// One eye: the board event at which it receives light, and where it is in the room (for the walls).
struct EyeView {
  Event observation;
  Vec3 positionInRoom_m{0.0};
  /// The point of the room from which its seen places are counted: its own position, or, while the view is
  /// frozen, the position at which the view was frozen.
  Vec3 seenFromInRoom_m{0.0};
};

/// Names an eye, or the point between the eyes.
enum class Eye { left, right, middle };

/// What a person sees by at one drawn frame.
struct ObserverView {
  Lorentz headFromBoard{1.0};   ///< axes of the head frame are parallel to the room's
  EyeView left, right, middle;  ///< middle: the point between the eyes
  double properTime_s = 0.0;    ///< the person's own clock

  const EyeView& of(Eye eye) const { return eye == Eye::left ? left : eye == Eye::right ? right : middle; }
  /// Copies of left, right and middle, in this order.
  std::array<EyeView, 3> all() const { return {left, right, middle}; }
};

/// Returns what eyes see of which one is `right_m` from `middle` and the other as far on its other side (room
/// frame), at events that are simultaneous for the head.
ObserverView viewOfEyes(const Lorentz& headFromBoard, const EyeView& middle, const Vec3& right_m,
                        double properTime_s);

/// Returns the view of somebody who rests at a place of the room, at the room's moment of another's view;
/// `right_m` as in viewOfEyes.
ObserverView viewAtRest(const ObserverView& other, const Lorentz& boardFromRoom, double room_s,
                        const Vec3& placeInRoom_m, const Vec3& right_m);

/// Returns a frozen view that the person walks round: the light is that of `sight`, from the middle of the
/// eyes, for both eyes; the eyes' positions in the room are those of `now`.
ObserverView frozenViewAt(const ObserverView& sight, const ObserverView& now);

}  // namespace carom
