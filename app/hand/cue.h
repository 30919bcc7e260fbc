#pragma once
// The cue in the player's hand: aimed, held, drawn back and released.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "app/hand/hand_input.h"
#include "app/hand/ray_picking.h"
#include "engine/game/game_event.h"
#include "engine/spacetime/lorentz.h"

namespace carom {

/// Pull for u = 1: the rest momentum m c, which with the puck's own energy makes √2 m c².
inline constexpr double kPullForOne_m = 0.15;
/// Pulls below this are not strokes: the player did not mean to shoot.
inline constexpr double kLeastPull_m = 0.02;

/// The stroke on the board that a pull gives.
struct CueStroke {
  Vec2 u{0.0};        ///< γβ for a target at rest, in the board's axes: its momentum is m c u
  Vec3 towards{0.0};  ///< direction of u as a unit vector in the room's axes; 0 if there is no stroke
};

/// Returns a direction or distance on the board in the room's axes: by the rotation alone, without the boost.
Vec3 wayInRoom(const Vec3& wayOnBoard, const Lorentz& boardFromRoom);

/// Returns the stroke for a pull; its direction is opposite to the pull, along the cloth. With `d0_m`, the
/// pull is a draw against a force, of one unit of rapidity for each d0 (devices/force_law/cue_force.h);
/// without it, the momentum is in proportion to the pull. The direction is transformed from room to board by
/// the rotation of `boardFromRoom` alone, without its boost: the hand gives a momentum on the board, and a
/// viewer on a platform that is not rotated who points along the table means along the table at any platform
/// speed.
CueStroke strokeOf(const Vec3& pullInRoom_m, const Lorentz& boardFromRoom, double d0_m = 0.0);

/// The widest side spin of a hand, and what counts as the centre, as shares of the puck's radius.
inline constexpr double kMostSide = 0.5, kLeastSide = 0.125;

/// Returns how far to the right of the centre a stroke of `u` strikes where the hand pointed `asideInRoom_m`
/// beside the centre as it is seen: 0 near the centre, and at most kMostSide of the radius.
double sideOf(const Vec3& asideInRoom_m, const Vec2& u, const Lorentz& boardFromRoom, double radius_m);

/// What a cue can do at present, which decides the words for a press that takes no puck.
struct CueState {
  bool frozen = false;    ///< no stroke is possible: the viewer's time is frozen, or a lesson shows its game
  bool inLesson = false;  ///< a lesson shows its game
  bool isRinged = false;  ///< a ring marks the puck that a beginner is to strike
};

class Cue {
 public:
  /// The result of one frame.
  struct Outcome {
    std::optional<std::size_t> letGo;  ///< the puck that is struck, with the last `pull_m`
    texts::Saying refused;             ///< message to the player why the action was refused; empty if none
  };

  /// Advances the cue by one frame.
  Outcome step(const HandInput& hand, const PickResult& pointed, const CueState& state = {});

  /// Returns the puck that the cue is held for; it does not change until the cue is released.
  std::optional<std::size_t> target() const { return target_; }
  const Vec3& pull_m() const { return pull_m_; }
  double d0_m() const { return d0_m_; }  ///< as HandInput

 private:
  Outcome press(const HandInput& hand, const PickResult& pointed, const CueState& state);

  bool pressed_ = false;     ///< the button was down in the previous frame
  std::string_view device_;  ///< the device that holds the cue
  std::optional<std::size_t> target_;
  Vec3 pull_m_{0.0};
  double d0_m_ = 0.0;
};

}  // namespace carom
