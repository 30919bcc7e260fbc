#pragma once
// A session's journal: one SQLite file with all that was shown, known and done, readable with plain SQL.
//
// Tables (times of the session's clock in seconds, board coordinates in seconds and metres):
//   session(key, value)
//       What was played: program, rig and scenario with their texts, light speed, start (UTC).
//   frame(number, display_s, proper_time_s, t_s, x_m, y_m, z_m, known, celerity_x_m_s …, switches,
//         truncate_from_s, record)
//       One row a frame. t_s … z_m: the event at which the point between the eyes received the frame's light.
//       `record`: the whole record as this version's program holds it.
//   knot(frame, body, t_s, x_m, y_m, z_m, u_x, u_y, u_z, proper_time_s, knot)
//       Legs that a frame brought; u = γβ. Bodies count as in the scenario: 0 the board, then the pucks, then
//       what is told.
//   sample(time_s, sensor, x_m, y_m, z_m, qw, qx, qy, qz)
//       What the tracker of the head delivered.
// `PRAGMA user_version` is the version of this list.

#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "cave/cluster.h"
#include "cave/frame_state.h"
#include "devices/head_filter.h"
#include "devices/tracker.h"

namespace carom {

/// How a SQLite file tells that it is a journal ("Caro"), and the version of its tables. A file of a newer
/// one is not read.
inline constexpr int kJournalId = 0x4361726f;
inline constexpr int kJournalVersion = 1;

/// What a journal begins with.
struct SessionFacts {
  std::string program;
  std::filesystem::path rig, scenario;
  std::string rigText, scenarioText;
  double lightSpeed_m_s = 0.0;
};

/// Written by a thread of its own, one transaction a batch of frames, so that a frame only copies its rows.
/// What has been handed over is on its way at once: a killed program lacks two frames at the most. When the
/// disk is full, or the file cannot be written for another reason, the session goes on: it is said once, rows
/// wait (ten minutes of them; later ones are lost) and are written when it works again, which is said, too.
class Journal {
 public:
  /// Makes the file, or with `goOn` goes on with the one that is there. Throws std::runtime_error if there is
  /// one already, or none to go on with, if the folder cannot be written, or if another session writes to it.
  Journal(const std::filesystem::path& file, const SessionFacts& facts, bool goOn, Say say);
  ~Journal();  ///< writes what is left
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// One frame: what was drawn, how the head was known, what the tracker had delivered for it. Waits for
  /// nothing.
  void add(const FrameState& state, const HeadEstimate& head, std::span<const TrackerSample> samples);

 private:
  struct Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace carom
