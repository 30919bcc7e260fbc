#pragma once
// Hands that would change a recording are told that they cannot.

#include "app/input/desk_input.h"
#include "app/session/spoken.h"

namespace carom {

class HandsOff {
 public:
  void handled(const DeskInput& desk, double now_s) {
    const bool strikes = (desk.mouse && desk.mouseHeld) || desk.padHeld;
    const bool touched = strikes || desk.brake || desk.home || desk.steer != Vec3(0.0);
    if (touched && !touched_)
      spoken_.say("A recording cannot be changed: strokes and drive need a live game", now_s);
    touched_ = touched;
  }
  /// In place of what a frame says itself, while they are told.
  void tell(double now_s, Notice& notice) const {
    if (spoken_.stands(now_s)) notice = spoken_.at(now_s);
  }

 private:
  Spoken spoken_;
  bool touched_ = false;  ///< in the frame before
};

}  // namespace carom
