#pragma once
// The event-driven simulation behind `Billiard` (billiard.h says what happens in which order). Each puck
// keeps its next predicted event (event_predictor.h), a queue orders these events by time, the first is
// committed (impact_resolver.h), and then only the pucks that it changed are predicted anew. Inside, c = 1
// (times in metres of light), and the pucks are numbered in the order of their names.

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/billiard/due_queue.h"
#include "engine/billiard/event_predictor.h"
#include "engine/game/billiard_setup.h"
#include "engine/game/game_history.h"
#include "engine/game/game_state.h"
#include "engine/impact/impact_resolver.h"
#include "engine/impact/jam_resolver.h"
#include "engine/impact/neighbours.h"

namespace carom {

/// A game that can be played on. It can be copied; a copy is a point to which the game can return.
class CollisionScheduler {
 public:
  explicit CollisionScheduler(const BilliardSetup& setup);

  /// Commits every event that is due at or before board time `limit`, and the events for which these must
  /// wait. Stops and returns false when the game holds `events` events.
  bool playUntil(double limit, std::size_t events, GameHistory& history);
  /// Returns by how much a collision can come due later than its contact and than its first turn.
  double rollbackWindow() const { return game_.rollbackWindow; }
  /// Returns the latest due time (board time) of the events committed so far.
  double clock() const { return clock_; }

  void addStroke(const Stroke& stroke);
  /// A puck as it leaves the game.
  struct Withdrawn {
    LegState state;                    ///< on the leg that it follows
    Vec21 u;                           ///< by the kicks that are decided
    std::vector<std::size_t> strokes;  ///< those to come, by their places in the setup
  };
  /// Takes a puck out of the game at board time `t`, to which the game has been played.
  Withdrawn withdraw(std::size_t puck, double t, GameHistory& history);
  /// Removes everything that was written since this copy of the game was made.
  void restore(GameHistory& history) const { game_.restore(history); }

  Ledger ledger() const { return game_.ledger(); }
  std::span<const JamNote> jams() const { return game_.jams; }
  /// Returns what the pucks do at present.
  const GameState& state() const { return game_; }

 private:
  void flashUntil(double limit, GameHistory& history);
  bool hasDeferredBefore(double limit);
  void prefetchUpcoming();
  void step(GameHistory& history);
  void meet(int i, GameHistory& history);
  bool waitsForItself(int i) const;
  void predictMembers(EventPredictor& predictor, int i, int j) const;
  EventPredictor predictor() { return {game_, neighbours_, queue_, void_, clock_}; }
  ImpactResolver resolver(GameHistory& history) { return {game_, history, neighbours_.cells(), jam_}; }

  GameState game_;
  Neighbours neighbours_;
  DueQueue queue_;
  std::vector<std::pair<std::uint32_t, Event>>
      flashes_;                    // in the order of time, beside their place in the setup
  std::size_t flashed_ = 0;        // number of flashes listed so far
  std::vector<int> deferred_;      // pucks whose event waits until others have had theirs
  std::size_t deferredLater_ = 0;  // the first of them wait for something after the limit of `playUntil`
  unsigned steps_ = 0;
  double clock_ = 0.0;
  Jam jam_;                // of the event that was committed last
  std::vector<int> void_;  // scratch
};

}  // namespace carom
