#pragma once
// The input of a billiard game (board, rules, pucks, strokes, flashes) and its results (balance, jams,
// changes).

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/game/game_event.h"
#include "engine/spacetime/event.h"
#include "engine/spacetime/world_line.h"

namespace carom {

struct Board {
  double length_m = 0.0;  ///< along x, inner edge to inner edge, centred on the origin
  double width_m = 0.0;   ///< along y
};

/// Matter that gives way and conducts sound (engine/soft/soft_body.h).
struct SoftMatter {
  double soundSpeed = 0.5;  ///< of c, in the relaxed body
  int cells = 10;           ///< edges of triangles along the longest half extent
  double viscosity = 0.3;
  /// A side of a rectangle whose nodes move as a told body's centre does.
  struct HeldSide {
    struct Turn {
      double t_s = 0.0;
      Vec2 beta{0.0};
    };
    bool isPlusX = false;     ///< the side +x, else −x
    std::vector<Turn> turns;  ///< in the order of time; before the first it moves as the puck at board time 0
  };
  std::vector<HeldSide> held{};
};

struct Puck {
  std::string name;
  double radius_m = 0.0;  ///< of the disc, or of the farthest corner (`radiusOf_m`)
  double height_m = 0.0;
  double mass_kg = 0.0;
  Vec2 position_m{0.0};  ///< of the centre at board time 0
  Vec2 beta{0.0};        ///< v/c at board time 0
  double inertia = 0.5;  ///< share of the mass that is in the rim (engine/collision/spinning_body.h)
  /// At board time 0, where its angle is 0: in the centre's rest frame, anticlockwise seen from above.
  double spin_kg_m2_s = 0.0;
  /// The corners, from the centre, anticlockwise in the rest frame at angle 0 (engine/polygons/outline.h).
  /// None: a disc.
  std::vector<Vec2> outline_m{};
  std::optional<SoftMatter> soft{};  ///< none: a rigid puck
};

/// The event at which a collision changes the motion of a puck's centre.
enum class CollisionEvent {
  centre,   ///< when the signal of the contact has reached it
  contact,  ///< simultaneously with the contact, in the frame of equal speeds
};

struct PhysicsRules {
  double puckRestitution = 1.0;
  double cushionRestitution = 1.0;
  double friction_m_s2 = 0.0;
  CollisionEvent collisionEvent = CollisionEvent::centre;
  // Coulomb's coefficients between rims and at cushions, and the share that is left of the speed at which
  // rims slip (engine/collision/rim_friction.h). Infinite: rims never slide.
  double puckFriction = 0.0, cushionFriction = 0.0;
  double tangentialRestitution = 0.0;
  double spinDeceleration_m_s2 = 0.0;  ///< of the rim, by the cloth
  /// Of c, in a rigid puck that a soft one has come near: it has become soft itself.
  double stiffSoundSpeed = 0.7;
};

/// A cue stroke, which kicks a puck's centre. It acts where the light of the stroke meets the centre's world
/// line, so that nothing that an eye at the hand has already seen can change; `Billiard::strike` says what it
/// can change. A kick that is still on its way to the centre (that of a collision whose signal has not
/// arrived) keeps its impulse, a cushion its law; both act when their signal meets the new motion. If the new
/// motion touches that cushion itself and turns there earlier, that contact replaces the older one. A bounce
/// that the stroke prevents, or from which it drives the puck away, stays in the list of events, without
/// delay, with a turn at the stroke that changes nothing.
struct Stroke {
  std::size_t puck = 0;        ///< index into the setup's pucks
  double at_s = 0.0;           ///< board time at which the hand strikes, or at which the centre is kicked
  std::optional<Vec3> from_m;  ///< the hand's place; none: the centre itself
  Vec2 momentum_kg_m_s{0.0};
  /// How far beside the centre it strikes, to the right of its momentum, in the puck's rest frame: it then
  /// turns the puck, J' = J + offset · |p| for a puck at rest. It grips no farther out than 0.99 R/u of a
  /// puck with the celerity u along the stroke: beyond, no spin is in balance with its energy.
  double offset_m = 0.0;
};

/// Light that starts from a point at rest on the board. It has no effect on the pucks, but is one of the
/// events.
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

/// Returns the distance of the farthest corner from the centre.
double radiusOf_m(const std::vector<Vec2>& outline_m);
/// Returns γβ of the rim of a puck with that angular momentum.
double rimUOf(const Puck& puck, double spin_kg_m2_s, double c_m_s);
/// Returns the angular momentum of a puck that turns at `omega_rad_s` by its own clock, slower than light.
double spinAt_kg_m2_s(const Puck& puck, double omega_rad_s, double c_m_s);
/// Returns the angular momentum of a puck whose rim has the celerity γβ.
double spinOfRim_kg_m2_s(const Puck& puck, double rim_u, double c_m_s);
/// Returns the rest mass that moves, with the energy of the spin.
double restMass_kg(const Puck& puck, double spin_kg_m2_s, double c_m_s);

/// The balance of energy and momentum. At any moment of the game, and whatever is still pending,
///   motion + radiated + takenByCushions + lostToFriction − givenByStrokes
/// equals the motion at the start. `motion` is that of the legs already decided, at their beginnings.
struct Ledger {
  struct Account {
    double energy_j = 0.0;  ///< with the rest energies
    Vec2 momentum_kg_m_s{0.0};
  };
  Account motion;
  Account radiated;         ///< heat: each puck's share leaves it in its own rest frame
  Account takenByCushions;  ///< momentum alone
  Account lostToFriction;   ///< with what the cloth takes from spins
  Account givenByStrokes;
  double heat_j = 0.0;  ///< Σ (m' − m) c²
};

/// A jam: pucks that would have collided without end in a finite time (see `Billiard`).
struct JamNote {
  std::size_t puck = 0;  ///< the first of them by name
  Event event;           ///< the contact; for a puck between cushions, the turn
  /// The number of pucks that moved on together; 1 for a puck between cushions, whose kicks become plastic.
  std::size_t pucks = 1;
  double heat_j = 0.0;  ///< the heat of the pucks that moved on together
};

/// The changes of the world lines and of the events since they were last asked for.
struct Changes {
  struct NewKnot {
    std::size_t puck = 0;
    Knot knot;
  };
  /// If set, the receiver first removes every knot whose turn is at or after this board time
  /// (`WorldLine::truncateFrom`); the new knots then replace them.
  std::optional<double> truncatedFrom_s;
  std::vector<NewKnot> knots;  ///< each puck's in the order of time
  /// The receiver first removes the events from this number on; the new ones, numbered from here, follow.
  std::uint64_t eventsKept = 0;
  std::vector<GameEvent> events;
};

}  // namespace carom
