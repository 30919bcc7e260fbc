#pragma once
// The game on rank 0: a billiard simulated ahead of what anyone can see, and its changes in each frame.

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "app/scenario/scenario.h"
#include "cave/record/frame_state.h"
#include "engine/billiard/billiard.h"

namespace carom {

/// Returns the board time before which no leg of these bodies that has ended will be seen by any eye of this
/// viewer, now or later. A leg is past when all points of the body have been seen to join a later one, from
/// the middle of the eyes as it was kEyesMayRunBack_m/c earlier (engine/light/light_cone.h): the middle moves
/// slower than light, so its past cone only grows. The eyes are up to 0.1 m from it and simultaneous with it
/// for the head, so on the board up to γ × 0.1 m away and γβ × 0.1 m/c earlier; they are inside its past cone
/// of then while γ(1 + β) × 0.1 m is less than kEyesMayRunBack_m: up to γ = 500.
double forgettableBefore_s(std::span<const WorldLine> bodies, const ObserverView& observer);
inline constexpr double kEyesMayRunBack_m = 100.0;

/// Returns the board time, in metres of light, before which no row of these soft bodies will be seen by any
/// eye of this viewer: the earliest of the times of their last rows all of whose nodes lie inside its past
/// cone by kRowsBehind_m. Like the places of hands they may be forgotten sooner than legs: an eye that steps
/// back further sees the bodies on the straight way by which they came.
double forgettableRowsBefore_m(std::span<const SoftPast> bodies, const ObserverView& observer);
inline constexpr double kRowsBehind_m = 2.0;

/// Returns the latest board time at which an eye receives light; of a record, an eye of any viewer.
double latestObservation_s(const ObserverView& observer);
double latestObservation_s(const FrameRecord& record);

class Game {
 public:
  /// Starts a game. `struck` are the strokes by hand in earlier frames of a continued session, in their
  /// order.
  explicit Game(const Scenario& scenario, std::span<const Stroke> struck = {});

  /// Returns the pucks' world lines as far as they are known, in the scenario's order.
  std::span<const WorldLine> pucks() const { return billiard_.worldLines(); }

  /// Simulates the game up to board time `t_s` or later. Soft pucks are played ahead of it on a thread.
  void playTo(double t_s) { billiard_.advanceTo(t_s); }

  /// Strikes a puck by hand (Billiard::strike). The simulation after the stroke's arrival is computed
  /// again, and the next frame says so. Returns the arrival event. Throws std::invalid_argument if the stroke
  /// is impossible.
  Event strike(const Stroke& stroke);

  /// Simulates until every puck's motion is known at the head's own moment, which may lie ahead on the board.
  void playToNowOf(const ObserverView& observer);

  /// Simulates to board time `t_s` and adds to `state` the knots that no frame has carried yet. Warns of each
  /// soft puck that could not be followed.
  void advance(double t_s, FrameState& state);

  /// Discards the history before `forgettableBefore_s` of all these observers and before `keptFrom_s`, and
  /// tells every rank to do the same with this frame.
  void forget(const World& world, std::span<const ObserverView> observers, FrameState& state,
              double keptFrom_s = std::numeric_limits<double>::infinity());

 private:
  void tellCrushed();

  Billiard billiard_;
  std::vector<std::string> names_;  // of the pucks
  std::size_t crushed_ = 0;         // of them it is said
  SoftRows rows_;
  bool begun_ = false;
};

}  // namespace carom
