#pragma once
// The results of a game so far: the pucks' world lines and the list of events, in SI units and in the order
// of the setup. The game itself works with c = 1 and with the pucks in the order of their names.

#include <algorithm>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "engine/base/block_pool.h"
#include "engine/base/large_pages.h"
#include "engine/base/prefetch.h"
#include "engine/collision/puck_leg.h"
#include "engine/collision/turning.h"
#include "engine/game/billiard_setup.h"

namespace carom {

/// The spin of a puck at a turn, as J/(R c).
struct TurnedSpin {
  double before = 0.0, after = 0.0;
};

class GameHistory {
 public:
  explicit GameHistory(const BilliardSetup& setup);

  /// Adds a leg to a puck's world line. `signal` is the event from which the rest of the puck learns of it.
  void addLeg(std::size_t puck, const Leg& leg, const Turning& turning, const Vec21& signal);
  /// Removes all legs of a puck but the first `legs`, counted from the start of the game.
  void keepLegs(std::size_t puck, std::size_t legs);
  std::size_t legs(std::size_t puck) {
    complete();
    return forgottenLegs_[puck] + lines_[puck].knots().size();
  }

  /// Prefetches what `addTurn` needs of a puck from memory.
  void fetch(std::uint32_t puck) const { prefetch(&shapes_[puck]); }

  // Adding an event returns its number, counted from the start of the game. Its turns are added afterwards.
  std::uint64_t addCollision(std::optional<Cushion> cushion, const Vec21& contact, bool withoutDelay,
                             double heat_j);
  /// Notes that in the last collision added a side lies on a side.
  void noteSideOnSide() { events_.back().sideOnSide = true; }
  std::uint64_t addJam(const Vec21& contact, double heat_j);
  /// Adds a stroke of the setup, at the hand or at the centre, `height_m` above the cloth.
  std::uint64_t addStroke(std::uint32_t stroke, const Vec21& at, double height_m);
  /// Adds an event of soft pucks, whose centres go on in these states, at the height of the first. It comes
  /// without cushion, heat, or place in a list.
  GameEvent& addSoft(EventKind kind, const Vec21& at, std::span<const std::size_t> pucks,
                     std::span<const LegState> states);
  std::uint64_t addFlash(std::uint32_t flash, const Event& at);
  void addTurn(std::uint64_t event, std::size_t puck, const LegState& before, const Vec21& uAfter,
               const TurnedSpin& spin);
  /// Replaces the turn of a puck in an event; does nothing if the event is already forgotten.
  void changeTurn(std::uint64_t event, std::size_t puck, const LegState& before, const Vec21& uAfter,
                  const TurnedSpin& spin);
  /// Replaces the contact, `withoutDelay` and the heat of a collision with a cushion; does nothing if the
  /// event is already forgotten.
  void changeBounce(std::uint64_t event, const Vec21& contact, bool withoutDelay, double heat_j);
  void keepEvents(std::uint64_t count);
  std::uint64_t eventCount() const { return forgottenEvents_ + events_.size(); }
  std::uint64_t forgottenEvents() const { return forgottenEvents_; }
  /// Notes that the legs added before have changed from this turn on.
  void noteChange(const Vec21& turn) { changedFrom_s_ = std::min(changedFrom_s_, turn.t / c_m_s_); }
  /// Returns the time of the earliest such turn since the last call; infinity if there was none.
  double takeChangedFrom_s() {
    return std::exchange(changedFrom_s_, std::numeric_limits<double>::infinity());
  }
  /// Returns how many of the first events are unchanged since the last call.
  std::uint64_t takeUnchangedEvents() { return std::exchange(unchangedEvents_, eventCount()); }

  /// Removes the legs that ended and the events that were over before board time `t_s`.
  void forgetBefore(double t_s);

  std::span<const WorldLine> worldLines() {
    complete();
    return lines_;
  }
  std::span<const GameEvent> events() const { return events_; }

 private:
  struct NewLeg {
    Vec21 start, signal;
    Vec2 u;
    double properTime;
    Turning turning;
    std::uint32_t puck;
  };
  // What of a puck the events and the world lines need.
  struct Shape {
    double height_m = 0.0;  // of the centre
    double radius_m = 0.0;
  };
  void buyMemory(std::size_t pucks);
  /// Appends the added legs to the world lines.
  void complete();
  void append(const NewLeg& leg);
  GameEvent& add(EventKind kind, const Event& at);
  /// Returns an event for changing it, and notes that it changes.
  GameEvent& change(std::uint64_t event);
  Event eventOf(std::size_t puck, const Vec21& x) const;
  Turn turnOf(std::size_t puck, const LegState& before, const Vec21& uAfter, const TurnedSpin& spin) const;
  Spin spinOf(std::size_t puck, const Turning& turning) const;

  double c_m_s_;
  double friction_m_s2_;
  double slowing_1_s_;  // of the rims' γβ
  LargeArray<Shape> shapes_;
  std::vector<SpinningBody> bodies_;  // by puck, for those that spin
  BlockPool knots_;                   // the memory of the world lines
  LargeArray<WorldLine> lines_;
  LargeArray<NewLeg> newLegs_;  // legs that are not in the lines yet, in the order in which they were added
  std::vector<std::uint32_t> byPuck_;  // scratch: their places, by puck
  std::vector<std::uint32_t> ends_;    // scratch: how far a puck's places reach
  LargeArray<GameEvent> events_;
  double changedFrom_s_ = std::numeric_limits<double>::infinity();
  std::vector<std::size_t> forgottenLegs_;
  std::uint64_t forgottenEvents_ = 0;
  std::uint64_t unchangedEvents_ = 0;
};

}  // namespace carom
