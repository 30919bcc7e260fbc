#pragma once
// The cue in the person's hand: aimed, held, drawn back, let go.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "app/hand/hand_input.h"
#include "app/hand/ray_picking.h"
#include "engine/billiard/game_event.h"
#include "engine/spacetime/lorentz.h"

namespace carom {

/// A cue that is drawn back so far gives u = 1: the rest momentum m c, √2 m c² with the puck's own energy.
inline constexpr double kPullForOne_m = 0.15;
/// A hand that lets go of what it has not drawn back any further did not mean to shoot.
inline constexpr double kLeastPull_m = 0.02;

/// What a pull means on the board.
struct CueStroke {
  Vec2 u{0.0};        ///< γβ for a target at rest, in the board's axes: its momentum is m c u
  Vec3 towards{0.0};  ///< the way of it, as a unit vector of the room's axes; 0 for no stroke
};

/// The stroke is the other way round than the pull, along the cloth. A direction is taken from the room to
/// the board by the turn of `boardFromRoom` alone, without its boost: what the hand gives is a momentum on
/// the board, and a person on a platform that is not turned and points along the table means along the table,
/// however fast they go by.
CueStroke strokeOf(const Vec3& pullInRoom_m, const Lorentz& boardFromRoom);

class Cue {
 public:
  /// What becomes of a frame.
  struct Outcome {
    std::optional<std::size_t> letGo;  ///< the puck that is struck, with the pull as it was last
    std::string refused;               ///< what was wanted and cannot be, for the person; empty: nothing
  };

  /// `frozen`: the person's time stands still, and nothing can be done in it.
  Outcome step(const HandInput& hand, const PickResult& pointed, bool frozen);

  /// The puck that the cue is held for: the same until it is let go.
  std::optional<std::size_t> target() const { return target_; }
  const Vec3& pull_m() const { return pull_m_; }

 private:
  Outcome press(const HandInput& hand, const PickResult& pointed, bool frozen);

  bool pressed_ = false;     ///< the button was down in the frame before
  std::string_view device_;  ///< that holds the cue
  std::optional<std::size_t> target_;
  Vec3 pull_m_{0.0};
};

}  // namespace carom
