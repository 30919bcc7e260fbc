#pragma once
// What rank 0 has decided for one frame: the record that every rank draws, and what there is to tell of it.

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "app/operator/command.h"
#include "cave/frame/frame_state.h"
#include "devices/filter/head_filter.h"
#include "devices/tracker/tracker.h"
#include "engine/billiard/billiard.h"

namespace carom {

/// What a decision took. What is not known is NaN.
struct DecisionTiming {
  double sampleAge_s = std::numeric_limits<double>::quiet_NaN();  ///< of the head's newest, when it began
  double took_s = std::numeric_limits<double>::quiet_NaN();       ///< without the wait for its beginning
};

/// Something that was done, in words: "aberration", "off".
struct Note {
  std::string what, value;
};

/// What a visitor answered.
struct LessonAnswer {
  std::string lesson, question, answer;
};

struct Decision {
  FrameState frame;
  std::vector<Note> inputs;           ///< what was commanded: it holds from this frame on
  std::vector<Note> notes;            ///< what else happened: how the platform is driven, what was said
  std::vector<LessonAnswer> answers;  ///< to a lesson's question
  std::vector<Stroke> strokes;        ///< of hands
  HeadEstimate head;                  ///< of a live session, and
  std::span<const TrackerSample>
      samples;                      ///< what its tracker delivered for this frame; until the next decision
  std::vector<std::string> alarms;  ///< that trackers fail or are well again, for the terminal
  Commands commands;                ///< by buttons of hands: they hold from the next frame on
  double stay_s = 0.0;              ///< of a recorded session: how long after the frame before this one comes
  DecisionTiming timing;

  /// Forgets what was told of the frame before. The frame and all memory stay.
  void beginFrame() {
    inputs.clear();
    notes.clear();
    answers.clear();
    strokes.clear();
    alarms.clear();
    commands.clear();
    samples = {};
    stay_s = 0.0;
    timing = {};
  }
};

}  // namespace carom
