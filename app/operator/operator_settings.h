#pragma once
// The operator's settings. Rank 0 holds them; what other ranks need travels in the frame record. Only
// commands (app/operator/command.h) change them; a replay also takes over the recorded ones.

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "app/file_keys/session_languages.h"
#include "app/scenario/playlist.h"
#include "cave/record/frame_state.h"
#include "cave/record/lesson_words.h"
#include "cave/record/time_views.h"
#include "cave/record/wall_controls.h"
#include "engine/light/switches.h"

namespace carom {

/// How a recorded game is played back. Has no effect on a live game.
struct Playback {
  bool paused = false;
  double rate = 1.0;  ///< seconds of the recording per second of the viewer; negative plays backwards

  bool operator==(const Playback&) const = default;
};

/// The operator's console on rank 0: its window may wait out of sight where the screen is too small for it.
enum class ConsoleState : std::uint8_t { none, waits, shown };

struct OperatorSettings {
  Switches switches;
  WallControls walls;
  TimeViews views;
  double eyeSeparation_m = 0.064;
  /// The speed of light in the viewer's units. A change keeps all positions and light paths, so nothing
  /// jumps: pucks keep their β, and only the number of game seconds per second of the viewer changes, to this
  /// value divided by the scenario's light speed. Board clocks keep counting game seconds.
  double lightSpeed_m_s = 1.42;
  Playback playback;
  LessonState lesson;
  std::size_t lessonAnswers = 0;       ///< number of answers to its question
  std::size_t lessonObservers = 0;     ///< number of velocities that it offers
  std::size_t lessonObserver = 0;      ///< the velocity that was chosen
  std::size_t lessonExplainedFor = 0;  ///< the velocity with which it explains
  TimeViews lessonExplains;            ///< views that are on while it explains
  /// Effects that it offers to turn off, by their places in kNamedSwitches, and what they were at first.
  std::vector<std::pair<std::uint8_t, std::uint8_t>> lessonEffects;
  std::size_t task = 0;  ///< which task of the game, from 0
  /// The least energy with which each task was done in this session, by scenario file and number.
  std::map<std::pair<std::string, std::size_t>, double> bestOfTask_j;
  bool canWalk = true;  ///< somebody's head is followed, or there are several people
  ConsoleState console = ConsoleState::none;
  bool keysShown = false;                             ///< the list of keys is drawn over the walls of rank 0
  std::string playing;                                ///< scenario file being played
  std::shared_ptr<const Playlist> playlist;           ///< the games that may be played; null: all
  std::shared_ptr<const SessionLanguages> languages;  ///< those of the session; null: English alone
  std::array<std::uint8_t, kMostViewers> languageOf{};  ///< which of them each viewer reads
  std::string lastLesson;  ///< file of the lesson that this visitor saw last; empty: none so far

  bool operator==(const OperatorSettings&) const = default;
};

/// Largest eye separation in metres; the smallest is 0.
inline constexpr double kMostEyeSeparation_m = 0.08;

/// Copies the settings for the walls into the record. Without the session's languages, as in a replay, the
/// record keeps the tile for them that it has.
inline void putInto(FrameRecord& record, const OperatorSettings& settings) {
  record.switches = settings.switches;
  record.controls = settings.walls;
  record.views = settings.views;
  for (std::size_t viewer = 0; viewer < kMostViewers; ++viewer)
    record.viewers[viewer].language = settings.languageOf[viewer];
  if (!settings.languages) return;
  const std::size_t onTile = settings.languages->hasTile ? settings.languages->all.size() : 0;
  record.languagesOnTile = static_cast<std::uint8_t>(onTile);
}

/// Copies the settings of a recorded frame into `settings`.
inline void takeFrom(const FrameRecord& record, OperatorSettings& settings) {
  settings.switches = record.switches;
  settings.walls = record.controls;
  settings.views = record.views;
  settings.lesson = record.lesson;
  for (std::size_t viewer = 0; viewer < kMostViewers; ++viewer)
    settings.languageOf[viewer] = record.viewers[viewer].language;
}

}  // namespace carom
