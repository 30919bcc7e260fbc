#pragma once
// A session's journal: one SQLite file with all that was shown, known and done, readable with plain SQL.
//
// Tables (times of the session's clock in seconds, board coordinates in seconds and metres):
//   session(key, value)
//       What was played: program, rig and scenario with their texts, light speed, start (UTC); once it was
//       closed well, its end.
//   frame(number, display_s, proper_time_s, t_s, x_m, y_m, z_m, switches, views, beside, truncate_from_s, …,
//         known, celerity_x_m_s …)
//       One row a frame: the fields of its record (cave/frame/frame_state.h), a column each
//       (app/journal/frame_columns.h), and how the head was known. t_s … z_m: the event at which the point
//       between the eyes received the frame's light. switches: a bit each, retardation 1, contraction 2,
//       aberration 4, colour 8, searchlight 16; beside: the same of the right half where views has split.
//       views: now on the board 1, my now 2, paths 4, events 8, clocks 16, split 32, frozen 64, ruler 128,
//       angles 256.
//   knot(frame, body, t_s, x_m, y_m, z_m, u_x, u_y, u_z, proper_time_s, signal_t_s …, deceleration_m_s2)
//       Legs that a frame brought; u = γβ. signal_t_s …: the event whose light makes the body's points turn.
//       Bodies count as in the scenario: 0 the board, then the pucks, then what is told.
//   frame_event(frame, number, kind, cushion, which, t_s, x_m, y_m, z_m, without_delay, heat_j, turns, …)
//       What a frame brought to the list of events (engine/billiard/game_event.h), with its turns, of which
//       there are `turns`. kind counts as EventKind, cushion as Cushion, but from 1: 0 is none. What a stroke
//       later took back stays here: so it was shown.
//   event(number, kind, pucks, cushion, t_s, x_m, y_m, z_m, heat_j, without_delay)
//       What happened, as it is in the end: rows that a stroke took back are gone. Numbers are in the order
//       in which the game decided. kind: puck-puck, puck-cushion, stroke, flash, jam. pucks: names, with
//       commas between. t_s … z_m: the contact, the hand's stroke, the flash. without_delay: 1 where the
//       contact was there already and the kick did not wait for its news (engine/billiard/game_event.h), else
//       0. The game is known a little further than it was seen.
//   turn(event, puck, t_s, x_m, y_m, z_m, beta_before_x, beta_before_y, beta_after_x, beta_after_y,
//   proper_time_s)
//       How each puck of an event turned, by its name; proper time on its own clock.
//   stroke(frame, puck, at_s, from_x_m, from_y_m, from_z_m, p_x_kg_m_s, p_y_kg_m_s)
//       What hands have struck in a frame: the event of the hand, by the puck's name the momentum that
//       arrives there. With the scenario's they are all strokes of the game, in the order in which it counts
//       them.
//   input(frame, what, value)
//       What the operator and the hands did, in words: it holds from this frame on.
//   answer(frame, lesson, question, answer)
//       What a visitor answered.
//   run(first_frame, started_utc, program)
//       Each run of the program that wrote here: the first, and one whenever the session was gone on with.
//   sample(time_s, sensor, x_m, y_m, z_m, qw, qx, qy, qz)
//       What the tracker of the head delivered.
//   latency(display_s, frame, node, part, frames, median_s, p99_s, most_s, jitter_s)
//       Of a session in real time, once a second for each node and part of a frame
//       (cave/frame/frame_timing.h): statistics over the last second's frames, of which `frame` is the
//       newest. `late` is what an interval between swaps was longer than the display's period. Some 100 bytes
//       a row, at most eight rows a node and second.
// In frame, knot and frame_event numbers are kept bit for bit: a zero as a whole number, NaN as NULL.
// `PRAGMA user_version` is the version of this list. Of version 3, which kept records byte by byte, files are
// read, and become files of this version when they are gone on with.

#include <chrono>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/journal/session_facts.h"
#include "cave/frame/frame_state.h"
#include "cave/frame/frame_timing.h"
#include "devices/filter/head_filter.h"
#include "devices/tracker/tracker.h"
#include "engine/billiard/billiard.h"

namespace carom {

/// How often what was written goes into the session file itself; meanwhile it is in FILE-wal, beside it.
inline constexpr std::chrono::milliseconds kIntoFileEvery{20000};

/// Written by a thread of its own, one transaction a batch of frames, so that a frame only copies its rows.
/// What has been handed over is on its way at once: a killed program lacks two frames at the most. When the
/// disk is full, or the file cannot be written for another reason, the session goes on: the log tells it
/// once, rows wait and are written when it works again, which it tells, too. Of frames ten minutes wait:
/// the file then ends before the first that is lost, for good, as later ones would build on it. Of a killed
/// program's file, copied without the FILE-wal beside it, no more than the last `intoFileEvery` is missing,
/// unless it was killed in the few milliseconds of bringing the file up to date: that copy needs its FILE-
/// wal.
class Journal {
 public:
  /// Makes the file, or with `goOn` goes on with the one that is there. Throws std::runtime_error if there is
  /// one already, or none to go on with, if the folder cannot be written, or if another session writes to it.
  Journal(const std::filesystem::path& file, const SessionFacts& facts, bool goOn,
          std::chrono::milliseconds intoFileEvery = kIntoFileEvery);
  ~Journal();  ///< closes it
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Writes what is left; the file is one whole again. What is added later is not written. From any thread,
  /// also while another adds or closes.
  void close();

  /// One frame: what was drawn, how the head was known, what the tracker had delivered for it, what hands
  /// struck. Waits for nothing.
  void add(const FrameState& state, const HeadEstimate& head, std::span<const TrackerSample> samples,
           std::span<const Stroke> strokes = {});

  /// What the operator or a hand did, to hold from a frame on.
  void addInput(std::uint64_t frame, const std::string& what, const std::string& value);
  void addAnswer(std::uint64_t frame, const std::string& lesson, const std::string& question,
                 const std::string& answer);

  /// Where the nodes' time went; written with the next frame.
  void add(std::span<const LatencyRow> rows);

 private:
  struct Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace carom
