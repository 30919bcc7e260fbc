#pragma once
// Tells players who try to change a recording that it cannot be changed.

#include "app/input/desk_input.h"
#include "app/live/status_message.h"
#include "cave/texts/texts.h"
#include "engine/text/log.h"

namespace carom {

class ReadOnlyNotice {
 public:
  void handled(const DeskInput& desk, double now_s) {
    const bool strikes = (desk.mouse && desk.mouseHeld) || desk.padHeld;
    const bool touched = strikes || desk.brake || desk.home || desk.steer != Vec3(0.0);
    if (touched && !touched_) {
      log::note(texts::message::kReadOnly.english());
      message_.say(texts::message::kReadOnly, now_s);
    }
    touched_ = touched;
  }
  /// Replaces the frame's own message while the notice is shown.
  void tell(double now_s, Notice& notice) const {
    if (message_.stands(now_s)) notice = message_.at(now_s);
  }

 private:
  StatusMessage message_;
  bool touched_ = false;  ///< in the previous frame
};

}  // namespace carom
