#pragma once
// The carom billiard: pucks gliding on the board, colliding with each other and with the cushions,
// found ahead of time and delivered as knots of world lines.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/billiard_setup.h"

namespace carom {

class Anticipation;
class Chronicle;

/// Plays the game ahead: finds every contact before it happens (puck_contact.h, cushion_contact.h), commits
/// its outcome (kick.h) and delivers the new legs of the world lines.
///
/// What happens in which order:
/// * A puck meets its contacts, cushions included, in the order of its own proper time; where two pucks that
///   meet have had different numbers of events, the one behind is waited for. Equal times go by name, so the
///   order of the pucks in the setup changes no bit of any result.
/// * Until the news of a contact has reached its centre, a puck follows its old leg and its contacts are
///   found on that leg; their outcomes use the momenta already decided, and pucks that by these recede are
///   not kicked. Kicks apply in the order of their turns. If a kick's turn would lie before the last one
///   decided, the whole collision is dropped, not one puck's half of it: so momentum is always conserved. A
///   cushion that a decided leg reaches before such a turn is committed first: so no centre ever leaves the
///   table.
/// * A pair that has collided does not collide again until one of the two has had another event.
/// * A pair or cushion already in contact when a leg begins, and approaching, is kicked at that moment
///   without delay: the pair at the later of the two starts in the equal-speed frame, and its news starts at
///   each centre.
/// * Inelastic or jammed pucks can collide without end in a finite time. A puck whose last 64 kicks fell
///   within a millionth of the time that light needs to cross its radius is taken to be jammed: until it has
///   been left in peace for as long, its kicks are perfectly plastic, and pucks that close on it at less than
///   1e-9 c do not kick. `jams` tells where.
///
/// With friction, the contact of two pucks is at the first board time t at which Dpar = dmin for the flights
/// that touch the two world lines at t, and kicks act on the momenta the pucks have at their turns.
class Billiard {
 public:
  /// Refuses what cannot be played with std::invalid_argument that names the puck and the values: a light
  /// speed, radius, height, mass, board or restitution out of range, not a number, |β| >= 1, equal names,
  /// friction × radius >= c²/2, pucks that overlap at t = 0 on the board, a puck in a cushion, a stroke on no
  /// puck or before t = 0.
  explicit Billiard(const BilliardSetup& setup);
  ~Billiard();
  Billiard(Billiard&&) noexcept;
  Billiard& operator=(Billiard&&) noexcept;

  /// Commits every event whose contact or first turn is at or before board time `t_s`, and perhaps some that
  /// are a little later. What is committed does not depend on the steps in which one advances.
  void advanceTo(double t_s);

  /// Adds a stroke. What was computed at or after its arrival is discarded and computed anew, up to the same
  /// board time; everything outside the future of the arrival keeps its bits. Returns the board time of the
  /// arrival. Throws std::invalid_argument for a stroke on no puck, not finite, or arriving before t = 0 or
  /// in what `forgetBefore` has forgotten.
  double strike(const Stroke& stroke);

  /// One world line for each puck, in the order of the setup; complete up to the time advanced to.
  std::span<const WorldLine> worldLines() const;
  /// In the order in which they were committed. A stroke can change the turns of those before it whose news
  /// was on its way.
  std::span<const GameEvent> events() const;
  /// Knots and events added or changed since the last call, and whether a stroke took some back.
  Changes takeChanges();

  Ledger ledger() const;
  std::span<const JamNote> jams() const;

  /// Forgets the legs that ended and the events that were over before board time `t_s`. Strokes can no
  /// longer arrive before it.
  void forgetBefore(double t_s);

 private:
  void play();
  void rewind(double t_s);
  void keepSnapshot();
  void noteChanges(const std::vector<std::vector<Knot>>& before);
  double arrivalOnKnownLegs_s(const Stroke& stroke) const;

  struct Snapshot;
  BilliardSetup setup_;
  std::unique_ptr<Chronicle> chronicle_;
  std::unique_ptr<Anticipation> game_;
  std::vector<Snapshot> snapshots_;  // in the order of time
  std::size_t nextSnapshot_ = 64;    // when there are that many events
  double advancedTo_s_ = 0.0;
  double forgottenBefore_s_ = 0.0;
  std::vector<std::size_t> reported_;  // of each puck's knots, counted from the start of the game
  std::uint64_t reportedEvents_ = 0;
  std::optional<double> truncatedFrom_s_;
};

}  // namespace carom
