#pragma once
// A person who takes points with a tracked sensor: keys or the wand's button say when.

#include <chrono>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/rig/rig.h"
#include "devices/tracker/tracker.h"

namespace carom {

/// What the person asks for.
enum class Wish { take, skip, back, end };

/// The trackers of a rig while points are taken. Keys come from standard input, which is a terminal or a
/// pipe: Enter takes, s skips, b goes back, q ends, as do Ctrl-C, SIGTERM and the end of the input. So does
/// any button of the hand: the first takes, the second goes back.
class LivePoints {
 public:
  explicit LivePoints(const Rig& rig);
  LivePoints(const LivePoints&) = delete;
  LivePoints& operator=(const LivePoints&) = delete;
  ~LivePoints();

  /// Waits for the next wish.
  Wish wait();
  /// Returns what the sensor sends in the next `seconds`.
  std::vector<TrackerSample> record(const SensorChoice& sensor, double seconds);
  /// Says how the sensor's tracker is, for when nothing came from it.
  std::string health(const SensorChoice& sensor) const;

 private:
  class Terminal;
  double now_s() const;
  /// Polls all trackers; returns the wish that a button made.
  std::optional<Wish> poll();
  bool isHandButton(std::size_t tracker, const Reading& input) const;

  const Rig& rig_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::vector<std::unique_ptr<Tracker>> trackers_;
  std::vector<std::vector<TrackerSample>> newest_;  ///< of each tracker, since the last poll
  std::map<int, bool> pressed_;                     ///< the hand's buttons
  std::unique_ptr<Terminal> terminal_;
};

}  // namespace carom
