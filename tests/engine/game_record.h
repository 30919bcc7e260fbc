#pragma once
// A game that was played, as those read it who check it: legs in long doubles, and for every turn the
// collision that made it, found again from the world lines alone.

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "engine/billiard/billiard.h"
#include "engine/checked_leg.h"

namespace carom::test {

/// Two pucks beside each other in the frame in which both move with equal and opposite speeds, as straight
/// flights that touch their legs at board time t. Of the first the rim reaches towards the second along
/// `ahead` and `aside`, both contracted by gamma along the motion.
struct Encounter {
  std::array<Four, 2> x, u;      ///< at t on the board
  Four U;                        ///< the frame's four-velocity
  Real gamma = 1, speed = 0;     ///< of each in it; speed in units of c
  std::array<Real, 2> moment{};  ///< of x in the frame, from the first's on
  Four ahead, aside;             ///< unit vectors of the frame: the first's motion, and across it
  Real distance = 0;             ///< of the second ahead of the first, when that is at x
  Real offset = 0;               ///< of the second aside of the first

  Real distanceAt(Real moment_m) const { return distance - 2 * speed * moment_m; }
  /// How far apart the rims are at a moment of the frame: below 0 where they overlap.
  Real gapAt(Real moment_m, Real reach) const {
    return std::hypot(gamma * distanceAt(moment_m), offset) - reach;
  }
  /// When they touch, if they pass near enough to touch at all.
  std::optional<Real> touch(Real reach) const {
    if (!(std::abs(offset) < reach) || !(speed > 0)) return std::nullopt;
    return (distance - std::sqrt(reach * reach - offset * offset) / gamma) / (2 * speed);
  }
  /// The moment of an event on the flight of one.
  Real momentOf(int which, const Four& event) const {
    return moment[which] + (event.t - x[which].t) / u[which].t * gamma;
  }
  /// The centre of one at a moment of the frame, on its flight.
  Four at(int which, Real moment_m) const {
    return x[which] + u[which] * ((moment_m - moment[which]) / gamma);
  }
  /// Where the rims meet at that moment.
  Four contactAt(Real moment_m, Real share) const;
};
Encounter encounterOf(const CheckedLeg& first, const CheckedLeg& second, Real t);
/// Of flights that touch their legs at different times.
Encounter encounterOf(const CheckedLeg::LegState& first, const CheckedLeg::LegState& second);

/// As the later of the two legs begins, in their frame: the flights touch the legs there, one of them at its
/// start.
Encounter encounterAtLaterStart(const CheckedLeg& first, const CheckedLeg& second);

/// What roundings of the engine come to in the gap of an encounter, in metres.
Real roundingOf(const Encounter& encounter);
/// And in the direction in which they approach, in radians: it is that of the small difference of two
/// velocities, which under friction are known as exactly as the time.
Real roundingOfWay(const Encounter& encounter, Real brake);

/// A contact, as the flights of two legs have it: those at the first's moment of it.
struct Contact {
  Encounter encounter;
  Real moment = 0;  ///< of the frame
};

/// A puck's part in a collision, a bounce or a stroke.
struct Part {
  std::size_t event = 0;  ///< place in the list of events
  std::size_t knot = 0;   ///< that it made; 0: none was found
  std::size_t leg = 0;    ///< on which the contact was found
  Real own = 0;           ///< the puck's own moment of the contact, board time
  Real turn = 0;          ///< board time
  Real due = 0;           ///< the latest own moment of those who took part
  Real decidedFrom = 0;   ///< it was decided at this board time or later
  int partner = -1;       ///< puck
  bool idle = false;      ///< nothing came of it: a stroke kept the puck from the cushion
  Real off = 0;           ///< by how much the rims do not meet at the contact, in metres
  Real tolerance = 0;     ///< of that: roundings of the engine
};

struct GameRecord {
  GameRecord(const BilliardSetup& played, const Billiard& billiard, double playedUntil_s);

  const BilliardSetup* setup;
  Real c, until;                              ///< until: board time in metres of light
  std::vector<std::vector<CheckedLeg>> legs;  ///< of each puck
  std::vector<std::vector<Part>> parts;       ///< of each puck, in the order of the events
  std::vector<std::vector<int>> partOfKnot;   ///< of each puck: the part that made a knot, −1: none
  std::vector<GameEvent> events;
  std::vector<Contact> contacts;  ///< one for each event; of two pucks alone
  std::vector<bool> jammed;       ///< pucks that the guard against endless collisions noted

  bool atCentre() const { return setup->rules.collisionEvent == CollisionEvent::centre; }
  Real radius(std::size_t puck) const { return setup->pucks[puck].radius_m; }
  Real mass(std::size_t puck) const { return setup->pucks[puck].mass_kg; }
  Four place(const Event& event) const { return fourFrom(event, setup->lightSpeed_m_s); }
  /// The board times between which the game looked for contacts of a leg: from at the latest, until at the
  /// earliest.
  std::vector<std::vector<std::array<Real, 2>>> followed;
  const Part* partOf(std::size_t puck, std::size_t event) const;
  /// The two of a collision, in the order of their names.
  std::array<std::size_t, 2> pair(const GameEvent& event) const;

 private:
  void findKnots(const Billiard& billiard);
  void findLegs(std::size_t event);
  void findFollowed();
  void findLegOfBounce(const GameEvent& event, Part& part) const;
  void findLegsOfCollision(const GameEvent& event, Part& first, Part& second);
  void placeWithoutDelay(const GameEvent& event, Part& first, Part& second);
};

}  // namespace carom::test
