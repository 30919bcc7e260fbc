#pragma once
// What a person of one room promises to the other rooms of a game: that nothing they will do lies outside the
// future of an event, the promise. Theory: app/doc/physics.md, Linked rooms.
//
// J⁺(E) is the causal future of an event E, all that light from E can reach. Two invariants hold:
//   I1  everything that a person does after having told a promise Q (strokes, head, hand as drawn) lies in
//       J⁺(Q);
//   I2  no eye of another room is ever in J⁺(Q) of the newest promise all of whose strokes are known there.
// Then no stroke that arrives changes anything that has been seen, and everything that is seen of the others
// is known, however long the news takes and in whatever order it comes.

#include "engine/spacetime/event.h"
#include "engine/spacetime/lorentz.h"

namespace carom {

/// How much earlier than the light of a promise an eye must be, in board seconds: far more than rounding.
inline constexpr double kEyesStayBefore_s = 1e-6;

/// Returns by how many board seconds `event` is later than the light of `from` at its place: negative outside
/// of J⁺(from), NaN if anything is.
double afterLightOf_s(const Event& from, const Event& event, double c_m_s);

/// Returns whether `event` lies in J⁺(from).
inline bool isInFutureOf(const Event& from, const Event& event, double c_m_s) {
  return afterLightOf_s(from, event, c_m_s) >= 0.0;
}

/// Returns how far from the head a hand may strike and be drawn while the nearest head of another room is
/// known to be `nearest_m` away: min(reach, 0.4 · nearest). So rooms in which people come near each other
/// need not wait.
double reachBeside_m(double reach_m, double nearest_m);

/// The newest promise of one person.
class Promise {
 public:
  /// Promises for a head at `head` in a room that moves as `boardFromRoom`: with hands that reach `reach_m`.
  Promise(const Event& head, const Lorentz& boardFromRoom, double reach_m);

  /// Promises anew for a later moment. Where that would take back a part of the promise before, which thrust
  /// or a growing reach can ask for, the promise before stays.
  void renew(const Event& head, const Lorentz& boardFromRoom, double reach_m);

  const Event& event() const { return event_; }

  /// Returns the earliest event in the future of the promise at which somebody at rest in the room can do
  /// what they would do at `act`: `act` itself where it keeps the promise.
  Event putOff(const Event& act, const Lorentz& boardFromRoom) const;

  /// Returns the event of a hand as it is drawn for others: `fromHead_m` (room frame) from a head at `head`,
  /// drawn in to `reach_m`, and put off until it keeps the promise.
  Event drawnHand(const Event& head, const Vec3& fromHead_m, const Lorentz& boardFromRoom,
                  double reach_m) const;

 private:
  Event event_;
};

}  // namespace carom
