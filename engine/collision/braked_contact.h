#pragma once
// The contact of two pucks that friction slows: the first board time t at which Dpar = dmin (puck_contact.h)
// for the straight flights that touch both world lines at t. A pair that is in contact as the later of the
// two legs begins, in its equal-speed frame, meets then: its flights touch the world lines at that moment of
// the frame. Theory: app/doc/physics.md, Friction.

#include <array>
#include <optional>

#include "engine/collision/puck_contact.h"
#include "engine/collision/puck_leg.h"

namespace carom {

struct BrakedDisc {
  Leg leg;
  double radius = 0.0;
};

struct BrakedMeeting {
  Meeting meeting;
  std::array<double, 2> touchAt{};  ///< the flights of `flightAt` at these times give the contact
};

/// Returns the straight flight that touches a leg at board time `t`.
Disc flightAt(const BrakedDisc& disc, double t);

/// Returns the first meeting of two legs, at or after the later start, or already in contact there: the
/// meeting that `findMeeting` gives for the flights that touch the legs at t. Bounds of how fast the gap can
/// close keep the search from missing a meeting, at any board time: legs moved in time meet as much later.
std::optional<BrakedMeeting> findBrakedMeeting(const BrakedDisc& first, const BrakedDisc& second,
                                               TurnConvention convention);

}  // namespace carom
