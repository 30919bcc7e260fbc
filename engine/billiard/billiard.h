#pragma once
// The carom billiard: pucks gliding on the board, colliding with each other and with the cushions,
// found ahead of time and delivered as knots of world lines.
// Theory: app/doc/physics.md, The frame of a contact; Jams.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/game/billiard_setup.h"
#include "engine/game/soft_state.h"

namespace carom {

class CollisionScheduler;
class GameHistory;
class SoftGame;
class SoftRowBook;
struct SoftRows;

/// Plays the game ahead: finds every contact before it happens (puck_contact.h, cushion_contact.h), commits
/// its outcome (kick.h) and delivers the new legs of the world lines.
///
/// What happens in which order:
/// * A puck meets its contacts, cushions included, in the order of its own proper time; where two pucks that
///   meet have had different numbers of events, the one behind is waited for. Equal times go by name, so the
///   order of the pucks in the setup changes no bit of any result.
/// * Until the signal of a contact has reached its centre, a puck follows its old leg and its contacts are
///   found on that leg; their outcomes use the momenta already decided, and pucks that by these recede are
///   not kicked. Kicks apply in the order of their turns. If a kick's turn would lie before the last one
///   decided, the whole collision is dropped, not one puck's half of it: so momentum is always conserved. A
///   cushion that a decided or a struck leg reaches before such a turn is committed first: so no centre ever
///   leaves the table.
/// * A cushion kicks only what it touches, and once for one approach: a contact of the old leg with the line
///   of a cushion beyond the corner is none, and the signal of a cushion that the puck has been turned away
///   from since does nothing.
/// * A pair that has collided does not collide again until one of the two has had another event.
/// * A pair or cushion already in contact when a leg begins, and approaching, is kicked at that moment
///   without delay: the pair at the later of the two starts in the equal-speed frame, and its signal starts
///   at each centre. Such a kick does not wait for light, so a row of touching pucks passes an impact on
///   faster than light; `GameEvent::withoutDelay` marks it.
/// * Pucks that touch can collide without end in a finite time where they or the cushions are inelastic. A
///   puck that others have kicked 64 times within the time that light needs to cross its radius is pressed,
///   until it has been left in peace for as long; the kick of a pressed puck counts as 16. Where two pressed
///   pucks meet, all pressed pucks that touch them in a chain, nearer than a millionth of R1 + R2, take
///   perfectly plastic kicks, of each other and of the cushions that they touch, until none closes on
///   another; it takes no time, and each then turns once, simultaneously in the pair's equal-speed frame with
///   the turn of the puck through which it was reached. Those whose speeds then differ by less than 1e-6 c,
///   or 1e-6 of the hardest of the impacts where all are slower than light by far, get one and the same
///   velocity: they move on together, bit for bit, and their gap does not change. This bound doubles with
///   every fourth such turn that one of the meeting pair has had since it was last in peace, up to c or the
///   hardest impact: so pucks that are pressed again and again become one body.
///   Momentum is that of all; the rest of the energy is heat. Up to this 64th kick, and between pucks if
///   one is not pressed, every impact is one as ever. What closes slower than the bound is left alone where
///   it closes at less than a thousandth of its relative speed, so that the straight flights pass at most a
///   millionth of R1 + R2 (half of the square of that share) inside each other, or where the whole relative
///   speed is below a millionth of the bound: at first 1e-12 c, rounding, 5 nm in an hour at 1.42 m/s; at
///   most 1e-6 c, a millionth of R in the time after which a puck in peace is no more pressed. Elastic pucks
///   between elastic cushions are never pressed. `jams` tells where.
/// * A pressed puck keeps its spin: rims in a jam neither slip nor roll on each other.
/// * Bodies with corners lie on each other, and on cushions, at several places. Elastic ones can be pressed
/// as
///   well, and elastic discs beside them; a kick without delay counts as 16. Where such a body meets another
///   without delay, both pressed, or a cushion, all kicks between it and all pressed pucks that touch it, in
///   a chain, happen at once, without friction, each time at the place at which two close fastest, until none
///   closes faster than 1e-10 c: elastic ones where the rules are elastic, else with the restitution 1/4, so
///   that it comes to an end after few. These kicks change spins. Bodies that are so wedged that 300 rounds
///   do not settle it, or that have been in 64 jams without peace, move on as one, without spins, and what
///   energy is over is heat. A pair that recedes where it is in contact, by the momenta that are decided, is
///   kicked where else it touches and approaches; a pair of bodies that turn can meet again on the same legs
///   where nothing came of a contact.
/// * A body with corners and another that have come together remember that contact until they have parted.
/// Thin ones
///   can be deep in each other, or behind each other, when light has told their centres: until they are back,
///   only those sides kick from which they came (persistent_contact.h). Where a third one turns one of them
///   while they are behind each other, they stay there. While a contact's signal is on its way, other corners
///   of the pair still meet on the old legs: such a contact is one with a signal of its own, by the momenta
///   that are decided, and its kick takes in all places at which the two are in or through each other by
///   then, until they recede at all of them. One that is heard of before the first waits for it. Corners that
///   are through the other body as a leg begins, and go on, are kicked at once, without delay. At a bounce a
///   body keeps its angle in the board's axes.
/// * No contact of a pair can be played backwards, in either convention.
/// * Of a puck whose last 64 kicks, cushions' among them, fell within a millionth of that time, kicks are
///   perfectly plastic until it has been left in peace for as long: so between two cushions.
///   A disc that comes to a cushion slower than 1e-18 c stops: rough ones would turn it in their corner
///   without end.
///
/// With friction, the contact of two pucks is at the first board time t at which Dpar = dmin for the flights
/// that touch the two world lines at t, or, of a pair already in contact, where the later leg begins in its
/// equal-speed frame, and kicks act on the momenta the pucks have at their turns.
class Billiard {
 public:
  /// Throws std::invalid_argument, which names the puck and the values, for a setup that cannot be played: a
  /// light speed, radius, height, mass, board or restitution out of range, not a number, |β| >= 1, equal
  /// names, a rim at light speed, an inertia or a coefficient of friction out of range, a stroke beside the
  /// puck, friction × radius >= c²/2, pucks that overlap at t = 0 on the board, a puck in a cushion, a
  /// stroke on no puck or before t = 0.
  explicit Billiard(const BilliardSetup& setup);
  ~Billiard();
  Billiard(Billiard&&) noexcept;
  Billiard& operator=(Billiard&&) noexcept;

