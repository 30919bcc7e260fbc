#pragma once
// Where the game's spacetime stands in the room, and in which frame it is shown.

#include <optional>
#include <string>
#include <vector>

#include "app/play/sculpture_hands.h"
#include "app/rig/rig.h"
#include "app/rig/rig_checks.h"
#include "app/scenario/scenario.h"
#include "cave/record/frame_state.h"

namespace carom {

class SculptureStand {
 public:
  /// With `before`, as in that frame of an earlier session.
  SculptureStand(const Rig& rig, const Scenario& scenario, const std::optional<FrameRecord>& before);

  /// Puts it into the record of a frame whose viewers are set. In the first frame it is placed.
  void putInto(FrameRecord& record);

  struct Touch {
    bool takes = false;  ///< the hand is the sculpture's
    Vec3 at_m{0.0};      ///< where the hand holds it, room frame
    texts::Saying said;  ///< to the viewer; empty if nothing
  };
  /// Lets a viewer's hand act on it, while it is shown.
  Touch touch(const HandInput& hand, std::size_t viewer, const World& world, FrameRecord& record);

 private:
  texts::Saying wordsOf(const SculptureHands::Outcome& outcome, std::size_t viewer, const World& world,
                        const FrameRecord& record) const;
  texts::Saying compare(const GameEvent& a, const GameEvent& b, std::size_t viewer,
                        const FrameRecord& record) const;

  SculptureHands hands_;
  double topOfPucks_m_ = 0.0;
  std::size_t sculpted_ = 0, left_ = 0;  // bodies that are shown, and that are not
  bool wasShown_ = false;
  std::vector<std::string> names_;  // of the viewers
  std::vector<std::string> flashes_;
  texts::Saying said_;  // while a hand holds it
  SculptureView view_;
  RoomAxes axes_;
  std::optional<Vec3> place_m_;  // of its foot, if that is told
  std::optional<RoomBox> box_;
  bool isPlaced_ = false;
};

/// Returns the pose of a sculpture that stands on the floor at a place of the room, turned as the board is.
Pose standingAt(const Vec3& foot_m, const RoomAxes& axes, const Lorentz& boardFromRoom);

}  // namespace carom
