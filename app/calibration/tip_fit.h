#pragma once
// The tip of a pointing tool from a recording in which it was turned about its tip.

#include <span>
#include <string>

#include "devices/calibration/pivot_fit.h"
#include "devices/tracker/tracker.h"

namespace carom {

struct TipFit {
  PivotFit fit;
  std::string fault;  ///< if there is one, the tip must not be used
};

/// Fits and judges. Samples that are far from what the others say, as glitches are, are left out.
TipFit fitTip(std::span<const TrackerSample> samples);

}  // namespace carom
