#pragma once
// The messages about a tracker while a session runs: a line when it has delivered nothing for long enough to
// matter (5 s), with the second of the session since which; a line when it delivers again, with the length of
// the gap; and once each remark of a tracker that delivers.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "devices/tracker/tracker.h"

namespace carom {

class TrackerAlarm {
 public:
  /// `name` is the tracker's name in the rig, and `sensor` the sensor that the rig uses; none if it uses only
  /// the buttons, which are silent until they are touched. `withoutIt` says in the message what happens to
  /// the part of the person that the tracker follows.
  TrackerAlarm(std::string name, std::optional<int> sensor, std::string withoutIt = "the head is held");

  /// Notes the samples that arrived up to `now_s`. Fast enough for every frame.
  void see(double now_s, std::span<const TrackerSample> samples);

  /// Whether it is time to check the tracker's health again; a few times a second.
  bool isDue(double now_s) const { return now_s >= due_s_; }

  /// Returns the line to show, if there is a new one.
  std::optional<std::string> look(double now_s, const TrackerHealth& health);

 private:
  enum class Trouble { none, failed, connecting, silent, unseen };

  Trouble troubleOf(double now_s, const TrackerHealth& health) const;
  std::string line(Trouble trouble, const TrackerHealth& health) const;
  std::string returnLine() const;
  std::string told(const std::string& what) const;
  bool isNew(const TrackerHealth& health);

  std::string name_;
  std::optional<int> sensor_;
  std::string withoutIt_;
  double seen_s_ = 0.0;           // when the wanted sensor was last seen, or the session's start
  double pose_s_ = 0.0;           // the time of its newest pose; a frame that comes late sees it late
  std::optional<double> back_s_;  // the time of its first pose since the last trouble was told
  bool wasSeen_ = false;
  std::vector<int> otherSensors_;
  double well_s_ = 0.0;  // when it last delivered, or the session's start
  double due_s_ = 0.0;
  Trouble told_ = Trouble::none;
  std::vector<std::string> messages_;    // that have been told since it was last well
  std::optional<double> missedSince_s_;  // the wanted sensor had been seen; then came the fault that was told
};

}  // namespace carom
