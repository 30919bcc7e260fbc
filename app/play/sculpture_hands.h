#pragma once
// Hands on the sculpture of spacetime: a hand that points at it and presses takes it, and what it does then
// depends on where it took it.
//
//   a bead          picks this event, or lets go of it: its double cone is shown
//   the ring        pulls the frame in which all of it is shown: a boost along the pull
//   the foot        moves it over the floor
//   the top         scales it, up and down
//   anything else   turns it about its axis

#include <array>
#include <optional>
#include <span>

#include "app/hand/hand_input.h"
#include "app/hand/ray_picking.h"
#include "cave/record/frame_state.h"
#include "engine/game/game_event.h"
#include "engine/sculpture/sculpture_place.h"

namespace carom {

/// What of the sculpture a hand points at.
enum class SculptureGrip { none, bead, ring, foot, top, body };

struct SculpturePick {
  SculptureGrip grip = SculptureGrip::none;
  double away_m = 0.0;      ///< from the hand
  std::uint64_t event = 0;  ///< the number of a bead's
};

/// Returns what a ray finds: a bead, else the ring, else the rest. `topOfPucks_m`: the height of the plane
/// that it shows.
SculpturePick pickSculpture(const HandRay& ray, const SculptureMap& map, std::span<const GameEvent> events,
                            double topOfPucks_m);

class SculptureHands {
 public:
  static constexpr double kRapidity_m = 0.35;  ///< a pull that adds one of rapidity
  static constexpr double kTurn_m = 0.30;      ///< a pull aside that turns it by a radian
  static constexpr double kFactor_m = 0.50;    ///< a pull upwards that makes it e times as large

  struct Outcome {
    bool takes = false;  ///< the hand is the sculpture's in this frame
    Vec3 at_m{0.0};      ///< the point of the ray that is held
    bool picked = false;
    bool atLimit = false;  ///< the pull would boost it further
    bool boosts = false;
  };
  /// Lets a viewer's hand act on `view`, in a frame in which the sculpture is shown.
  Outcome step(const HandInput& hand, std::size_t viewer, const SculptureMap& map,
               std::span<const GameEvent> events, double topOfPucks_m, SculptureView& view);
  /// Lets go, as when the sculpture is put away.
  void letGo() { holding_.reset(); }
  bool holds() const { return holding_.has_value(); }

 private:
  struct Holding {
    std::size_t viewer = 0;
    SculpturePick pick;
    Vec3 from_m{0.0};  // where it was taken
    SculpturePlace was;
  };
  std::optional<Holding> holding_;
};

}  // namespace carom
