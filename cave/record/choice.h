#pragma once
// What a visitor can choose on the front wall.

#include <cstddef>
#include <cstdint>

#include "cave/record/frame_state.h"

namespace carom {

enum class Choice : std::uint8_t { play, lessons, showMe };
inline constexpr std::size_t kChoices = 3;

/// Returns whether a game that offers the choices offers them in this frame: not in a lesson before it
/// explains, and not while a stroke is drawn back or the platform is driven by hand.
inline bool offersChoicesNow(const SeenFrame& seen) {
  const FrameRecord& record = seen.record;
  const LessonPhase phase = record.lesson.phase;
  const bool isSteered = record.drive.mode != DriveMode::tour && record.drive.thrust != Vec3(0.0);
  return (phase == LessonPhase::none || phase == LessonPhase::explains) && !seen.self.hand.pulling &&
         !isSteered && !record.views.frozen;
}

}  // namespace carom
