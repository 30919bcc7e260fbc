#pragma once
// Connects the views and listeners of one game's frames on this rank, live or recorded.

#include <memory>
#include <optional>

#include "app/console/console.h"
#include "app/console/console_listener.h"
#include "app/console/diagram_window.h"
#include "app/session/frame_loop.h"
#include "app/session/session_listeners.h"
#include "app/session/session_views.h"
#include "app/session/status_file.h"
#include "app/session/study_listener.h"
#include "app/stage/session_setup.h"

namespace carom {

/// The windows of rank 0 besides those of its walls; null where not requested. The setup must not move in
/// memory.
struct OperatorWindows {
  std::unique_ptr<DiagramWindow> diagram;
  std::unique_ptr<Console> console;

  /// Switches to another game, which is in `setup`.
  void play(const SessionSetup& setup);
};
/// Returns whether there is a console, and whether it is in sight, when a session begins.
ConsoleState consoleAtStart(const DeskWindows& desk);

/// Opens those for which the setup has a place.
OperatorWindows openWindows(Cluster& cluster, SessionSetup& setup, KeysOf keys);

/// Remembers where the windows of rank 0 lie now, in a session that somebody watches.
void rememberWindows(const SessionSetup& setup, const OperatorWindows& windows);

/// The parts that exist only on rank 0.
struct LeaderParts {
  const FrameSource& source;
  FrameLeader& leader;
  OperatorWindows& windows;
  Sounds* sounds;                   ///< null if silent
  JournalListener* journal;         ///< null if the session is not recorded
  StatusFile* status;               ///< null if there is none
  ClassDesk* classroom = nullptr;   ///< null if no class takes part
  StudyListener* study = nullptr;   ///< null if there is no study
  FrameListener* phones = nullptr;  ///< null if none follows
};

/// Opens the audio output of the system. Returns null in simulated time or if `silent`.
std::unique_ptr<Sounds> soundsFor(const SessionSetup& setup, bool silent);

/// Returns the pacer of a session: frames begin as the rig's displays want them or, with a headset, as that
/// does. `lived_s`: the session's clock before the first frame, whose number is `firstFrame`.
std::unique_ptr<FramePacer> pacerFor(const SessionSetup& setup, Clock& clock, double lived_s = 0.0,
                                     std::uint64_t firstFrame = 0);

class SessionFrames {
 public:
  /// `lead` is null on ranks other than 0. All arguments must outlive this object.
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
  std::optional<HeadsetView> headset_;
  WallsView walls_;
  std::optional<SpectatorWindow> outside_;
  DrawingEnd drawingEnd_;
  RecordingListener recording_;
  std::optional<HapticListener> haptics_;
  std::optional<SoundsListener> sounds_;
  std::optional<ConsoleListener> console_;
  std::optional<ProgressListener> progress_;
  KeyLock noLock_;
  EndQuestion ending_;
  FrameContext context_;
};

}  // namespace carom
