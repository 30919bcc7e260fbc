#pragma once
// What this rank draws, keeps and hears of one game's frames, live or recorded.

#include <memory>
#include <optional>

#include "app/console/console.h"
#include "app/console/console_listener.h"
#include "app/console/diagram_window.h"
#include "app/session/frame_loop.h"
#include "app/session/session_listeners.h"
#include "app/session/session_views.h"
#include "app/stage/session_setup.h"

namespace carom {

/// The windows of rank 0 beside those of its walls, where they were asked for. The setup stays where it is.
struct OperatorWindows {
  std::unique_ptr<DiagramWindow> diagram;
  std::unique_ptr<Console> console;

  /// Another game: the setup has it.
  void play(const SessionSetup& setup);
};
OperatorWindows openWindows(Cluster& cluster, SessionSetup& setup, bool diagram, bool console, KeysOf keys);

/// What only rank 0 has.
struct LeaderParts {
  const FrameSource& source;
  FrameLeader& leader;
  OperatorWindows& windows;
  Sounds* sounds;            ///< null: silent
  JournalListener* journal;  ///< null: nothing is written
};

/// Opens the system's sound device, for who watches in real time; null for others, or where they want silence.
std::unique_ptr<Sounds> soundsFor(const SessionSetup& setup, bool silent);

/// Returns the settings with which rig and scenario begin.
OperatorSettings settingsAtStart(const SessionSetup& setup);

class SessionFrames {
 public:
  /// `lead`: null on ranks other than 0. All are used as long as this lives.
  SessionFrames(Cluster& cluster, SessionSetup& setup, FramePacer& pacer, const LeaderParts* lead,
                KeysOf keys);
  SessionFrames(const SessionFrames&) = delete;
  SessionFrames& operator=(const SessionFrames&) = delete;

  FrameContext& context() { return context_; }
  const FrameStatistics& statistics() const { return statistics_; }

 private:
  void listen(SessionSetup& setup, const LeaderParts& lead, KeysOf keys);

  Director follower_;
  FrameStatistics statistics_;
  WallsView walls_;
  std::optional<OutsideView> outside_;
  DrawingEnd drawingEnd_;
  RecordingListener recording_;
  std::optional<SoundsListener> sounds_;
  std::optional<ConsoleListener> console_;
  std::optional<ProgressListener> progress_;
  FrameContext context_;
};

}  // namespace carom
