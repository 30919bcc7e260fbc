#pragma once
// The trackers of a rig, each opened once, however many heads and hands follow it.

#include <chrono>
#include <cstddef>
#include <memory>
#include <vector>

#include "app/rig/rig.h"
#include "devices/tracker/tracker.h"

namespace carom {

/// How many samples or inputs of a tracker fit in one poll; more than a device's queue holds.
inline constexpr std::size_t kMostSamples = 4096;

class SharedTrackers {
 public:
  /// Opens no tracker yet. `sessionStart` is where the session clock reads zero.
  SharedTrackers(const Rig& rig, std::chrono::steady_clock::time_point sessionStart)
      : setups_(rig.trackers), axes_(rig.axes), sessionStart_(sessionStart), opened_(rig.trackers.size()) {}

  /// Returns a follower of that tracker of the rig, which is opened for the first of them. Every follower
  /// receives everything, if all of them poll at the same times, and each once at a time. Throws InputError
  /// if a recorded trace is invalid.
  std::unique_ptr<Tracker> follow(std::size_t tracker);

  /// Takes this tracker in the place of one of the rig's, which is not followed yet.
  void take(std::size_t tracker, std::unique_ptr<Tracker> opened);

 private:
  struct Opened;
  class Follower;

  std::vector<TrackerSetup> setups_;
  RoomAxes axes_;
  std::chrono::steady_clock::time_point sessionStart_;
  std::vector<std::shared_ptr<Opened>> opened_;
};

}  // namespace carom
