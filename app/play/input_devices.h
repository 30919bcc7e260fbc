#pragma once
// The person's hands, whatever they hold: wand, mouse and gamepad hold the cue one at a time, and these, keys
// and a SpaceMouse steer the platform.
//
//   wand        points along its forward; button 0 holds the cue, the way from where it was pressed draws
//               it back; 1 brakes, 2 goes home, 3 goes on, the stick steers along where it points; while a
//               lesson asks, buttons 0 to 3 are its answers 1 to 4
//   mouse       points from the eye whose picture it is over; it draws the cue back as far as the place on
//               the cloth that it points to goes
//   gamepad     aims by looking: from between the eyes, forward; its right stick draws the cue back
//   SpaceMouse  steers right, up and forward; its left button brakes, its right one goes home
//
// Of those that hold nothing, who was used last aims: the mouse while it moves and for kPatience_s after, the
// gamepad while it is touched and so long after, else the wand. A mouse that only lies there aims at nothing.
// Who presses first holds the cue until it is let go.

#include <array>
#include <cstddef>
#include <optional>

#include "app/files/rig.h"
#include "app/hand/hand_input.h"
#include "app/input/desk.h"
#include "app/input/desk_input.h"
#include "app/viewer/hand_tracking.h"
#include "app/viewer/platform_motion.h"
#include "engine/spacetime/observer.h"

namespace carom {

class InputDevices {
 public:
  static constexpr double kPatience_s = 5.0;
  static constexpr double kPadPull_m = 0.45;  ///< at the end of the stick

  explicit InputDevices(const RoomAxes& axes) : axes_(axes) {}

  /// A frame begins: what the desk did since the one before. `asks`: a lesson waits for an answer; no hand
  /// takes the cue meanwhile.
  void begin(const DeskInput& desk, bool asks) {
    desk_ = desk;
    asks_ = asks;
  }

  /// Whoever holds the cue has it no more, until they press again.
  void letGo() { holder_.reset(); }

  // Of wand and SpaceMouse as they were told for the frame before.
  DriveWish drive() const;
  int answer() const;    ///< of a lesson, from 1; 0: none
  bool onwards() const;  ///< "go on" was asked for

  /// The hand with the cue, once the frame's head and trackers are known.
  HandInput cue(const HandDevices& devices, const ObserverView& observer, const Pose& roomFromHead,
                double now_s);

 private:
  static constexpr double kNever_s = -1.0e9;
  enum Device : std::size_t { wand, mouse, pad, kDevices };
  /// One device in this frame.
  struct Hand {
    bool there = false;  ///< it has a place to point from
    bool held = false;
    Vec3 from_m{0.0}, along{0.0};
    std::size_t eye = 2;
    Vec3 at_m{0.0};  ///< a pull is the way that this went since the button was pressed
    double used_s = kNever_s;
  };

  void steer(const HandDevices& devices);
  Hand wandHand(const HandDevices& devices, double now_s) const;
  Hand mouseHand(const ObserverView& observer, double now_s);
  Hand padHand(const ObserverView& observer, const Pose& roomFromHead, double now_s);
  void take(const std::array<Hand, kDevices>& hands, HandInput& input);
  std::optional<Device> aiming(const std::array<Hand, kDevices>& hands, double now_s) const;
  Vec3 level(const Vec3& way) const;

  RoomAxes axes_;
  DeskInput desk_;
  bool asks_ = false;
  Buttons wandButtons_, spaceMouseButtons_;
  bool wandKnown_ = false;
  Vec3 steered_{0.0};  ///< by wand and SpaceMouse, in the room's axes
  std::optional<Device> holder_;
  std::array<bool, kDevices> wasHeld_{};
  Vec3 pressed_m_{0.0};  ///< where the holder was
  std::optional<PointedWall> mouseWas_;
  Vec3 mouseAt_m_{0.0};  ///< where it last pointed to on the cloth's plane
  double mouseUsed_s_ = kNever_s, padUsed_s_ = kNever_s;
};

}  // namespace carom
