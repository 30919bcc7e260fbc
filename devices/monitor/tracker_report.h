#pragma once
// How a tracker fares, as the console shows it.

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
  /// Of the head alone: how the filter knows it when the frame is shown, how long after the newest sample
  /// that is, and its motion.
  std::optional<Known> known{};
  double shownAfter_s = std::numeric_limits<double>::quiet_NaN();
  double celerity_m_s = std::numeric_limits<double>::quiet_NaN();
  double sigma_m_s = std::numeric_limits<double>::quiet_NaN();  ///< largest standard deviation of a component
};

/// One colour for all of it.
enum class TrackerLamp {
  well,
  doubtful,  ///< someone should look: nothing comes, or too late, or the head is not known when it is shown
  bad,       ///< it cannot work without someone's help
};
TrackerLamp lampOf(const TrackerReport& report);

/// How the head is known and how fast it is, in words; empty where the report is of no head.
std::string headWords(const TrackerReport& report);

}  // namespace carom
