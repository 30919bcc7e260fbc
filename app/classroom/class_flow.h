#pragma once
// The course of a question in a class that answers by phone, as in peer instruction (E. Mazur 1997):
// everybody answers alone, then discusses, then answers again, and only then sees.
//
//   idle ─ask→ vote 1 ─close→ closed ─discuss→ discuss ─again→ vote 2 ─close→ closed ─show→ shown
//   shown ─explain→ explained ─next→ idle
//
// The teacher may leave out what a class does not need: shows without a vote or after the first one, and goes
// on to the next lesson from anywhere but an open vote. The lesson on the wall has keys and buttons of its
// own: when it moves, the class follows.

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "cave/record/class_view.h"
#include "cave/record/lesson_words.h"

namespace carom {

/// What the teacher commands.
enum class ClassStep : std::uint8_t { ask, close, discuss, again, show, explain, next };
inline constexpr std::array<const char*, 7> kClassSteps{"ask",  "close",   "discuss", "again",
                                                        "show", "explain", "next"};

/// Returns the step of this name, or none.
std::optional<ClassStep> classStepNamed(std::string_view name);

class ClassFlow {
 public:
  ClassPhase phase() const { return phase_; }
  /// Returns the number of the present or latest vote, 1 or 2; 0: none so far.
  int round() const { return round_; }
  bool isOpen() const { return phase_ == ClassPhase::vote; }

  /// Returns whether the step is possible now.
  bool may(ClassStep step) const { return after(step).has_value(); }
  /// Takes the step if it is possible; returns whether it was.
  bool take(ClassStep step);

  /// Follows the lesson on the wall, which somebody has moved with its own keys.
  void follow(LessonPhase lesson);
  /// Begins another question.
  void begin() { *this = {}; }
  /// Goes on where a session broke off.
  void resume(ClassPhase phase, int round) {
    phase_ = phase;
    round_ = round;
  }

 private:
  std::optional<ClassPhase> after(ClassStep step) const;

  ClassPhase phase_ = ClassPhase::idle;
  int round_ = 0;
};

}  // namespace carom
