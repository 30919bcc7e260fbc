#include "app/tools/calibrate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <memory>
#include <stdexcept>

#include "app/calibration/calibration_data.h"
#include "app/calibration/corner_fit.h"
#include "app/calibration/eye_places.h"
#include "app/calibration/rig_lines.h"
#include "app/rig/rig.h"
#include "app/tools/option_values.h"
#include "engine/text/log.h"

namespace carom {
namespace {

constexpr double kQuiet_m = 0.002;  // noise of a sample that deserves no remark

double mm(double length_m) { return 1e3 * length_m; }

CalibrationPlan planOf(const Rig& rig, const CalibrateOptions& options) {
  if (options.tool == "hand" && !rig.viewers.front().hand) {
    throw std::runtime_error("the rig has no [hand] to touch corners with, expected --tool head");
  }
  const bool byHand = rig.viewers.front().hand && options.tool != "head";
  CalibrationPlan plan{
      .tool = byHand ? SensorChoice(*rig.viewers.front().hand) : rig.viewers.front().head.sensor,
      .corners = cornersOf(rig),
      .pivot = options.pivot,
      .sight = options.sight,
      .targets = {}};
  const std::vector<NamedCorner> all = plan.corners;
  const std::string& first = rig.walls.front().name;
  const std::string usual =
      fmt::format("{0}.upper_left,{0}.upper_right,{0}.lower_left,{0}.lower_right", first);
  try {
    plan.targets = chosenCorners(all, options.targets.value_or(usual));
    if (options.corners) plan.corners = chosenCorners(all, *options.corners);
  } catch (const std::invalid_argument& wrong) {
    throw std::runtime_error(wrong.what());
  }
  return plan;
}

/// The poses that a calibration finds.
struct Found {
  std::optional<Pose> roomFromTracker;
  std::optional<glm::dvec3> tip_m;
  std::optional<EyePlaces> eyes;
};

bool tellTip(const CalibrationData& data, Found& found) {
  if (!data.tip) return true;
  if (!data.tip->fault.empty()) {
    log::error(data.tip->fault);
    return false;
  }
  const PivotFit& fit = data.tip->fit;
  fmt::print(
      "tip: {:.1f} mm from the sensor; it moved by {:.2f} mm (rms) while the tool was turned; known to "
      "{:.2f} mm\n",
      mm(glm::length(fit.tip_m)), mm(fit.rms_m), mm(fit.tipError_m));
  found.tip_m = fit.tip_m;
  return true;
}

void tellCorners(const std::vector<Touch>& touches, const CornerFit& judged, const RoomAxes& axes) {
  if (judged.fit.misses_m.empty()) return;
  fmt::print("{:<28} {:>10} {:>8} {:>8} {:>8}\n", "corner", "misses mm", "right", "up", "ahead");
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const glm::dvec3& miss_m = judged.fit.misses_m[i];
    fmt::print("{:<28} {:>10.1f} {:>8.1f} {:>8.1f} {:>8.1f}\n", touches[i].corner.name,
               mm(glm::length(miss_m)), mm(glm::dot(miss_m, axes.right)), mm(glm::dot(miss_m, axes.up)),
               mm(glm::dot(miss_m, axes.forward)));
  }
  fmt::print("all: {:.2f} mm (rms); the tracker's lengths are {:.5f} times those of the room\n",
             mm(judged.fit.rms_m), 1.0 / judged.scale);
  if (!judged.flat) fmt::print("mirrored, they would miss by {:.0f} mm (rms)\n", mm(judged.mirroredRms_m));
}

void tellPlace(const TrackerSetup& tracker, const CornerFit& judged, const std::vector<Touch>& touches,
               const RoomAxes& axes) {
  const Pose& room = judged.fit.aFromB;
  fmt::print("tracker {}: its axes point {}\n", tracker.name, directionWords(room.orientation, axes));
  fmt::print("known to {:.2f} mm in the middle of the corners, and its turn to {:.3f} degrees\n",
             mm(judged.error.place_m), glm::degrees(judged.error.turn_rad));
  glm::dvec3 middle_m(0.0);
  for (const Touch& touch : touches) middle_m += touch.tip_m / static_cast<double>(touches.size());
  const glm::dquat turn =
      glm::normalize(room.orientation * glm::conjugate(tracker.roomFromTracker.orientation));
  fmt::print(
      "against the rig as it is, the middle of the corners moves by {:.1f} mm and all turns by {:.2f} "
      "degrees\n",
      mm(glm::distance(room * middle_m, tracker.roomFromTracker * middle_m)),
      glm::degrees(2.0 * std::atan2(glm::length(glm::dvec3(turn.x, turn.y, turn.z)), std::abs(turn.w))));
}

bool judgeCorners(const Rig& rig, const CalibrationPlan& plan, const CalibrationData& data, Found& found) {
  std::vector<Touch> touches;
  for (const HeldAt& held : data.touched) {
    touches.push_back({held.corner, held.rest.at_m, held.rest.pose.position_m});
  }
  const CornerFit judged = fitCorners(touches);
  tellCorners(touches, judged, rig.axes);
  if (data.noise_m > kQuiet_m) {
    log::warn(
        fmt::format("the tracker's poses scatter by {:.1f} mm from sample to sample, expected at most "
                    "{:.0f} mm",
                    mm(data.noise_m), mm(kQuiet_m)));
  }
  for (const std::string& remark : judged.remarks) log::warn(remark);
  for (const std::string& fault : judged.faults) log::error(fault);
  if (!judged.faults.empty()) return false;
  tellPlace(rig.trackers[plan.tool.tracker], judged, touches, rig.axes);
  found.roomFromTracker = judged.fit.aFromB;
  return true;
}

std::vector<Sighting> sightingsOf(const std::vector<HeldAt>& sighted, const Pose& roomFromHeadTracker,
                                  const glm::dvec3& markInRoom_m) {
  std::vector<Sighting> sightings;
  for (const HeldAt& held : sighted) {
    sightings.push_back({roomFromHeadTracker * held.rest.pose, markInRoom_m, held.corner.at_m});
  }
  return sightings;
}

bool judgeEyes(const Rig& rig, const CalibrationPlan& plan, const CalibrationData& data, Found& found) {
  if (!plan.sight) return true;
  if (!data.mark) {
    log::error("the mark was not touched, so that nothing is known of the eyes");
    return false;
  }
  for (const auto& sighted : data.sighted) {
    for (const HeldAt& held : sighted) {
      if (held.rest.hasOrientation) continue;
      log::error("the head's tracker sends no orientation, without which the eyes have no place on it");
      return false;
    }
  }
  const std::size_t headTracker = rig.viewers.front().head.sensor.tracker;
  const Pose room =
      headTracker == plan.tool.tracker ? *found.roomFromTracker : rig.trackers[headTracker].roomFromTracker;
  const glm::dvec3 mark_m = *found.roomFromTracker * data.mark->at_m;
  const EyePlaces eyes = fitEyes(sightingsOf(data.sighted[0], room, mark_m),
                                 sightingsOf(data.sighted[1], room, mark_m), rig.axes);
  for (const std::string& fault : eyes.faults) log::error(fault);
  if (!eyes.faults.empty()) return false;
  fmt::print(
      "eyes: {:.1f} mm apart; their lines of sight are missed by {:.1f} and {:.1f} mm (rms); known to "
      "{:.1f} and {:.1f} mm\n",
      mm(eyes.separation_m), mm(eyes.left.rms_m), mm(eyes.right.rms_m), mm(eyes.left.eyeError_m),
      mm(eyes.right.eyeError_m));
  found.eyes = eyes;
  return true;
}

/// Prints the lines for the rig, each below the table that it belongs to.
void tellLines(const PlacedRig& placed, const CalibrationPlan& plan, const Found& found) {
  const Rig& rig = placed.rig;
  fmt::print("\n# [[tracker]] {}\n{}\n", rig.trackers[plan.tool.tracker].name,
             poseLine("room_from_tracker", *found.roomFromTracker, placed.unit_m));
  if (found.eyes) {
    fmt::print("# [head]\neye_separation = {}\n{}\n", lengthText(found.eyes->separation_m, placed.unit_m),
               poseLine("eyes_from_sensor", found.eyes->eyesFromSensor, placed.unit_m));
  }
  const bool ofHand = rig.viewers.front().hand && rig.viewers.front().hand->tracker == plan.tool.tracker &&
                      rig.viewers.front().hand->sensor == plan.tool.sensor;
  if (!found.tip_m || !ofHand) return;
  // The hand's ray begins at the tip and keeps its direction.
  const glm::dquat& turn = rig.viewers.front().hand->handFromSensor.orientation;
  fmt::print("# [hand], so that its ray begins at the tip\n{}\n",
             poseLine("hand_from_sensor", {-(turn * *found.tip_m), turn}, placed.unit_m));
}

std::string namesOf(const std::vector<HeldAt>& all) {
  std::vector<std::string> names;
  for (const HeldAt& held : all) names.push_back(held.corner.name);
  return fmt::format("{}", fmt::join(names, ","));
}

/// Says which command gives the same from the recording: of points that were taken, not of those that were
/// skipped. Eyes that were sighted at different corners cannot be named in one command.
void tellHowToRedo(const CalibrateOptions& options, const CalibrationData& data) {
  if (!options.record || data.touched.empty()) return;
  std::string line = fmt::format("carom calibrate {} --from {} --corners {}", options.rig.string(),
                                 options.record->string(), namesOf(data.touched));
  if (options.tool) line += " --tool " + *options.tool;
  if (options.pivot) line += " --pivot";
  const std::string targets = namesOf(data.sighted[0]);
  if (data.mark && !targets.empty() && targets == namesOf(data.sighted[1]))
    line += " --sight --targets " + targets;
  log::note("The same again, from what was recorded: " + line);
}

}  // namespace

