#pragma once
// All input devices of the players. Wand, mouse and gamepad hold the cue one at a time; wand, gamepad, keys
// and SpaceMouse steer the platform.
//
//   wand        aims along its forward axis; button 0 holds the cue, and the wand's displacement since the
//               press draws it back; button 1 brakes, 2 goes home, 3 goes on; the stick steers along the
//               direction of the wand; while a lesson asks, buttons 0 to 3 are its answers 1 to 4
//   mouse       aims from the eye whose picture it is over; the cue is drawn back by the displacement of the
//               point on the cloth that the mouse points to; its right button takes hold of the scene and
//               turns the room about the head
//   gamepad     aims with the head: from between the eyes, forward; its right stick draws the cue back; its
//               cross goes through the buttons of the front wall
//   SpaceMouse  steers right, up and forward; its left button brakes, its right one goes home
//
// While no device holds the cue, the one used last aims: the mouse while it moves and for kPatience_s after,
// the gamepad while it is used and for kPatience_s after, otherwise the wand. An idle mouse does not aim. The
// first device pressed owns the cue until it is released.

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "app/hand/hand_input.h"
#include "app/input/desk_controls.h"
#include "app/input/desk_input.h"
#include "app/operator/command.h"
#include "app/rig/rig.h"
#include "app/viewer/hand_tracking.h"
#include "app/viewer/platform_motion.h"
#include "engine/spacetime/observer.h"

namespace carom {

class InputDevices {
 public:
  static constexpr double kPatience_s = 5.0;
  static constexpr double kPadPull_m = 0.45;  ///< with the stick at its limit

  explicit InputDevices(const RoomAxes& axes) : axes_(axes) {}

  /// Starts a frame with the desktop input since the previous one. While `asks`, a lesson waits for an answer
  /// and no device can take the cue.
  void begin(const DeskInput& desk, bool asks) {
    desk_ = desk;
    desk_.home = desk_.home || std::exchange(goesHome_, false);
    asks_ = asks;
  }

  /// Releases the cue, whichever device holds it, until a button is pressed again.
  void letGo() { holder_.reset(); }

  /// Asks for the way home in the next frame.
  void goHome() { goesHome_ = true; }

  // Returns the platform input; wand and SpaceMouse are as received for the previous frame.
  DriveWish drive() const;
  /// Returns the lesson command given by the wand's buttons, if any.
  std::optional<Command> lessonCommand() const;

  /// Returns the input of the hand that has the cue, once the frame's head and trackers are known.
  HandInput cue(const HandDevices& devices, const ObserverView& observer, const Pose& roomFromHead,
                double now_s);

 private:
  static constexpr double kNever_s = -1.0e9;
  enum Device : std::size_t { wand, mouse, pad, kDevices };
  /// The state of one device in this frame.
  struct Hand {
    bool there = false;  ///< it has a position to point from
    bool held = false;
    bool down = false;  ///< its button is down, even if that means something else
    Vec3 from_m{0.0}, along{0.0};
    Eye eye = Eye::middle;
    Vec3 at_m{0.0};  ///< the pull is the displacement of this point since the button was pressed
    double used_s = kNever_s;
  };

  void steer(const HandDevices& devices);
  Hand wandHand(const HandDevices& devices, double now_s) const;
  Hand mouseHand(const ObserverView& observer, double now_s);
  Hand padHand(const ObserverView& observer, const Pose& roomFromHead, double now_s);
  void turn(const Hand& hand);
  void take(const std::array<Hand, kDevices>& hands, HandInput& input);
  std::optional<Device> aiming(const std::array<Hand, kDevices>& hands, double now_s) const;
  Vec3 level(const Vec3& way) const;

  RoomAxes axes_;
  DeskInput desk_;
  bool asks_ = false, goesHome_ = false;
  Buttons wandButtons_, spaceMouseButtons_;
  bool wandKnown_ = false;
  Vec3 steered_{0.0};            ///< from wand and SpaceMouse, in the room's axes
  std::optional<Vec3> grabbed_;  ///< horizontal direction of the mouse while it turns the room
  double turn_rad_ = 0.0;        ///< of the room about the vertical, in the next frame
  std::optional<Device> holder_;
  std::array<bool, kDevices> wasHeld_{}, wasDown_{};
  Vec3 pressed_m_{0.0};  ///< position of the holder at the time of pressing
  struct Mouse {
    std::optional<PointedWall> was;
    Vec3 at_m{0.0};  ///< last position it pointed to in the plane of the cloth
    double used_s = kNever_s;
  };
  Mouse mouse_;
  double padUsed_s_ = kNever_s;
};

}  // namespace carom
