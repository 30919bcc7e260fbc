#pragma once
// What the operator has chosen. Rank 0 has it; what other ranks must know of it travels in the frame record. Commands
// change it (app/operator/command.h), nothing else does.

#include <cstddef>
#include <string>

#include "cave/frame/frame_state.h"
#include "cave/frame/lesson_words.h"
#include "cave/frame/time_views.h"
#include "cave/frame/wall_controls.h"
#include "engine/light/switches.h"

namespace carom {

/// How a recorded game is gone through. A live game goes its own way.
struct Playback {
  bool paused = false;
  double rate = 1.0;  ///< seconds of the recording in one of the person's; below 0: backwards

  bool operator==(const Playback&) const = default;
};

struct OperatorSettings {
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
  bool keysShown = false;         ///< the list of keys is drawn over the walls of rank 0
  std::string playing;            ///< the scenario file that is played

  bool operator==(const OperatorSettings&) const = default;
};

/// Between 0 and this (metres) the eyes can be set apart.
inline constexpr double kMostEyeSeparation_m = 0.08;

/// Has the record's walls drawn as the settings say.
inline void putInto(FrameRecord& record, const OperatorSettings& settings) {
  record.switches = settings.switches;
  record.controls = settings.walls;
  record.views = settings.views;
}

/// Has the settings be as a recorded frame was drawn.
inline void takeFrom(const FrameRecord& record, OperatorSettings& settings) {
  settings.switches = record.switches;
  settings.walls = record.controls;
  settings.views = record.views;
  settings.lesson = record.lesson;
}

}  // namespace carom
