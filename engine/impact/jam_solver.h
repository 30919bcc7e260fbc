#pragma once
// Bodies that press on one another: bodies and their contacts in, velocities and spins out. c = 1.
//
// The contacts are kicked one after the other, discs without rebound, until none closes. What then moves
// together goes on with one velocity. Four-momentum is conserved; the energy that is lost is heat, which each
// body radiates in its own rest frame. Theory: app/doc/physics.md, Jams.

#include <optional>
#include <span>
#include <vector>

#include "engine/collision/kick.h"
#include "engine/collision/puck_leg.h"
#include "engine/collision/turning.h"
#include "engine/polygons/corner_contact.h"
#include "engine/polygons/corner_cushion.h"
#include "engine/polygons/corner_kick.h"

namespace carom {

/// Of light speed: bodies with corners that lie on each other and move slower than this rest.
constexpr double kResting = 1e-10;
/// Of the radii: nearer than this is touching.
constexpr double kJamTouching = 1e-6;
/// The restitution of inelastic bodies with corners in a jam: so it ends after few kicks.
constexpr double kJamRebound = 0.25;

/// A body in a jam.
struct JamBody {
  int puck = 0;
  SpinningBody masses;
  double radius = 0.0;
  const Outline* outline = nullptr;  ///< none: a disc
  LegState turn;                     ///< before
  Turning turning;                   ///< likewise
  double j = 0.0;                    ///< after
  double mass = 0.0;                 ///< with this spin
  Vec21 u;
  double heat = 0.0;
  Vec21 radiated, taken;  ///< four-momenta: as heat, and by cushions
  unsigned cushions = 0;  ///< that it touches, one bit each
  int group = 0;          ///< the first body of the group with which it moves on
  int changed = 0;        ///< number of the last sweep that changed it

  void kick(const Vec21& to, double itsHeat) {
    u = to;
    heat += itsHeat;
    radiated = radiated + to * itsHeat;
  }
  void turnTo(double spin) { j = spin, mass = restMass(masses, spin); }
  /// Returns it in flight with the velocity and the spin that it has now.
  MovingShape shape() const;
};

/// Two bodies that touch.
struct JamContact {
  int first = 0, second = 0;         ///< places among the bodies
  bool hasCorners = false;           ///< at least one of them has
  std::vector<TouchedPlace> places;  ///< of bodies with corners
};

struct JamRules {
  double puckRestitution = 1.0, cushionRestitution = 1.0;
  bool withCorners = false;  ///< whether any puck of the game has corners
};

/// Solves one jam, in place.
class JamSolver {
 public:
  JamSolver(const JamRules& rules, std::span<const CushionPlane> cushions, std::span<JamBody> bodies,
            std::span<const JamContact> contacts)
      : rules_(rules), cushions_(cushions), bodies_(bodies), contacts_(contacts) {}

  /// Kicks one contact after the other until none closes faster than `slow`; of bodies with corners, which
  /// rebound a little, until none closes. Returns whether it came to that.
  bool relax(double slow);
  /// Gives bodies that touch and move relative to each other slower than `slow` the velocity of their total
  /// momentum; bodies with corners only where `slow` is infinite.
  void moveOnTogether(double slow);

 private:
  bool part(const JamContact& contact, double slow);
  bool partDiscs(JamBody& one, JamBody& two, double slow) const;
  bool partCorners(JamBody& one, JamBody& two, std::span<const TouchedPlace> places) const;
  void leaveCushions(JamBody& body, double slow) const;
  void partFromCushions(JamBody& body) const;
  void moveGroup(int group);

  JamRules rules_;
  std::span<const CushionPlane> cushions_;
  std::span<JamBody> bodies_;
  std::span<const JamContact> contacts_;
};

/// Returns the way from the first of two centres to the second when the later of both has turned, in the
/// frame in which they move with equal speeds.
Vec21 wayBetween(const JamBody& one, const JamBody& two);
/// Returns 2(γrel − 1), which is the square of a small relative celerity, without cancellation.
double relative2(const Vec21& u1, const Vec21& u2);

}  // namespace carom
