#pragma once
// What a viewer's hand finds on the front wall: the buttons as the viewer sees them, and those that a gamepad
// goes through with its cross, since it points to nothing.

#include <cstddef>
#include <optional>
#include <vector>

#include "app/hand/hand_input.h"
#include "app/scenario/scenario.h"
#include "cave/hud/hud_text.h"
#include "cave/overlay/wall_buttons.h"
#include "cave/room/room_geometry.h"

namespace carom {

class WallPresses {
 public:
  /// `room` as the viewer sees it.
  explicit WallPresses(const RoomGeometry& room);

  /// Begins another game.
  void play(const Scenario& scenario);

  /// Takes the frame as the viewer sees it.
  void follow(const SeenFrame& shown);

  /// Goes on by this number of buttons from the one that the gamepad has chosen, and points the gamepad's
  /// hand there.
  void aimPad(int steps, HandInput& hand);

  /// Returns the button to which the hand points, unless it holds the cue. A press takes the gamepad's choice
  /// back.
  std::optional<PointedButton> at(const HandInput& hand);

 private:
  RoomGeometry room_;
  std::optional<Wall> front_;
  HudText text_;
  GameOffers offers_;
  std::vector<WallButton> band_, buttons_, before_;  ///< the band's; all; all in the frame before
  std::optional<std::size_t> chosen_;                ///< by the gamepad
};

}  // namespace carom
