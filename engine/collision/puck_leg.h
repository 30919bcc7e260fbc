#pragma once
// One leg of a puck's centre in the board's plane, c = 1: straight flight, or a glide that friction slows
// with constant proper deceleration until it rests. The same motion as `motionOnLeg` of world_line.h, in
// the units of the collision physics.
// Theory: app/doc/physics.md, Friction.

#include <limits>

#include "engine/spacetime/minkowski.h"

namespace carom {

/// A leg from `start` on. Lengths in metres, times in metres of light (c t).
struct Leg {
  Vec21 start;              ///< where it begins
  Vec21 u{1.0, 0.0, 0.0};   ///< four-velocity there
  double properTime = 0.0;  ///< c τ there
  double brake = 0.0;       ///< proper deceleration over c², 1/m
};

/// The centre at one moment of a leg.
struct LegState {
  Vec21 x;
  Vec21 u;
  double properTime = 0.0;
};

/// Returns the state of the centre at board time `t` (c t, metres). Before the start, the leg is continued
/// backwards without friction.
LegState momentAt(const Leg& leg, double t);
/// Returns the same without the proper time under friction, which takes longer to compute than the rest.
LegState placeAt(const Leg& leg, double t);

/// Returns the state `s` metres of own proper time after the start of a leg without friction.
LegState momentAfter(const Leg& leg, double s);

/// Returns the board time at which friction has stopped the puck; infinity without friction.
double restsAt(const Leg& leg);

/// Returns the state in which light from `signal` meets the centre: the one event with (X − signal)² = h² on
/// the future cone, where h is the height of the source above the centres' plane.
LegState signalArrives(const Leg& leg, const Vec21& signal, double height = 0.0);

/// Returns the state of the centre that is simultaneous with `event` in the frame that moves with
/// four-velocity U.
LegState simultaneousWith(const Leg& leg, const Vec21& event, const Vec21& U);

/// Returns the first board time after the start at which the centre's coordinate `axis` (0: x, 1: y) is
/// `bound`, which lies ahead of it; infinity if it comes to rest before, or does not move that way.
double reaches(const Leg& leg, int axis, double bound);

}  // namespace carom
