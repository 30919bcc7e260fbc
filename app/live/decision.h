#pragma once
// Rank 0's decision about one frame: the record that every rank draws, and the report about the frame.

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "app/journal_rows/journal_news.h"
#include "app/operator/command.h"
#include "cave/record/frame_state.h"
#include "devices/filter/head_filter.h"
#include "devices/tracker/tracker.h"
#include "engine/billiard/billiard.h"

namespace carom {

/// Timing of one decision. Unknown values are NaN.
struct DecisionTiming {
  /// Age of the newest head sample at its start.
  double sampleAge_s = std::numeric_limits<double>::quiet_NaN();
  double took_s = std::numeric_limits<double>::quiet_NaN();  ///< without the wait for the frame's start
};

/// Name and value of something that happened, such as "aberration" and "off".
struct Note {
  std::string what, value;
  std::size_t viewer = 0;
};

/// A command that a viewer's hand device has given.
struct HandCommand {
  Command command;
  std::size_t viewer = 0;
};

/// The answer that a visitor gave to a lesson's question.
struct LessonAnswer {
  std::string lesson, question, answer;
  std::size_t viewer = 0;
};

struct Decision {
  FrameState frame;
  std::vector<Note> inputs;                      ///< commands that take effect with this frame
  std::vector<Note> notes;                       ///< other events: the drive's mode, messages in the room
  std::vector<LessonAnswer> answers;             ///< answers to a lesson's question
  std::vector<ClassVote> votes;                  ///< of phones, in a vote that was closed
  std::vector<HandStroke> strokes;               ///< strokes made by hand
  std::vector<TaskNews> tasks;                   ///< what happened to the task
  LinkNews link;                                 ///< of another room
  std::array<HeadEstimate, kMostViewers> heads;  ///< of each viewer; live sessions only
  /// The head trackers' samples for this frame, valid until the next decision; live sessions only.
  std::vector<TrackerSamples> samples;
  std::vector<std::string> alarms;  ///< tracker failures and recoveries, for the terminal
  Commands commands;                ///< from captions and programmes; they take effect with the next frame,
  std::vector<HandCommand> handCommands;  ///< and so do these, from hand devices
  bool isHandled = false;  ///< the person uses a device of the hand: it steers, brakes, turns or presses
  bool showsShot = false;  ///< the best shot is shown again
  bool keepsShot = false;  ///< this frame shows its end, which is kept as a picture
  double stay_s = 0.0;     ///< recorded sessions: time between the previous frame and this one
  DecisionTiming timing;

  /// Clears everything reported about the previous frame. Keeps the frame and all allocated memory.
  void beginFrame() {
    inputs.clear();
    notes.clear();
    answers.clear();
    votes.clear();
    strokes.clear();
    tasks.clear();
    link.clear();
    alarms.clear();
    commands.clear();
    handCommands.clear();
    isHandled = showsShot = keepsShot = false;
    samples.clear();
    stay_s = 0.0;
    timing = {};
  }
};

}  // namespace carom
