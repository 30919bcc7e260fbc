#pragma once
// Where two pucks meet that friction slows: the first board time t at which Dpar = dmin (puck_contact.h) for
// the straight flights that touch both world lines at t.

#include <optional>

#include "engine/puck_contact.h"
#include "engine/puck_leg.h"

namespace carom {

struct BrakedDisc {
  Leg leg;
  double radius = 0.0;
};

struct BrakedMeeting {
  Meeting meeting;
  double touchAt = 0.0;  ///< t; the flights of `flightAt` at this time give the contact
};

/// The straight flight that touches a leg at board time `t`.
Disc flightAt(const BrakedDisc& disc, double t);

/// The first meeting at or after both starts. Bounds of how fast the gap can close keep the search from
/// stepping over one.
std::optional<BrakedMeeting> findBrakedMeeting(const BrakedDisc& first, const BrakedDisc& second,
                                               TurnConvention convention);

}  // namespace carom
