#pragma once
// A file that says once a second how a session goes, for a technician who is not in the room.

#include <chrono>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "app/session/frame_listener.h"
#include "app/session/frame_source.h"
#include "app/session/frame_statistics.h"
#include "cave/capture/work_queue.h"
#include "cave/process/termination.h"

namespace carom {

/// A JSON file that is replaced as a whole: whoever reads it never sees half of it. A thread of its own writes
/// it; if it cannot be written any more, this is logged once and the session goes on.
class StatusFile : public FrameListener {
 public:
  /// Writes the first status, "starting". Throws NotWritten if the file cannot be written.
  explicit StatusFile(std::filesystem::path file);
  ~StatusFile() override;  ///< writes the last status, "ended"
  StatusFile(const StatusFile&) = delete;
  StatusFile& operator=(const StatusFile&) = delete;

  /// Sets the titles of the rig and of the game that is played from now on, and its session file, which may be
  /// empty.
  void play(const std::string& rig, const std::string& game, const std::filesystem::path& session);

  /// Sets where the numbers come from. Both must outlive the game's frames.
  void watch(const FrameSource& source, FrameStatistics& statistics);

  void shown(const Decision& decision) override;

 private:
  /// What the file says of a moment, as the frame loop notes it; the writing thread puts it into words.
  struct Moment {
    std::string rig, game, session;
    std::uint64_t frame = 0;
    double session_s = 0.0;
    WallControls walls;
    std::vector<LatencyView::Node> nodes;
    std::vector<TrackerReport> trackers;
  };
  static std::string textOf(const Moment& moment);
  void write(const std::string& text);
  void end();

  std::filesystem::path file_;
  std::string rig_, game_, session_;
  const FrameSource* source_ = nullptr;
  FrameStatistics* statistics_ = nullptr;
  std::chrono::steady_clock::time_point next_{};
  std::mutex mutex_;  // of the file and of:
  bool hasFailed_ = false, hasEnded_ = false;
  WorkQueue<Moment> writer_;
  ClosedOnLeaving onLeaving_;
};

}  // namespace carom
