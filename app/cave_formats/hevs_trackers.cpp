#include "app/cave_formats/hevs_trackers.h"

#include <fmt/format.h>

#include <string_view>

#include "app/cave_formats/hevs_screen.h"
#include "app/room_checks/foreign_room.h"
#include "app/room_parts/room_parts.h"

namespace carom {
namespace {

/// Returns the turn from a tracker's axes to the room's; none, with a warning noted, if no rig can say it.
/// Without a word HEVS takes its own axes: x right, y up, z forward, left-handed.
glm::dquat axesOf(const Part& tracker, Room& room) {
  const auto axis = [&](const char* name, const char* usual) {
    const Part* part = tracker.find(name);
    return part ? part->text : std::string(usual);
  };
  const Part* handedness = tracker.find("handedness");
  const glm::dquat none(1.0, 0.0, 0.0, 0.0);
  if (handedness && alike(handedness->text, "left")) {
    addWarning(room, handedness->textAt,
               fmt::format("tracker '{}' is left-handed, which no rig says: measure its room_from_tracker",
                           printable(tracker.name)));
    return none;
  }
  if (handedness && !alike(handedness->text, "right"))
    addWarning(room, handedness->textAt,
               fmt::format("handedness is '{}', expected left or right: right is taken",
                           printable(handedness->text)));
  return turnOfAxes(axis("right", "X"), axis("up", "Y"), axis("forward", handedness ? "Z" : "-Z"), tracker.at,
                    room)
      .value_or(none);
}

}  // namespace

void readHevsTrackers(const Part& platform, const std::string& headName, Room& room) {
  const Part* trackers = platform.find("trackers");
  for (const Part& tracker : partsOf(trackers)) {
    tracker.isRead = true;
    const std::string& name = tracker.name;
    if (!alike(tracker.textOf("type"), "vrpn")) {
      tracker.markRead();
      addWarning(room, tracker.at,
                 fmt::format("tracker '{}' of type '{}' is left out: it is no VRPN", printable(name),
                             printable(tracker.textOf("type"))));
      continue;
    }
    if (!flagOr(tracker, "apply_rotation", true, room))
      addWarning(room, tracker.placeOf("apply_rotation"),
                 fmt::format("tracker '{}' places without turning in the file: here it turns, too",
                             printable(name)));
    const Pose roomFromTracker = hevsPlaceOf(tracker, platform, room) * Pose{{}, axesOf(tracker, room)};
    const auto index =
        addVrpn(name, tracker.textOf("address"), roomFromTracker, tracker.placeOf("address"), room);
    if (!index) continue;
    Person& person = room.people.front();
    if (name == headName || (headName.empty() && alike(name, "head"))) {
      person.setup.head.sensor = {*index, 0};
      person.isTracked = true;
    } else if (alike(name, "wand") || alike(name, "hand")) {
      person.setup.hand = HandSetup{{*index, 0}, {}, {}};
    }
  }
}

}  // namespace carom
