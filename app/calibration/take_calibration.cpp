#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "app/calibration/calibration_data.h"
#include "app/calibration/live_points.h"
#include "devices/tracker/trace.h"

namespace carom {
namespace {

constexpr double kPivot_s = 15.0;
constexpr double kTouch_s = 1.0;
constexpr const char* kBell = "\a";

/// Writes recordings beside each other as they grow, each always whole.
class Recordings {
 public:
  explicit Recordings(const std::optional<std::filesystem::path>& folder) : folder_(folder) {
    if (folder_) std::filesystem::create_directories(*folder_);
  }
  void write(const char* name, const std::vector<std::vector<TrackerSample>>& parts) const {
    const auto first =
        std::find_if(parts.begin(), parts.end(), [](const auto& part) { return !part.empty(); });
    if (!folder_ || first == parts.end()) return;
    TraceWriter writer(*folder_ / name, first->front().hasOrientation, "recorded by carom calibrate");
    for (const auto& part : parts) {
      for (const TrackerSample& sample : part) writer.add(sample);
    }
    writer.commit();
  }

 private:
  std::optional<std::filesystem::path> folder_;
};

/// One point that a person is asked for.
struct Asked {
  std::string words;
  NamedCorner corner;
};

/// Points that were taken.
struct Taken {
  std::vector<HeldAt> held;
  std::vector<std::vector<TrackerSample>> samples;
  bool ended = false;  ///< by the person, before the last point
};

void say(const std::string& words) {
  fmt::print("{}\n", words);
  std::fflush(stdout);
}

/// Takes one point; none, with the reason said, if there is no pose or the sensor moved.
std::optional<Rest> takeRest(LivePoints& live, const SensorChoice& sensor, const glm::dvec3& point_m,
                             const RestLimits& usual, std::vector<TrackerSample>& samples) {
  samples = live.record(sensor, kTouch_s);
  if (samples.size() < 3) {
    say(fmt::format("  Nothing came from sensor {}: {}. Take it again.", sensor.sensor, live.health(sensor)));
    return {};
  }
  RestLimits limits = usual;
  limits.least_s = 0.0;
  limits.radius_m = std::max(limits.radius_m, toolLimits(noiseOf_m(samples)).radius_m);
  const std::vector<Rest> rests = restsOf(samples, point_m, limits);
  if (rests.size() == 1 && rests[0].samples * 10 >= samples.size() * 8) {
    say(fmt::format("{}  Taken: {} samples within {:.1f} mm.", kBell, rests[0].samples,
                    1e3 * rests[0].spread_m));
    return rests[0];
  }
  say(fmt::format("  It moved by more than {:.0f} mm. Hold it still, and take it again.",
                  1e3 * limits.radius_m));
  return {};
}

/// Asks for each point in turn. `keep` gets what has been taken, after each point.
Taken takePoints(LivePoints& live, const SensorChoice& sensor, const glm::dvec3& point_m,
                 const RestLimits& limits, const std::vector<Asked>& asked,
                 const std::function<void(const std::vector<std::vector<TrackerSample>>&)>& keep) {
  Taken taken;
  std::vector<std::size_t> of;  // the asked point of each that was taken
  for (std::size_t next = 0; next < asked.size();) {
    say(fmt::format("{} of {}: {}", next + 1, asked.size(), asked[next].words));
    switch (live.wait()) {
      case Wish::take: {
        std::vector<TrackerSample> samples;
        const auto rest = takeRest(live, sensor, point_m, limits, samples);
        if (!rest) break;
        taken.held.push_back({asked[next].corner, *rest});
        taken.samples.push_back(std::move(samples));
        of.push_back(next++);
        keep(taken.samples);
        break;
      }
      case Wish::skip:
        say("  Skipped.");
        ++next;
        break;
      case Wish::back:
        if (of.empty()) break;
        next = of.back();
        of.pop_back();
        taken.held.pop_back();
        taken.samples.pop_back();
        keep(taken.samples);
        say("  Back to the last one that was taken.");
        break;
      case Wish::end:
        taken.ended = true;
        return taken;
    }
  }
  return taken;
}

TipFit takeTip(LivePoints& live, const CalibrationPlan& plan, const Recordings& recordings) {
  say(fmt::format(
      "The tip: put it into a small hole, press Enter, and turn the tool about it for {:.0f} s, to "
      "all sides.",
      kPivot_s));
  while (live.wait() != Wish::end) {
    const std::vector<TrackerSample> samples = live.record(plan.tool, kPivot_s);
    TipFit tip = fitTip(samples);
    if (tip.fault.empty()) {
      say(fmt::format("{}  Taken: the tip moved by {:.1f} mm.", kBell, 1e3 * tip.fit.rms_m));
      recordings.write(kPivotFile, {samples});
      return tip;
    }
    say(fmt::format("  Not taken: {}.{} Press Enter and do it again.", tip.fault,
                    samples.empty() ? " " + live.health(plan.tool) + "." : ""));
  }
  return {{}, "the tip was not taken"};
}

void takeCorners(LivePoints& live, const CalibrationPlan& plan, const Recordings& recordings,
                 CalibrationData& data) {
  std::vector<Asked> asked;
  for (const NamedCorner& corner : plan.corners) asked.push_back({"touch " + wordsFor(corner), corner});
  if (plan.sight) {
    asked.push_back(
        {"touch the mark, which must then stay where it is: the top of a stand, at the height of "
         "the eyes and a step before them",
         {}});
  }
  say("Touch each point, hold still and press Enter or the wand's first button. s skips a point, b or the "
      "second "
      "button goes back, q ends.");
  Taken taken = takePoints(live, plan.tool, tipOf(data), RestLimits{}, asked,
                           [&](const auto& samples) { recordings.write(kCornersFile, samples); });
  std::vector<TrackerSample> all;
  for (const auto& samples : taken.samples) all.insert(all.end(), samples.begin(), samples.end());
  data.noise_m = noiseOf_m(all);
  if (!taken.held.empty() && taken.held.back().corner.name.empty()) {
    data.mark = taken.held.back().rest;
    taken.held.pop_back();
  }
  data.touched = std::move(taken.held);
}

void takeSights(LivePoints& live, const Rig& rig, const CalibrationPlan& plan, const Recordings& recordings,
                CalibrationData& data) {
  constexpr std::array<const char*, 2> kClosed{"right", "left"}, kOpen{"left", "right"};
  for (std::size_t eye = 0; eye < 2; ++eye) {
    std::vector<Asked> asked;
    for (std::size_t i = 0; i < plan.targets.size(); ++i) {
      // The nose points elsewhere, or all lines would be one line for the head.
      const NamedCorner& elsewhere = plan.targets[(i + 1) % plan.targets.size()];
      asked.push_back({fmt::format("close the {} eye, turn the nose half the way to {}, and move so that the "
                                   "mark covers {} for the {} eye",
                                   kClosed[eye], elsewhere.name, wordsFor(plan.targets[i]), kOpen[eye]),
                       plan.targets[i]});
    }
    Taken taken = takePoints(live, rig.viewers.front().head.sensor, glm::dvec3(0.0), headLimits(), asked,
                             [&](const auto& samples) { recordings.write(kSightFiles[eye], samples); });
    data.sighted[eye] = std::move(taken.held);
    if (taken.ended) return;
  }
}

}  // namespace

CalibrationData takeCalibration(const Rig& rig, const CalibrationPlan& plan,
                                const std::optional<std::filesystem::path>& folder) {
  const Recordings recordings(folder);
  LivePoints live(rig);
  CalibrationData data;
  if (plan.pivot) {
    data.tip = takeTip(live, plan, recordings);
    if (!data.tip->fault.empty()) return data;
  }
  takeCorners(live, plan, recordings, data);
  if (data.mark) takeSights(live, rig, plan, recordings, data);
  return data;
}

}  // namespace carom
