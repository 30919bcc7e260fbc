#pragma once
// The state of a tracker as the console shows it.

#include <limits>
#include <optional>
#include <string>

#include "devices/filter/head_filter.h"
#include "devices/tracker/tracker.h"

namespace carom {

struct TrackerReport {
  std::string name;  ///< of the rig
  std::string use;   ///< "head", "hand", "buttons", "steering"
  TrackerHealth health;
  double rate_hz = std::numeric_limits<double>::quiet_NaN();  ///< of the last second
  double age_s = std::numeric_limits<double>::quiet_NaN();    ///< of the newest sample, when the frame began
  /// For the head only: how the filter knows it when the frame is shown, how long after the newest sample
  /// that is, and its motion.
  std::optional<Known> known{};
  double shownAfter_s = std::numeric_limits<double>::quiet_NaN();
  double celerity_m_s = std::numeric_limits<double>::quiet_NaN();
  double sigma_m_s = std::numeric_limits<double>::quiet_NaN();  ///< largest standard deviation of a component
};

/// The state as the colour of a lamp.
enum class TrackerLamp {
  well,
  doubtful,  ///< needs attention: nothing comes, or too late, or the head is not known when it is shown
  bad,       ///< cannot work without help
};
TrackerLamp lampOf(const TrackerReport& report);

/// Returns in words how the head is known and how fast it is; empty if the report is not of the head.
std::string headWords(const TrackerReport& report);

}  // namespace carom
