#pragma once
// A session's journal: one SQLite file with all that was shown, tracked and done, readable with plain SQL.
//
// Tables (session times in seconds on the session clock, board coordinates in seconds and metres):
//   session(key, value)
//       The session's setup: program, rig and scenario with their texts, light speed, start (UTC), languages
//       (app/journal/language_keys.h); also the end, once the session was closed properly.
//   game(first_frame, first_event, started_utc, scenario_file, scenario, light_speed_m_s)
//       The games of the session, one after the other: its frames and events are those from first_frame and
//       first_event up to the next game's. The first game is also that of the table session.
//   frame(number, display_s, proper_time_s, t_s, x_m, y_m, z_m, switches, views, beside, truncate_from_s, …,
//         known, celerity_x_m_s …)
//       One row per frame: each field of its record (cave/record/frame_state.h) in its own column
//       (app/journal_rows/frame_columns.h), and how the head was known. t_s … z_m: the event at which the
//       point between the eyes received the frame's light. switches: the sum of the bits retardation 1,
//       contraction 2, aberration 4, colour 8, searchlight 16; beside: the same for the right half if views
//       includes split. views: the sum of the bits of kNamedViews (cave/record/time_views.h): its first row
//       is 1, the next 2, then 4, and so on.
//   knot(frame, body, t_s, x_m, y_m, z_m, u_x, u_y, u_z, proper_time_s, signal_t_s …, deceleration_m_s2,
//        angle_rad, spin_rad_s, rim_u, spin_slowing_1_s)
//       Legs that a frame added; u = γβ. signal_t_s …: the event whose light makes the body's points turn.
//       angle_rad …: how the body turns (engine/spacetime/world_line.h).
//       Bodies are numbered as in the scenario: 0 the board, then the pucks, then the scripted bodies.
//   frame_event(frame, number, kind, cushion, which, t_s, x_m, y_m, z_m, without_delay, heat_j, turns, …)
//       Events that a frame added to the game's list (engine/game/game_event.h), each with its turns,
//       whose number is `turns`. kind is the value of EventKind, cushion that of Cushion plus 1; 0 is none.
//       Events that a later stroke invalidated stay here, because they were shown.
//   event(number, kind, pucks, cushion, t_s, x_m, y_m, z_m, heat_j, without_delay, side_on_side)
//       The final events: rows that a stroke invalidated are deleted. Numbers are in the order in which the
//       simulation found the events; a game's first one has the number first_event. kind: puck-puck,
//       puck-cushion, stroke, flash, jam. pucks: names, separated by commas. t_s … z_m: the contact, the
//       hand's stroke, the flash. without_delay: 1 if the contact existed already and the kick did not wait
//       for its signal (engine/game/game_event.h), else 0. side_on_side: 1 if a side of a puck lay on a
//       side of the other or on a cushion, and the contact is the middle of what touched, else 0. The game is
//       known a little further than it was seen.
//   turn(event, puck, t_s, x_m, y_m, z_m, beta_before_x, beta_before_y, beta_after_x, beta_after_y,
//   proper_time_s, spin_before_kg_m2_s, spin_after_kg_m2_s)
//       The change of motion and spin of each puck of an event, with the puck's name and its proper time.
//   viewer(frame, name, t_s, x_m, y_m, z_m, proper_time_s, room_x_m, room_y_m, room_z_m, lapse,
//          celerity_x_m_s, celerity_y_m_s, celerity_z_m_s, known)
//       One row per frame and viewer: the event between the eyes, the viewer's own time, the place in the
//       room as the clock took it, the lapse there (engine/spacetime/observers.h), and how the head was
//       known. With the steps dx of the places and dT of the room's time from one frame to the next, the own
//       time advances by sqrt((lapse dT)² − dx²/c²).
//   platform(frame, room_s, u_x, u_y, u_z, qw, qx, qy, qz, thrust_x_m_s2, thrust_y_m_s2, thrust_z_m_s2)
//       The room's own time, its u = γβ on the board after a rotation from its axes to the board's, and its
//       mean thrust in the frame, felt by the one who steers, in the room's axes.
//   other_viewer(frame, viewer, proper_time_s, …)
//       The record's part of the viewers after the first (app/journal_rows/frame_columns.h).
//   force(frame, viewer, scale, place_x_m, …, force_n_x, …)
//       One row per frame and viewer with a force device: its place as its loop took it and the force on the
//       hand, in the room's axes; scale: 1 N in the hand is 1/scale N at the cue. Draws, pulses and falls to
//       0 N are rows of the table input: 'force draw', 'force pulse', 'force off'.
//   stroke(frame, puck, at_s, from_x_m, from_y_m, from_z_m, p_x_kg_m_s, p_y_kg_m_s, offset_m, viewer, room,
//          number)
//       Strokes by hand in a frame: the puck's name, the event of the hand, and the momentum that arrives at
//       the puck; offset_m: how far to the right of its centre it strikes. Together with the scenario's
//       strokes they are all strokes of the game, in its order. Of linked rooms: room is that of the hand, 0
//       the host, and number counts the room's strokes from 0; the frame of a stroke from afar is that in
//       which it came, or the game's first if it was made before this room joined.
//   input(frame, what, value, viewer)
//       Actions of the operator and the hands, in words; they take effect with this frame.
//   answer(frame, lesson, question, answer, viewer)
//       Answers of visitors.
//   vote(frame, round, lesson, question, token, answer, confidence, seconds, reason)
//       Sessions with a class alone (--class): what a phone's answer was when vote `round` was closed, the
//       frame of its closing. confidence: 1 to 4, or NULL; seconds from the opening of the vote; token: of
//       the phone, which names nobody. The phases of the class are in the table input, as "class".
//   task(frame, task, viewer, event, stars, energy_j)
//       What happened to tasks: event is begun, failed (nothing came of a stroke) or solved; stars is 1 to 3
//       where it is solved, else 0; energy_j: of the strokes since it began.
//   link(frame, room, state, heard, round_trip_s, promise_t_s, promise_x_m, promise_y_m, promise_z_m, viewer,
//        waits, pace, digest_s)
//       Sessions with another room alone (--link): one row per frame and viewer of the other room. heard: the
//       number of its newest present; promise_…: the promise that held, an event outside whose future all
//       eyes of the frame are (engine/linked/promise.h); waits: 1 if the people here did not live on; pace:
//       how much faster they lived than they would alone; digest_s: both games are the same up to this board
//       time.
//   link_person(frame, room, viewer, number, t_s, x_m, y_m, z_m, proper_time_s, person, kind, hand_t_s,
//               hand_x_m, hand_y_m, hand_z_m, facing_rad, has_hand, has_cue, cue_rad, caroms)
//       The head of a viewer of the other room as present `number` told it: equal to the bit to the row of
//       the table viewer in that room's file. person counts the viewers of that room from 0. kind is 1 where
//       the person appears; it is 2, and number is 0, where they have gone, which no present told; else it is
//       0. The other columns are of the hand and of the ways in which head and cue point, as they are drawn.
//   link_note(frame, room, what, value)
//       paired, apart, gone, broken, back, put off, mismatch, resynchronised, refused.
//   run(first_frame, started_utc, program)
//       Each time that writing began: the first, and one for each continuation of the session and each
//       further game.
//   sample(time_s, sensor, x_m, y_m, z_m, qw, qx, qy, qz, tracker)
//       Samples of the heads' trackers.
//   latency(display_s, frame, node, part, frames, median_s, p99_s, most_s, jitter_s)
//       Real-time sessions, once per second for each node and part of a frame (cave/frame/frame_timing.h):
//       statistics over the last second's frames; `frame` is the newest of them. `late` is by how much an
//       interval between swaps exceeded the display's period. About 100 bytes per row, at most eight rows per
//       node and second.
// Numbers in frame, knot and frame_event are stored exactly: zero as an integer, NaN as NULL. `PRAGMA
// user_version` is the version of this list; files of other versions are refused.