int runCalibrate(const CalibrateOptions& options) {
  const PlacedRig placed = readPlacedRig(options.rig);
  const CalibrationPlan plan = planOf(placed.rig, options);
  const CalibrationData data =
      options.from ? readCalibration(*options.from, plan) : takeCalibration(placed.rig, plan, options.record);
  tellHowToRedo(options, data);
  Found found;
  if (!tellTip(data, found) || !judgeCorners(placed.rig, plan, data, found)) return 1;
  const bool eyesFit = judgeEyes(placed.rig, plan, data, found);
  tellLines(placed, plan, found);
  return eyesFit ? 0 : 1;
}

void addCalibrate(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand(
      "calibrate", "Find where a tracker is in the room, from corners that are touched with its sensor");
  auto options = std::make_shared<CalibrateOptions>();
  command->add_option("RIG", options->rig, "Rig file")->required()->transform(shipped({"rigs"}));
  command
      ->add_option("--tool", options->tool, "Whose sensor touches: by default the hand's, if the rig has one")
      ->check(CLI::IsMember({"hand", "head"}));
  command
      ->add_option(
          "--corners", options->corners,
          "Corners in the order of touching, such as front.lower_left,front.lower_right; by default all")
      ->type_name("NAMES");
  command->add_flag("--pivot", options->pivot, "First find the tip of the tool, by turning it about its tip");
  auto* sight =
      command->add_flag("--sight", options->sight, "Also find the eyes, by looking along a mark at corners");
  command->add_option("--targets", options->targets, "Those corners; by default the four of the first wall")
      ->type_name("NAMES")
      ->needs(sight);
  auto* from =
      command
          ->add_option("--from", options->from,
                       "Take the points from recordings in this folder instead of live: corners.csv, "
                       "pivot.csv, sight-left.csv, sight-right.csv, where the points are the rests")
          ->type_name("DIR");
  command->add_option("--record", options->record, "Write what is taken to this folder")
      ->type_name("DIR")
      ->excludes(from);
  command->footer(
      "Examples:\n  carom calibrate my-cave --pivot --record points\n"
      "  carom calibrate my-cave --tool head --from points --corners "
      "front.lower_left,front.lower_right,front.upper_left,left.lower_left");
  command->callback([options, &status] { status = runCalibrate(*options); });
}

}  // namespace carom
