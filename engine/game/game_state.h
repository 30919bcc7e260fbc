#pragma once
// The state of a game of rigid pucks: what its setup fixes, the leg that each puck follows, the legs that are
// decided, and the books of energy and momentum. Everything that plays the game reads and changes this state.
// c = 1 (times in metres of light), and the pucks are numbered in the order of their names.

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "engine/base/large_pages.h"
#include "engine/base/prefetch.h"
#include "engine/collision/cushion_contact.h"
#include "engine/collision/puck_contact.h"
#include "engine/collision/puck_leg.h"
#include "engine/collision/rim_friction.h"
#include "engine/collision/turning.h"
#include "engine/game/billiard_setup.h"
#include "engine/game/game_history.h"
#include "engine/game/puck_state.h"
#include "engine/polygons/moving_shape.h"

namespace carom {

/// The numbers of two pucks, the smaller one first.
using PuckPair = std::array<int, 2>;

/// What the setup fixes.
struct GameRules {
  explicit GameRules(const BilliardSetup& setup);
  /// Returns the laws of a rim with this coefficient of restitution.
  static RimRules withRestitution(RimRules rims, double restitution) {
    rims.restitution = restitution;
    return rims;
  }

  /// Whether straight flights of discs that pass tell that two pucks do not meet.
  bool areStraightDiscs() const { return brake == 0.0 && outlines == nullptr; }

  double c_m_s;
  TurnConvention convention;
  double puckRestitution, cushionRestitution;
  bool canPress;                   // whether pucks or cushions are inelastic, or some have corners
  double brake;                    // friction over c²
  RimRules puckRims, cushionRims;  // their coefficients of restitution aside
  double slowing;                  // of spins by the cloth: the rim's γβ in a metre of own time
  double largestRadius = 0.0;
  std::vector<CushionPlane> cushions;
  /// By puck; null in a game of discs.
  std::shared_ptr<const std::vector<std::optional<Outline>>> outlines;
};

struct GameState {
  explicit GameState(const BilliardSetup& setup);

  GameRules rules;
  bool turns;              // whether anything, strokes so far included, can turn a puck
  LargeArray<Disc> discs;  // the legs being followed; the search for partners reads them
  LargeArray<Prediction> predictions;
  LargeArray<PuckState> pucks;
  std::vector<PuckSpin> spins;
  std::vector<PuckStroke> strokes;
  Accounts accounts;
  std::vector<JamNote> jams;
  double rollbackWindow = 0.0;  // by which a collision can come due later than its contact and its first turn
  double fastest = 1.0;         // the greatest γ decided since it was last set
  std::vector<int> begun;       // pucks that have begun legs since it was last cleared

  /// Prefetches the rest of a puck's state from memory.
  void fetch(int i) const {
    prefetch(&pucks[i]);
    if (rules.canPress) prefetch(&pucks[i].impactsBegan);
  }
  int count() const { return static_cast<int>(pucks.size()); }
  /// Returns the number of a puck of the setup.
  int numberOf(std::size_t puck) const;
  bool isWithdrawn(int i) const { return pucks[i].mass == 0.0; }

  /// Returns the leg that the puck follows, for what does not ask for the puck's own clock.
  Leg flightOf(int i) const { return {discs[i].start, discs[i].u, 0.0, rules.brake}; }
  /// Returns the leg that the puck follows.
  Leg legOf(int i) const { return {discs[i].start, discs[i].u, pucks[i].properTime, rules.brake}; }
  /// Returns the last leg decided, and the spin at its beginning; all 0 in a game in which nothing can turn a
  /// puck.
  Leg lastLeg(int i) const { return pucks[i].decided.empty() ? legOf(i) : pucks[i].decided.back().leg; }
  Turning lastTurning(int i) const {
    if (!turns) return {};
    return pucks[i].decided.empty() ? spins[i].turning : pucks[i].decided.back().turning;
  }
  /// Returns the spin on the last leg decided, at a moment of the puck's own clock.
  Turning turningAt(int i, double properTime) const { return turns ? spunTurning(i, properTime) : Turning{}; }
  /// Returns the number of legs begun, and the number of the last leg decided, from the start of the game.
  std::size_t legsBegun(int i) const { return predictions[i].legNumber + std::size_t{1}; }
  std::size_t lastLegNumber(int i) const { return legsBegun(i) + pucks[i].decided.size(); }
  /// Returns the rest mass that moves.
  double massOf(int i, double j) const { return j == 0.0 ? pucks[i].mass : restMass(spins[i].body, j); }
  const Outline* outlineOf(int i) const {
    return rules.outlines == nullptr || !(*rules.outlines)[i] ? nullptr : &*(*rules.outlines)[i];
  }
  MovingShape shapeOn(int i, const Leg& leg, const Turning& turning) const;
  MovingShape followedShape(int i) const { return shapeOn(i, flightOf(i), spins[i].turning); }
  /// Returns the velocities and spins that are decided of two.
  std::array<Vec21, 2> lastVelocities(const PuckPair& who) const {
    return {lastLeg(who[0]).u, lastLeg(who[1]).u};
  }
  std::array<double, 2> lastSpins(const PuckPair& who) const {
    return {lastTurning(who[0]).j, lastTurning(who[1]).j};
  }

  /// Returns the last contact of the legs that two pucks follow, if it has been dealt with.
  const HandledContact* handled(int i, int other) const;
  void noteHandled(int i, const HandledContact& contact);
  double decidedAt(int i) const { return predictions[i].hasDecided ? pucks[i].decidedAt : -kNever; }
  void noteDecided(int i, double at) {
    pucks[i].decidedAt = at;
    predictions[i].hasDecided = true;
  }
  /// Returns the contact since which two bodies have not parted (persistent_contact.h).
  const PersistentContact* persistentContact(int first, int second) const;

  /// Returns the coefficient of restitution for a turn: none for a puck that is kicked without end.
  double restitution(int i, double usual, double turnTime);
  void noteKick(int i, const Vec21& turn);
  void noteImpact(int i, double turnTime, double closing, bool byMany) {
    if (rules.canPress) pucks[i].noteImpact(turnTime, discs[i].radius, closing, byMany);
  }
  bool isPressed(int i, double t) const { return rules.canPress && pucks[i].isPressed(t, discs[i].radius); }

  /// Takes in a stroke, and returns the number of its puck.
  int addStroke(const Stroke& stroke);
  /// Returns the board time at which a stroke reaches a puck on a leg.
  double arrivesAt(int stroke, const Leg& leg) const {
    const PuckStroke& s = strokes[stroke];
    return s.fromHand ? signalArrives(leg, s.hand, s.height).x.t : s.hand.t;
  }
  /// Decides that a puck turns: books it, writes the leg, and begins it if its turn is now.
  void decide(int i, const CommittedLeg& given, const LegState& turn, GameHistory& history);
  void beginLeg(int i, const Leg& leg, const Turning& turning);
  /// Begins the first leg of those decided.
  void beginDecided(int i);

  /// Writes the contact of a cushion's kick that is decided as it is now.
  void noteBounce(const CommittedLeg& decided, GameHistory& history) const;

  /// Removes everything that was written since this copy of the state was made.
  void restore(GameHistory& history) const;
  Ledger ledger() const;

 private:
  Turning spunTurning(int i, double properTime) const;
};

}  // namespace carom
