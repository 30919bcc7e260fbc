#pragma once
// The person: a world line of their own, walked by a tracked head inside a room that may itself be moving.
//
// The person's clock is their proper time τ. A tracked step dx made in dτ is a celerity, which has no
// upper limit: room time advances by dT = sqrt(dτ² + |dx|²/c²), so the world line is timelike whatever
// the person does.

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

/// Returns a frozen view that the person walks round: the light is that of `sight`, from the middle of the
/// eyes, for both eyes; the eyes' positions in the room are those of `now`.
ObserverView frozenViewAt(const ObserverView& sight, const ObserverView& now);

class Observer {
 public:
  /// The head's first place is `head`; `boardFromRoom` is the room's attitude and motion, and `roomOrigin`
  /// the board event of the room's origin at the moment (in the room's frame) of the start.
  Observer(const Lorentz& boardFromRoom, const Event& roomOrigin, const Head& head);

  /// Returns an observer whose head is at a known board event and whose clock shows `properTime_s`.
  static Observer at(const Event& headEvent, double properTime_s, const Lorentz& boardFromRoom,
                     const Head& head);

  /// Lives on for dτ while the tracked head moves to `head`. A step beyond kGlitchCelerity_m_s moves the
  /// person's place in the room, as re-anchoring, but not along the world line. `pace`: board seconds
  /// per second of the person, which is the light speed that is shown divided by the game's.
  /// `thrust_m_s2`: the proper acceleration that the room has meanwhile, felt at the head, in the room's axes
  /// and the board's seconds. Exact for a head at rest in the room: then its world line is a hyperbola, of
  /// which a step's chord is that of its middle's velocity.
  void step(double dtau_s, const Head& head, double pace = 1.0, const Vec3& thrust_m_s2 = Vec3(0.0));

  /// Moves with the head wherever it is in the room, in `roomTime_s` of the room's time, even faster than
  /// light. For looking at a recorded game whose time stands still or runs at another rate; the head counts
  /// as at rest in the room.
  void moveUnseen(double roomTime_s, const Head& head);

  /// Turns the room about the head, which stays at its event.
  void turn(double angle_rad, const Vec3& axisInRoom);

  /// Returns the eyes, `eyeSeparation_m` apart, at events that are simultaneous for the head.
  ObserverView view(double eyeSeparation_m) const;

  const Event& headEvent() const { return headEvent_; }  ///< on the board
  const Lorentz& boardFromRoom() const { return boardFromRoom_; }
  double properTime_s() const { return properTime_s_; }

 private:
  Lorentz boardFromRoom_;
  Event headEvent_;
  Head head_;
  double properTime_s_ = 0.0;
};

}  // namespace carom
