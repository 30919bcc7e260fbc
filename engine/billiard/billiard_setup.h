#pragma once
// What a game of the billiard begins with, and what it delivers.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/billiard/game_event.h"
#include "engine/spacetime/event.h"
#include "engine/spacetime/world_line.h"

namespace carom {

struct Board {
  double length_m = 0.0;  ///< along x, inner edge to inner edge, centred on the origin
  double width_m = 0.0;   ///< along y
};

struct Puck {
  std::string name;
  double radius_m = 0.0;
  double height_m = 0.0;
  double mass_kg = 0.0;
  Vec2 position_m{0.0};  ///< of the centre at board time 0
  Vec2 beta{0.0};        ///< v/c at board time 0
};

/// Where a puck's centre changes its motion.
enum class CollisionEvent {
  centre,   ///< when the signal of the contact has reached it
  contact,  ///< simultaneously with the contact, in the frame of equal speeds
};

struct PhysicsRules {
  double puckRestitution = 1.0;
  double cushionRestitution = 1.0;
  double friction_m_s2 = 0.0;
  CollisionEvent collisionEvent = CollisionEvent::centre;
};

/// A cue stroke: kicks a puck's centre. It acts where the light of the stroke meets the centre's world line,
/// so that nothing an eye at the hand has already seen can change; what can at all is said at
/// `Billiard::strike`. A kick that is still on its way to the centre (a collision's, whose signal has not
/// arrived) keeps its impulse, a cushion its law, and acts when its signal meets the new motion; if the new
/// motion itself has touched that cushion and is turned by this before, that contact stands for the older
/// one. A bounce that the stroke prevents or drives the puck away from stays in the list of events, without
/// delay, with a turn at the stroke that changes nothing.
struct Stroke {
  std::size_t puck = 0;        ///< index into the setup's pucks
  double at_s = 0.0;           ///< board time at which the hand strikes, or at which the centre is kicked
  std::optional<Vec3> from_m;  ///< the hand's place; none: the centre itself
  Vec2 momentum_kg_m_s{0.0};
};

/// Light that starts from a point at rest on the board. The pucks take no notice; it is one of the events.
struct Flash {
  std::string name;
  Event at;
};

struct BilliardSetup {
  double lightSpeed_m_s = 0.0;
  std::optional<Board> board;  ///< none: an open plane without cushions
  PhysicsRules rules;
  std::vector<Puck> pucks;
  std::vector<Stroke> strokes;
  std::vector<Flash> flashes;
};

/// Where energy and momentum went. Always, at any moment of the game and whatever is still pending,
///   motion + radiated + takenByCushions + lostToFriction − givenByStrokes
/// is what the motion was at the start. `motion` is that of the legs already decided, at their beginnings.
struct Ledger {
  struct Account {
    double energy_j = 0.0;  ///< with the rest energies
    Vec2 momentum_kg_m_s{0.0};
  };
  Account motion;
  Account radiated;         ///< heat: each puck's share leaves it in its own rest frame
  Account takenByCushions;  ///< momentum alone
  Account lostToFriction;
  Account givenByStrokes;
  double heat_j = 0.0;  ///< Σ (m' − m) c²
};

/// Where the guards against endless collisions in a finite time stepped in: see `Billiard`.
struct JamNote {
  std::size_t puck = 0;  ///< the first of them by name
  Event event;           ///< the contact; of a puck between cushions the turn
  /// How many moved on together; 1: a puck between cushions, whose kicks become plastic.
  std::size_t pucks = 1;
  double heat_j = 0.0;  ///< of the pucks that moved on together
};

/// What of the world lines and of the events changed since the last time it was asked for.
struct Changes {
  struct NewKnot {
    std::size_t puck = 0;
    Knot knot;
  };
  /// If set: first forget, of every puck, the knots whose turn is at or after this board time
  /// (`WorldLine::truncateFrom`); the new knots then replace them.
  std::optional<double> truncatedFrom_s;
  std::vector<NewKnot> knots;  ///< each puck's in the order of time
  /// Of the list of events: first forget those from this number on; the new ones, numbered from here, follow.
  std::uint64_t eventsKept = 0;
  std::vector<GameEvent> events;
};

}  // namespace carom
