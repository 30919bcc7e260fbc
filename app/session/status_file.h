#pragma once
// A file that says once a second how a session goes, for a technician who is not in the room.

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/live/frame_source.h"
#include "app/nodes/status_writer.h"
#include "app/rig/rig.h"
#include "app/session/frame_listener.h"
#include "app/session/frame_statistics.h"
#include "cave/cluster/cluster.h"
#include "cave/process/termination.h"

namespace carom {

/// A JSON file that is replaced as a whole every second, also while no frames come: a reader never sees
/// half of it. A thread of its own writes it; if it cannot be written any more, this is logged once and
/// the session goes on.
class StatusFile : public FrameListener {
 public:
  /// Writes the first status, "starting". Throws NotWritten if the file cannot be written. `cluster` must
  /// outlive this object.
  StatusFile(std::filesystem::path file, const Cluster& cluster);
  ~StatusFile() override;  ///< writes the last status, "ended"
  StatusFile(const StatusFile&) = delete;
  StatusFile& operator=(const StatusFile&) = delete;

  /// Sets the rig and the title of the game that is played from now on, its session file, which may be empty,
  /// and the session's languages by their numbers in the records.
  void play(const Rig& rig, const std::string& game, const std::filesystem::path& session,
            const std::vector<std::string>& languages);

  /// Sets where the numbers come from. Both must outlive the game's frames.
  void watch(const FrameSource& source, FrameStatistics& statistics);

  void shown(const Decision& decision) override;

 private:
  using Clock = std::chrono::steady_clock;
  /// A moment of the session, as the frame loop notes it; the writing thread puts it into words.
  struct Moment {
    std::string rig, game, session;
    std::vector<MissingNode> missing;
    std::vector<std::string> viewers, languages;  ///< names
    std::array<std::uint8_t, kMostViewers> languageOf{};
    double session_s = 0.0;
    WallControls walls;
    std::vector<LatencyView::Node> nodes;
    std::vector<TrackerReport> trackers;
    std::optional<LinkReport> link;
    bool hasFrame = false;
  };
  std::string text(const char* state);
  void end();

  const Cluster& cluster_;
  const FrameSource* source_ = nullptr;
  FrameStatistics* statistics_ = nullptr;
  Clock::time_point next_{};
  std::mutex mutex_;  // of:
  Moment latest_;
  std::atomic<std::uint64_t> frame_ = 0;  // the latest
  std::atomic<Clock::rep> frameAt_ = 0;   // its time on the clock
  StatusWriter writer_;                   // uses the rest
  ClosedOnLeaving onLeaving_;
};

}  // namespace carom
