#pragma once
// The hand's interaction with the game: what it aims at, its strokes, and the messages about them.

#include <optional>
#include <string>

#include "app/hand/cue.h"
#include "app/hand/hand_input.h"
#include "app/hand/ray_picking.h"
#include "app/play/game.h"
#include "app/scenario/scenario.h"
#include "cave/record/frame_state.h"
#include "engine/linked/own_room.h"

namespace carom {

/// Returns the board event at which a hand acts: the hand's position in the room at the head's time there, or
/// later if an eye of any viewer has already received light from there (the eyes are simultaneous for their
/// head, which may move in the room): then the last event there whose light an eye has received. So no event
/// that any eye has seen lies in its future. The hand is that of the viewer who sees the frame.
Event handEvent(const Vec3& handInRoom_m, const SeenFrame& seen);

class CueInteraction {
 public:
  static constexpr double kRing_m =
      0.12;  ///< least radius of the ring, as it is drawn (cave/overlay/cue_overlay.h)

  /// `scenario` must outlive this object.
  explicit CueInteraction(const Scenario& scenario) : scenario_(&scenario) {}

  struct Outcome {
    std::optional<Stroke> stroke;  ///< accepted by the game
    double arrives_s = 0.0;        ///< board time at which the stroke reaches the puck
    texts::Saying said;            ///< message to the viewer; empty if none
    bool isPutOff = false;         ///< later than the hand, to keep a promise
  };

  /// Processes one frame for the hand of a viewer. Must be called after the record has its observer, switches
  /// and light speed, and before the game's knots of this frame are taken. Fills the viewer's hand in it, and
  /// strikes the puck when a stroke is released. `still` means that the viewer's time is frozen.
  /// `promises`: of linked rooms, which a stroke is put off to keep; null: there are none.
  Outcome step(const HandInput& hand, bool still, Game& game, FrameRecord& record, std::size_t viewer = 0,
               const OwnRoom* promises = nullptr);

  /// Rings a puck that the viewer may strike, in the record, unless the hand points to one. In the next frame
  /// a press anywhere within the ring takes it.
  void offer(std::size_t puck, const Game& game, FrameRecord& record, std::size_t viewer = 0);

 private:
  /// Returns how far to the right of the target's centre a stroke of `u` strikes; 0 where the target is round
  /// and all rims are smooth, so that a spin would show nowhere.
  double offset_m(const Vec2& u, std::size_t target, const Lorentz& boardFromRoom) const;
  bool isInRing(std::size_t puck, const HandInput& hand, const Game& game, const SeenFrame& seen);
  HandView viewOf(const HandInput& hand, const PickResult& pointed, const Game& game, const SeenFrame& seen);
  Outcome strike(std::size_t puck, const HandInput& hand, Game& game, const SeenFrame& seen,
                 const OwnRoom* promises) const;

  const Scenario* scenario_;
  RayPicking aim_;
  Cue cue_;
  std::optional<std::size_t> ringed_;  ///< in the frame before
  Vec3 aside_m_{0.0};  ///< where the hand pointed when it took the target, from its centre; room
};

}  // namespace carom