  /// Commits every event whose contact or first turn is at or before board time `t_s`, and perhaps some that
  /// are a little later. The commitments do not depend on the steps in which one advances.
  void advanceTo(double t_s);

  /// Plays the soft pucks ahead of the times asked for, on a thread of its own: results are the same, bit for
  /// bit.
  void playAhead();

  /// Adds a stroke. Everything at or after its arrival is discarded and computed anew, up to the same
  /// board time. What does not depend on the stroke keeps its bits: everything outside the future of the
  /// arrival but for what follows from turns that do not wait for light, those of kicks without delay and
  /// those simultaneous with a contact in the equal-speed frame. Such a turn can lie outside by about the
  /// size of the pucks that pass it on, and then even before the arrival on the board. Returns the board time
  /// of the arrival. Throws std::invalid_argument for a stroke on no puck, not finite, or arriving before
  /// t = 0 or in what `forgetBefore` has forgotten.
  double strike(const Stroke& stroke);

  /// Returns one world line for each puck, in the order of the setup, complete up to the time advanced to.
  /// They are completed where they are asked for: not by two threads at once.
  std::span<const WorldLine> worldLines() const;
  /// Returns the events in the order in which they were committed. A stroke can still change the turns of
  /// earlier events whose signal was on its way, and the contacts of those with a cushion.
  std::span<const GameEvent> events() const;
  /// Returns the knots and events added or changed since the last call, and whether a stroke removed some.
  Changes takeChanges();

  Ledger ledger() const;
  /// Returns the soft pucks at a board time not before that of the last call of `advanceTo` but one, and not
  /// after the last; with these points of theirs.
  SoftMoment softAt(double t_s, std::span<const SoftPoint> points = {}) const;
  /// Moves the rows of the soft pucks that have been played since the last call into `rows`, whose memory is
  /// used again (engine/billiard/soft_row_book.h).
  void takeSoftRows(SoftRows& rows);
  std::vector<FrozenPuck> frozen() const;
  std::span<const JamNote> jams() const;

  /// Removes the legs that ended and the events that were over before board time `t_s`. Strokes can no longer
  /// arrive before it.
  void forgetBefore(double t_s);

 private:
  void play();
  void playSoft();
  void beginSoft();
  void rewind(double t_s);
  void keepSnapshot();
  void noteChanges(const std::vector<std::vector<Knot>>& before);
  double arrivalOnKnownLegs_s(const Stroke& stroke) const;
  double reachesSoft_s(const Stroke& stroke) const;

  struct Snapshot;
  BilliardSetup setup_;
  std::unique_ptr<GameHistory> history_;
  std::unique_ptr<CollisionScheduler> game_;
  std::unique_ptr<SoftRowBook> softRows_;
  std::unique_ptr<SoftGame> soft_;  // none without soft pucks
  bool playsAhead_ = false;
  std::vector<Snapshot> snapshots_;  // in the order of time
  std::size_t nextSnapshot_ = 64;    // the number of events at which the next one is kept
  double advancedTo_s_ = 0.0;
  double forgottenBefore_s_ = 0.0;
  std::vector<std::size_t> reported_;  // the number of each puck's knots, counted from the start of the game
  std::uint64_t reportedEvents_ = 0;
  std::optional<double> truncatedFrom_s_;
};

}  // namespace carom
