#include "app/calibration/tip_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

namespace carom {
namespace {

constexpr std::size_t kFewestPoses = 60;  // a second at 60 Hz
constexpr double kMostTipMiss_m = 0.005;  // rms: a tip that is held in a hole moves less
constexpr double kMostTipError_m = 0.002;
constexpr double kLongest_m = 2.0;
constexpr double kGlitch = 3.0;  // times the median distance

/// Returns the poses whose tip is near the common place.
std::vector<Pose> withoutGlitches(const std::vector<Pose>& poses, const PivotFit& fit) {
  std::vector<double> misses_m;
  for (const Pose& pose : poses) misses_m.push_back(glm::distance(pose * fit.tip_m, fit.pivot_m));
  std::vector<double> sorted_m = misses_m;
  const auto middle = sorted_m.begin() + static_cast<std::ptrdiff_t>(sorted_m.size() / 2);
  std::nth_element(sorted_m.begin(), middle, sorted_m.end());
  std::vector<Pose> kept;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (misses_m[i] <= kGlitch * *middle) kept.push_back(poses[i]);
  }
  return kept;
}

}  // namespace

TipFit fitTip(std::span<const TrackerSample> samples) {
  std::vector<Pose> poses;
  for (const TrackerSample& sample : samples) {
    if (!sample.hasOrientation)
      return {{}, "the tracker sends no orientation, without which no tip is found"};
    poses.push_back(sample.pose);
  }
  if (poses.size() < kFewestPoses) {
    return {{},
            fmt::format("{} samples of the turning tool are too few, expected at least {}", poses.size(),
                        kFewestPoses)};
  }
  TipFit tip;
  tip.fit = fitPivot(poses);
  tip.fit = fitPivot(withoutGlitches(poses, tip.fit));
  const bool wavers = !(tip.fit.rms_m <= kMostTipMiss_m);
  if (!wavers && !(tip.fit.tipError_m <= kMostTipError_m)) {
    tip.fault =
        "the tool was turned too little to find its tip: tilt it by 30 degrees at least to all sides, and "
        "turn it "
        "about itself";
  } else if (!(glm::length(tip.fit.tip_m) <= kLongest_m)) {
    tip.fault = fmt::format(
        "the tip comes out {:.3g} m from the sensor, expected at most {:.0f} m: the tracker does not send "
        "metres",
        glm::length(tip.fit.tip_m), kLongest_m);
  } else if (wavers) {
    tip.fault = fmt::format(
        "the tip moved by {:.1f} mm (rms) while the tool was turned, expected at most {:.0f} mm: hold it in "
        "a "
        "small hole; if it was held there, the tracker's places and turns do not belong together",
        1e3 * tip.fit.rms_m, 1e3 * kMostTipMiss_m);
  }
  return tip;
}

}  // namespace carom
