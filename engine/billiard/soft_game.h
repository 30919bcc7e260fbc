#pragma once
// The soft pucks of a game, beside the event queue of the rigid ones (collision_scheduler.h): both are
// played in slices of board time. A rigid puck that comes within reach of a soft one leaves the queue and
// is soft from then on, because no rigid body can stay in touch causally. Their centres of energy are
// written to the game's world lines, with a leg for each slice in which the motion changes.
// Theory: app/doc/physics.md, Soft bodies.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/billiard/collision_scheduler.h"
#include "engine/billiard/soft_ahead.h"
#include "engine/billiard/soft_row_book.h"
#include "engine/game/billiard_setup.h"
#include "engine/game/game_history.h"
#include "engine/game/soft_state.h"
#include "engine/soft/soft_play.h"

namespace carom {

class SoftGame {
 public:
  /// Takes the soft pucks of the setup out of the rigid game. Their rows go into `rows`, which begins anew
  /// and must outlive the game.
  SoftGame(const BilliardSetup& setup, CollisionScheduler& rigid, GameHistory& history, SoftRowBook& rows);
  SoftGame(const SoftGame&) = delete;
  SoftGame& operator=(const SoftGame&) = delete;

  /// Returns the board time (c t, metres) to which the soft pucks are played.
  double time() const { return play_.time(); }
  /// Plays both games through the next slice; the rigid one to its beginning.
  void playSlice(CollisionScheduler& rigid, GameHistory& history);
  /// Adds the stroke with this place in the setup, if its puck is soft already.
  void addStroke(std::size_t stroke, const Stroke& told);
  /// Has the slices to come played by a thread of their own, from now on (engine/billiard/soft_ahead.h).
  void playAhead();
  bool isSoft(std::size_t puck) const { return bodies_[puck].has_value(); }

  void addTo(Ledger& ledger) const;
  std::vector<FrozenPuck> frozen() const;
  /// Returns the state at a board time in the slices played since `forgetBefore`.
  SoftMoment at(double t_s, std::span<const SoftPoint> points);
  /// Notes that `at` will not be asked for earlier times.
  void forgetBefore(double t_s);

  struct Snapshot;
  std::shared_ptr<const Snapshot> snapshot(GameHistory& history) const;
  void restore(const Snapshot& snapshot, GameHistory& history);

 private:
  struct Body {
    std::size_t number = 0;              // in the play
    std::optional<double> becameSoft{};  // board time
  };
  // What the game has of a stroke that the play has been given.
  struct Given {
    std::size_t stroke = 0;
    bool isListed = false;
  };

  // How many of the play's happenings are among the game's events.
  struct Listed {
    std::size_t contacts = 0, parted = 0, heard = 0;
  };

  void enter(std::size_t puck, const CollisionScheduler::Withdrawn& was, double clock,
             const SoftMatter& matter, const WorldLine* rigidLine);
  void takeInReach(CollisionScheduler& rigid, GameHistory& history);
  void writeLegs(double from, GameHistory& history);
  void listEvents(GameHistory& history);
  void listStroke(std::size_t number, double began, GameHistory& history);
  void listTouch(std::size_t number, bool isLast, GameHistory& history);
  LegState centreAt(std::size_t puck, double t, GameHistory& history) const;
  SoftPuckState stateOf(std::size_t puck) const;
  SoftContactState contactState(const SoftCollision& collision) const;

  double c_m_s_;
  double stiffSound_;
  std::vector<Puck> pucks_;
  std::vector<Stroke> strokes_;
  SoftPlay play_;
  SoftRowBook* rows_;
  std::vector<std::optional<Body>> bodies_;  // by puck
  std::vector<std::size_t> puckOf_;          // by their number in the play
  std::vector<Given> given_;                 // by their number in the play
  Listed listed_;
  std::unique_ptr<SoftAhead> ahead_;  // none: slices are played where they are asked for
  bool isNews_ = true;                // the slices played ahead do not know of the present state
  // The starts of slices, for `at`.
  std::deque<std::pair<double, std::shared_ptr<const SoftPlay::Snapshot>>> recent_;
};

}  // namespace carom
