#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/calibration/calibration_data.h"
#include "app/toml/input_file.h"
#include "devices/tracker/trace.h"

namespace carom {
namespace {

/// Returns the recording's rests. There must be as many as `names`.
std::vector<Rest> expectedRests(const std::filesystem::path& file, const std::vector<TrackerSample>& samples,
                                const glm::dvec3& point_m, const RestLimits& limits,
                                const std::vector<std::string>& names) {
  std::vector<Rest> rests = restsOf(samples, point_m, limits);
  if (rests.size() == names.size()) return rests;
  std::vector<std::string> found;
  for (const Rest& rest : rests) {
    found.push_back(fmt::format("at {:.1f} s for {:.1f} s", rest.begin_s, rest.end_s - rest.begin_s));
  }
  throw InputErrors({InputError(
      file.string(), 1, 1,
      fmt::format(
          "the sensor was at rest {} times ({}), expected {}, once for each of {}; a rest stays within "
          "{:.0f} mm for at least {} s",
          rests.size(), fmt::join(found, ", "), names.size(), fmt::join(names, ", "), 1e3 * limits.radius_m,
          limits.least_s))});
}

std::vector<std::string> namesOf(const std::vector<NamedCorner>& corners) {
  std::vector<std::string> names;
  for (const NamedCorner& corner : corners) names.push_back(corner.name);
  return names;
}

std::vector<HeldAt> heldAt(const std::vector<NamedCorner>& corners, const std::vector<Rest>& rests) {
  std::vector<HeldAt> held;
  for (std::size_t i = 0; i < corners.size(); ++i) held.push_back({corners[i], rests[i]});
  return held;
}

}  // namespace

RestLimits toolLimits(double noise_m) {
  RestLimits limits;
  limits.radius_m = std::max(limits.radius_m, 5.0 * noise_m);
  return limits;
}

RestLimits headLimits() { return {.radius_m = 0.015, .least_s = 0.8}; }

glm::dvec3 tipOf(const CalibrationData& data) { return data.tip ? data.tip->fit.tip_m : glm::dvec3(0.0); }

CalibrationData readCalibration(const std::filesystem::path& folder, const CalibrationPlan& plan) {
  CalibrationData data;
  if (plan.pivot) data.tip = fitTip(readTrace(folder / kPivotFile));
  const std::filesystem::path cornersFile = folder / kCornersFile;
  const std::vector<TrackerSample> samples = readTrace(cornersFile);
  data.noise_m = noiseOf_m(samples);
  std::vector<std::string> names = namesOf(plan.corners);
  if (plan.sight) names.emplace_back("the mark");
  std::vector<Rest> rests = expectedRests(cornersFile, samples, tipOf(data), toolLimits(data.noise_m), names);
  if (plan.sight) {
    data.mark = rests.back();
    rests.pop_back();
  }
  data.touched = heldAt(plan.corners, rests);
  if (!plan.sight) return data;
  for (std::size_t eye = 0; eye < 2; ++eye) {
    const std::filesystem::path file = folder / kSightFiles[eye];
    const auto seen =
        expectedRests(file, readTrace(file), glm::dvec3(0.0), headLimits(), namesOf(plan.targets));
    data.sighted[eye] = heldAt(plan.targets, seen);
  }
  return data;
}

}  // namespace carom
