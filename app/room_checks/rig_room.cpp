#include "app/room_checks/rig_room.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/rig/traces.h"

namespace carom {

namespace {

Viewer eyesAtStart(const Rig& rig, const ViewerSetup& viewer, const FilePlace& at) {
  const TrackerSetup& tracker = rig.trackers[viewer.head.sensor.tracker];
  const Pose eyesInSensor = inverse(viewer.head.eyesFromSensor);
  if (tracker.kind == TrackerKind::recorded) {
    constexpr std::uintmax_t kBeginning = 1U << 20U;
    const std::vector<TrackerSample> samples = readBeginning(tracker.source, kBeginning);
    const auto first = std::find_if(samples.begin(), samples.end(), [&](const TrackerSample& sample) {
      return sample.sensor == viewer.head.sensor.sensor;
    });
    if (first != samples.end()) {
      return {(tracker.roomFromTracker * first->pose * eyesInSensor).position_m, at,
              "the recorded head at its start"};
    }
  }
  const glm::dvec3 standing_m = rig.axes.up * kStandingEyes_m;
  if (tracker.kind != TrackerKind::simulated) {
    return {standing_m, at, "someone standing on the origin"};
  }
  const Pose person{standing_m, {1.0, 0.0, 0.0, 0.0}};
  return {(tracker.roomFromTracker * person * eyesInSensor).position_m, at,
          "the simulated person at the start"};
}

}  // namespace

Room roomOf(const PlacedRig& placed, const std::filesystem::path& file) {
  const Rig& rig = placed.rig;
  Room room;
  room.file = file;
  room.title = rig.title;
  room.format = "a rig";
  room.axes = rig.axes;
  for (std::size_t i = 0; i < rig.walls.size(); ++i) room.walls.push_back({rig.walls[i], placed.walls[i]});
  room.nodes = rig.nodes;
  room.nodesAt = placed.nodes;
  room.oneWindow = rig.oneWindow;
  room.eyeSeparation_m = rig.viewers.front().head.eyeSeparation_m;
  room.eyeSeparationAt = placed.eyeSeparation;
  room.unit_m = placed.unit_m;
  for (const ViewerSetup& viewer : rig.viewers) {
    Viewer& eyes = room.viewers.emplace_back(eyesAtStart(rig, viewer, placed.head));
    if (rig.viewers.size() > 1) eyes.words = fmt::format("{}: {}", viewer.name, eyes.words);
  }
  room.floor_m = 0.0;
  return room;
}

}  // namespace carom
