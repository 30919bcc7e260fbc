#pragma once
// The game as rank 0 plays it: the billiard, ahead of what anyone can see, and what of it is new each frame.

#include <span>
#include <vector>

#include "app/files/scenario.h"
#include "cave/frame/frame_state.h"
#include "engine/billiard/billiard.h"

namespace carom {

/// No eye of this person, now or later, sees a leg of these bodies that ended before this board time. A leg
/// is past when all points of the body have been seen to join a later one, from the middle of the eyes as it
/// was kEyesMayRunBack_m/c earlier (engine/light/light_cone.h): the middle moves slower than light, so its
/// past cone only grows. The eyes are up to 0.1 m from it and simultaneous with it for the head, so on the
/// board up to γ × 0.1 m away and γβ × 0.1 m/c earlier; they are inside its past cone of then while γ(1 + β)
/// × 0.1 m is less than kEyesMayRunBack_m: up to γ = 500.
double forgettableBefore_s(std::span<const WorldLine> bodies, const ObserverView& observer);
inline constexpr double kEyesMayRunBack_m = 100.0;

/// The latest board time at which an eye receives light.
double latestObservation_s(const ObserverView& observer);

class Game {
 public:
  /// `struck`: the strokes that hands have let go in earlier frames of the session that goes on, in their
  /// order.
  explicit Game(const Scenario& scenario, std::span<const Stroke> struck = {});

  /// The pucks' ways as far as they are known, in the scenario's order.
  std::span<const WorldLine> pucks() const { return billiard_.worldLines(); }

  /// Plays on to board time `t_s` at least.
  void playTo(double t_s) { billiard_.advanceTo(t_s); }

  /// A hand's stroke (Billiard::strike): what was played beyond its arrival is played anew, and the next
  /// frame says so. Returns the arrival. Throws std::invalid_argument for a stroke that cannot be.
  Event strike(const Stroke& stroke);

  /// Plays on until every puck's way is known as far as the head's own moment, which may lie ahead on the
  /// board.
  void playToNowOf(const ObserverView& observer);

  /// Plays on to board time `t_s` and adds to `state` the knots that no frame has carried yet.
  void advance(double t_s, FrameState& state);

  /// Forgets what `forgettableBefore_s` allows, and has every rank forget it with this frame. `histories`: of
  /// every body of the scene.
  void forget(std::span<const WorldLine> histories, const ObserverView& observer, FrameState& state);

 private:
  Billiard billiard_;
  bool begun_ = false;
};

}  // namespace carom
