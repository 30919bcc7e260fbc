#pragma once
// The observers who share one room: world lines of their own, walked by tracked heads inside a room that may
// itself be moving.
//
// A single observer's clock is their proper time τ. A tracked step dx made in dτ is a celerity, which has no
// upper limit: room time advances by dT = sqrt(dτ² + |dx|²/c²), so the world line is timelike whatever the
// observer does. Several observers share the room's time: the one who moves fastest needs most of it, and the
// clocks of the others run ahead. All their presents are simultaneous in the room, so none is ever in
// another's past. Theory: app/doc/physics.md, The celerity clock; The platform.

#include <array>
#include <cstddef>
#include <span>

#include <glm/gtc/quaternion.hpp>

#include "engine/base/limits.h"
#include "engine/spacetime/event.h"
#include "engine/spacetime/lorentz.h"
#include "engine/spacetime/observer.h"

namespace carom {

/// One of the observers at one moment.
struct OneObserver {
  Event headEvent;            ///< on the board: the point between the eyes
  Vec3 placeInRoom_m{0.0};    ///< of the head, as the clocks took it: without what a tracker's glitches added
  Head head;                  ///< as tracked; its celerity is per second of the observer's own clock
  double properTime_s = 0.0;  ///< the observer's own clock
  /// The rate of proper time at rest at this place of the room, relative to the room's time, in the last
  /// frame.
  double lapse = 1.0;
};

/// A turn of the room about the head of the one who steers.
struct RoomTurn {
  double angle_rad = 0.0;
  Vec3 axisInRoom{0.0, 0.0, 1.0};
};

class Observers {
 public:
  /// The heads' first places are `heads` (1 to kMostViewers); `boardFromRoom` is the room's attitude and
  /// motion, and `roomOrigin` the board event of the room's origin at the moment (in the room's frame) of the
  /// start.
  Observers(const Lorentz& boardFromRoom, const Event& roomOrigin, std::span<const Head> heads);
  Observers(const Lorentz& boardFromRoom, const Event& roomOrigin, const Head& head)
      : Observers(boardFromRoom, roomOrigin, {&head, 1}) {}

  /// Goes on from an earlier moment, at which the room's clock showed `room_s`.
  Observers(const Lorentz& boardFromRoom, double room_s, std::span<const OneObserver> observers);

  /// Returns an observer, alone in the room, whose head is at a known board event and whose clock shows
  /// `properTime_s`.
  static Observers at(const Event& headEvent, double properTime_s, const Lorentz& boardFromRoom,
                      const Head& head);

  /// Begins a drawn frame: its lapses are those reported, and over its steps together the fastest lives the
  /// sum of their dt. Where there are several observers, every frame begins so.
  void beginFrame();

  /// Lives on for `dt_s` of the fastest observer's proper time while the tracked heads move to `heads`. A
  /// step beyond the glitch's celerity (kGlitchCelerity_m_s, or kGlitchOfSeveral_m_s where there are several)
  /// moves a head, as re-anchoring, but not along its world line. `pace`: board seconds per second of the
  /// fastest observer, which is the light speed that is shown divided by the game's. `thrust_m_s2`: the
  /// proper acceleration that the room has meanwhile, felt at the head of observer `steering`, in the room's
  /// axes and the board's seconds; it must not exceed strongestThrust_m_s2 with the farthest observer's
  /// distance. Exact for a head at rest in the room: then its world line is a hyperbola, and the chord of a
  /// step is along its middle's velocity. `turn`: of the room, afterwards.
  void step(double dt_s, std::span<const Head> heads, double pace = 1.0, const Vec3& thrust_m_s2 = Vec3(0.0),
            std::size_t steering = 0, const RoomTurn& turn = {});
  void step(double dt_s, const Head& head, double pace = 1.0, const Vec3& thrust_m_s2 = Vec3(0.0)) {
    step(dt_s, {&head, 1}, pace, thrust_m_s2);
  }

  /// Returns the room's time that such a step takes.
  double roomTimeOf_s(double dt_s, std::span<const Head> heads, double pace, const Vec3& thrust_m_s2,
                      std::size_t steering) const;

  /// Moves with the heads wherever they are in the room, in `roomTime_s` of the room's time, even faster than
  /// light. For looking at a recorded game whose time stands still or runs at another rate; the heads count
  /// as at rest in the room.
  void moveUnseen(double roomTime_s, std::span<const Head> heads);
  void moveUnseen(double roomTime_s, const Head& head) { moveUnseen(roomTime_s, {&head, 1}); }

  /// Turns the room about the head of observer `steering`, which stays at its event. The others are carried
  /// round in the next step.
  void turn(const RoomTurn& turn, std::size_t steering = 0);

  /// Returns the eyes of an observer, `eyeSeparation_m` apart, at events that are simultaneous for the head.
  ObserverView view(double eyeSeparation_m, std::size_t observer = 0) const;
  /// Returns the same for eyes that are elsewhere: from the head, in the room's axes.
  ObserverView view(const Vec3& left_m, const Vec3& right_m, std::size_t observer = 0) const;

  std::size_t size() const { return size_; }
  const OneObserver& operator[](std::size_t observer) const { return observers_[observer]; }
  const Event& headEvent(std::size_t observer = 0) const { return observers_[observer].headEvent; }
  double properTime_s(std::size_t observer = 0) const { return observers_[observer].properTime_s; }
  const Lorentz& boardFromRoom() const { return boardFromRoom_; }
  double room_s() const { return room_s_; }  ///< the room's own clock

  /// Returns the greatest distance of an observer from the one who steers.
  double farthestFrom_m(std::size_t steering) const;

 private:
  /// How an observer moves in one step.
  struct Step {
    Vec3 inRoom_m{0.0};   ///< of the head, as the clocks take it
    Vec3 carried_m{0.0};  ///< by turns of the room about somebody else
    double lapse = 1.0;
    double ahead_s = 0.0;  ///< own time lived in earlier steps of the frame, beyond that of the fastest
  };
  using Steps = std::array<Step, kMostViewers>;

  Steps stepsTo(double dt_s, std::span<const Head> heads, const Vec3& thrust_m_s2, std::size_t steering,
                const RoomTurn& turn) const;
  double roomTimeOf_s(const Steps& steps, double elapsed_s) const;
  void advance(const Steps& steps, double roomTime_s, double elapsed_s);
  void rotate(const glm::dquat& turned);
  void placeOthers(std::size_t steering);
  void reportLapses();

  Lorentz boardFromRoom_;
  double room_s_ = 0.0;
  std::array<OneObserver, kMostViewers> observers_;
  std::size_t size_ = 0;
  std::array<Vec3, kMostViewers> carried_m_{};  ///< by turns since the last step
  /// At the beginning of the frame; the observers' lapses are reported relative to it.
  double frameFrom_s_ = 0.0;
  std::array<OneObserver, kMostViewers> frameFrom_;
  int stepsOfFrame_ = 0;
  double livedOfFrame_s_ = 0.0;                 ///< by the fastest
  std::array<double, kMostViewers> ahead_s_{};  ///< own time lived in the frame beyond that
};

}  // namespace carom
