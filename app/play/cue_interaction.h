#pragma once
// What a hand does to the game: what it aims at, the strokes it lets go, what is said of them.

#include <optional>
#include <string>

#include "app/files/scenario.h"
#include "app/hand/cue.h"
#include "app/hand/hand_input.h"
#include "app/hand/ray_picking.h"
#include "app/play/game.h"
#include "cave/frame/frame_state.h"

namespace carom {

/// The board event at which a hand acts: where it is in the room at the head's moment there; at the earliest
/// when no eye has yet received light from it (eyes are simultaneous for the head, which may move in the
/// room). So nothing that any eye has seen lies in the future of it.
Event handEvent(const Vec3& handInRoom_m, const ObserverView& observer, const Lorentz& boardFromRoom);

class CueInteraction {
 public:
  /// The scenario is used as long as this lives.
  explicit CueInteraction(const Scenario& scenario) : scenario_(&scenario) {}

  struct Outcome {
    std::optional<Stroke> stroke;  ///< that the game has taken
    std::string said;              ///< to the person; empty: nothing
  };

  /// One frame: after the record has its observer, its switches and its light speed, before the game's knots
  /// of this frame are taken. Fills record.hand; strikes the game where a stroke is let go. `still`: the
  /// person's time stands still.
  Outcome step(const HandInput& hand, bool still, Game& game, FrameRecord& record);

 private:
  HandView viewOf(const HandInput& hand, const PickResult& pointed, const Game& game,
                  const FrameRecord& record);
  Outcome strike(std::size_t puck, const HandInput& hand, Game& game, const FrameRecord& record) const;

  const Scenario* scenario_;
  RayPicking aim_;
  Cue cue_;
};

}  // namespace carom
