#pragma once
// What the operator has chosen: by keys (app/input/keys.h), by the command line. Rank 0's; what others must
// know of it travels in the frame record.

#include <cstddef>
#include <string>
#include <vector>

#include "cave/frame/lesson_words.h"
#include "cave/frame/time_views.h"
#include "cave/frame/wall_controls.h"
#include "engine/light/switches.h"

namespace carom {

/// How a recorded game is gone through. Live, time goes its own way.
struct Playback {
  bool paused = false;
  double rate = 1.0;  ///< seconds of the recording in one of the person's; below 0: backwards
  /// Counts up with every wish to be elsewhere; `goTo_s` is then the session's time to go on from.
  unsigned jumps = 0;
  double goTo_s = 0.0;

  bool operator==(const Playback&) const = default;
};

struct Controls {
  Switches switches;
  WallControls walls;
  TimeViews views;
  double eyeSeparation_m = 0.064;
  /// Light's speed for the person. A change leaves every place and every length of light's way as it is, so
  /// nothing jumps: pucks keep their β, and what changes is how many of the game's seconds go by in one of
  /// the person's, this ÷ the scenario's light speed. Board clocks go on counting the game's.
  double lightSpeed_m_s = 1.42;
  Playback playback;
  LessonState lesson;
  std::size_t lessonAnswers = 0;  ///< how many its question offers
  unsigned tours = 0;             ///< counts up with every wish to set out on the scenario's own drive
  std::string playing;            ///< the scenario file that is played
  std::string play;  ///< the one to go on with instead; the same: from its beginning; empty: none

  bool operator==(const Controls&) const = default;
};

/// Between 0 and this (metres) the eyes can be set apart.
inline constexpr double kMostEyeSeparation_m = 0.08;

/// One thing that was changed, in words: "aberration", "off".
struct ControlChange {
  std::string what;
  std::string value;
};

/// What is different in `after`.
std::vector<ControlChange> changesOf(const Controls& before, const Controls& after);

}  // namespace carom
