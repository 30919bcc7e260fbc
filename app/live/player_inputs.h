#pragma once
// The devices of all players: each one's hand, the desk that belongs to one of them at a time, who steers,
// and the buttons that each finds on the front wall.

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "app/live/decision.h"
#include "app/live/wall_presses.h"
#include "app/play/hand_force.h"
#include "app/play/input_devices.h"
#include "app/play/mouse_people.h"
#include "app/rig/rig.h"
#include "app/scenario/scenario.h"
#include "app/viewer/viewers.h"
#include "devices/usb/rumble.h"

namespace carom {

class PlayerInputs {
 public:
  /// The session's clock reads zero at `sessionStart`.
  explicit PlayerInputs(const Rig& rig, std::chrono::steady_clock::time_point sessionStart = {});
  ~PlayerInputs();  ///< leaves force devices at 0 N

  /// Returns the rig's trackers, or those people whom mouse and keys move.
  SharedTrackers trackers(const Rig& rig, std::chrono::steady_clock::time_point sessionStart) const;

  /// Begins another game.
  void play(const Scenario& scenario);

  /// Takes the frame that is shown, on whose front wall the hands will find buttons.
  void follow(const FrameRecord& shown);

  /// Gives the desk's input to the viewer over whose walls the mouse is, and settles who steers: the first
  /// who wishes it. `asks`: a lesson waits for an answer, and no device can take the cue. Returns what they
  /// ask of the drive; its thrust sets in softly and ends at once.
  DriveWish take(const DeskInput& desk, bool asks, const FrameTimes& times);

  /// What a hand does in a frame.
  struct Act {
    HandInput hand;
    std::optional<PointedButton> pointed;  ///< the button on the front wall that it points to
    std::optional<Command> command;        ///< of the wand's buttons, in a lesson
  };
  /// Returns what a viewer's hand does, once the frame's heads and trackers are known.
  Act act(std::size_t viewer, const Viewers& viewers, const ObserverView& observer, double now_s);

  /// Lets go of the cue, as for a press on a button of the front wall; with `home`, asks for the way home.
  void letGo(std::size_t viewer, bool home);

  /// Lets hands feel: a gamepad trembles as it draws the cue back, and knocks with the stroke; a force device
  /// gets what holds now. `holding`: the puck that a lesson lets a hand hold.
  void feel(std::size_t viewer, const Viewers& viewers, const HandInput& hand, bool struck,
            const std::optional<HandForce::Holding>& holding, FrameRecord& record);
  /// Returns the force device of a viewer's hand, or null.
  HandForce* force(std::size_t viewer) { return forces_[viewer].get(); }
  /// Leaves the force devices at 0 N at the end of a session. Returns why those that pushed do so no longer.
  std::vector<Note> endForces();

  std::size_t steering() const { return steering_; }  ///< the viewer who steered last
  /// Returns whether the one who steered last asks for something.
  bool asksToSteer() const { return asksForAnything(hands_[steering_].drive()); }

 private:
  std::unique_ptr<MousePeople> people_;  ///< of a dry run
  std::vector<InputDevices> hands_;      ///< of each viewer
  std::vector<WallPresses> presses_;     ///< of each viewer
  std::size_t atDesk_ = 0;  ///< the viewer to whom mouse and keys belong: over whose walls the mouse was last
  int padStep_ = 0;         ///< by which the gamepad goes on among the buttons of the front wall
  std::size_t steering_ = 0;
  double onset_ = 0.0;  ///< share of the steered thrust
  Rumble rumble_;
  std::vector<std::unique_ptr<HandForce>> forces_;  ///< of each viewer; null without a device
};

}  // namespace carom