#include <chrono>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/journal/session_facts.h"
#include "app/journal_rows/journal_news.h"
#include "cave/frame/frame_timing.h"
#include "cave/record/frame_state.h"
#include "devices/filter/head_filter.h"
#include "devices/tracker/tracker.h"
#include "engine/billiard/billiard.h"

namespace carom {

/// Interval at which the written data is moved from FILE-wal into the session file itself.
inline constexpr std::chrono::milliseconds kIntoFileEvery{20000};

/// Writes the journal in a separate thread, one transaction per batch of frames, so that a frame only copies
/// its rows. Data is written at once: a killed program loses two frames at most. If the disk is full or the
/// file cannot be written for another reason, the session continues: the log reports it once, rows wait and
/// are written when writing works again, which the log reports too. Frames wait for up to ten minutes: after
/// that the file ends before the first lost frame, for good, because later ones would build on it. If a
/// killed program's file is copied without its FILE-wal, at most the last `intoFileEvery` is missing, unless
/// the program was killed in the few milliseconds of updating the file: that copy needs its FILE-wal.
class Journal {
 public:
  /// Creates the file or, with `goOn`, continues the existing one. Throws std::runtime_error if the file
  /// exists already, or does not exist for `goOn`, if the folder cannot be written, or if another session
  /// writes to it.
  Journal(const std::filesystem::path& file, const SessionFacts& facts, bool goOn,
          std::chrono::milliseconds intoFileEvery = kIntoFileEvery);
  ~Journal();  ///< closes it
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Writes the remaining rows and closes the file, which is then complete without FILE-wal. Rows added later
  /// are not written. May be called from any thread, also while another adds or closes.
  void close();

  /// Adds a frame: its record, how each viewer's head was known, the trackers' samples for it, and the
  /// strokes by hand. Never blocks.
  void add(const FrameState& state, std::span<const HeadEstimate> heads,
           std::span<const TrackerSamples> samples, std::span<const HandStroke> strokes = {},
           const LinkNews& link = {});

  /// Adds what the operator or a viewer's hand did; it takes effect with frame `frame`.
  void addInput(std::uint64_t frame, const std::string& what, const std::string& value,
                std::size_t viewer = 0);
  void addAnswer(std::uint64_t frame, const std::string& lesson, const std::string& question,
                 const std::string& answer, std::size_t viewer = 0);
  /// Adds a vote of a class, of a session whose facts say that it has one.
  void addVote(std::uint64_t frame, const ClassVote& vote);

  void addTask(std::uint64_t frame, const TaskNews& news);

  /// Adds the nodes' frame timing; written with the next frame.
  void add(std::span<const LatencyRow> rows);

 private:
  struct Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace carom
