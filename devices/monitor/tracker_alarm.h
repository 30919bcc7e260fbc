#pragma once
// What a person should be told of a tracker while a session runs: one line when something is wrong for long
// enough to matter (5 s of silence), and since which second of the session, one when it is well again, and
// after how long, and once what a tracker that delivers has remarked on.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "devices/tracker/tracker.h"

namespace carom {

class TrackerAlarm {
 public:
  /// The tracker's name in the rig, and the sensor that is wanted of it; none: its buttons alone are wanted,
  /// which say nothing while nobody touches them. `withoutIt`: what becomes of the person's part that it
  /// follows.
  TrackerAlarm(std::string name, std::optional<int> sensor, std::string withoutIt = "the head is held");

  /// Notes what came up to `now_s`. Cheap, for every frame.
  void see(double now_s, std::span<const TrackerSample> samples);

  /// Whether it is time to look at the tracker's health again: a few times a second.
  bool isDue(double now_s) const { return now_s >= due_s_; }

  /// The line, if there is a new one.
  std::optional<std::string> look(double now_s, const TrackerHealth& health);

 private:
  enum class Trouble { none, failed, connecting, silent, unseen };

  Trouble troubleOf(double now_s, const TrackerHealth& health) const;
  std::string line(Trouble trouble, const TrackerHealth& health) const;
  std::string returnLine(double now_s) const;
  std::string told(const std::string& what) const;
  bool isNew(const TrackerHealth& health);

  std::string name_;
  std::optional<int> sensor_;
  std::string withoutIt_;
  double seen_s_ = 0.0;  // the wanted sensor, or the session's start
  bool wasSeen_ = false;
  std::vector<int> otherSensors_;
  double well_s_ = 0.0;  // when it last delivered, or the session's start
  double due_s_ = 0.0;
  Trouble told_ = Trouble::none;
  std::vector<std::string> messages_;    // that have been told since it was last well
  std::optional<double> missedSince_s_;  // the wanted sensor had been seen, and then came what was told
};

}  // namespace carom
