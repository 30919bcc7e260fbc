#pragma once
// Escape and Q end a session only when they are pressed twice: the first press puts a question over every
// window of this computer, with a button for the mouse. Any other key, or ten seconds, take it back. A
// window's close button needs no question.

#include <chrono>
#include <optional>

#include "cave/gl/graphics.h"

namespace carom {

class EndQuestion {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kStands{10};

  /// Takes the input of a frame. Returns whether the session is to end.
  bool take(const WindowInput& input, Clock::time_point now = Clock::now());

  bool isAsked() const { return asked_.has_value(); }

  /// Draws the question, within a Gui, in the middle of its window.
  void draw();

 private:
  void take(const KeyInput& key, Clock::time_point now);

  std::optional<Clock::time_point> asked_;
  bool ends_ = false;
};

}  // namespace carom
