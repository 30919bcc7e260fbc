#pragma once
// The latest message to the viewer in the room, with the time until it disappears.

#include <limits>

#include "cave/record/notice.h"

namespace carom {

/// Duration of a message, long enough to read it twice.
inline constexpr double kNoticeShown_s = 4.0;

class StatusMessage {
 public:
  /// Shows the message in the room from now on.
  void say(const texts::Saying& words, double now_s) {
    notice_ = Notice(words);
    until_s_ = now_s + kNoticeShown_s;
  }
  bool stands(double now_s) const { return now_s < until_s_; }
  Notice at(double now_s) const { return stands(now_s) ? notice_ : Notice(); }

 private:
  Notice notice_;
  double until_s_ = -std::numeric_limits<double>::infinity();
};

}  // namespace carom
