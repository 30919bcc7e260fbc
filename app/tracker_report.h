#pragma once
// How a tracker fares, as the console shows it.

#include <limits>
#include <string>

#include "devices/tracker.h"

namespace carom {

struct TrackerReport {
  std::string name;  ///< of the rig
  std::string use;   ///< "head", "hand", "steering"
  TrackerHealth health;
  double rate_hz = std::numeric_limits<double>::quiet_NaN();      ///< of the last second
  double age_s = std::numeric_limits<double>::quiet_NaN();        ///< of the newest sample
  /// Of the head alone: how the filter knows it, and its motion.
  std::string known;
  double celerity_m_s = std::numeric_limits<double>::quiet_NaN();
  double sigma_m_s = std::numeric_limits<double>::quiet_NaN();  ///< largest standard deviation of a component
};

}  // namespace carom
