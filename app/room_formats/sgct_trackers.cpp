#include "app/room_formats/sgct_trackers.h"

#include <fmt/format.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <optional>

#include "app/room_checks/foreign_room.h"
#include "app/room_parts/room_parts.h"

namespace carom {
namespace {

glm::dvec3 vectorAt(const Part& whole, std::string_view name, std::array<std::string_view, 3> keys,
                    Room& room) {
  const Part* part = whole.find(name);
  if (!part) return glm::dvec3(0.0);
  return {numberOr(*part, keys[0], 0.0, room), numberOr(*part, keys[1], 0.0, room),
          numberOr(*part, keys[2], 0.0, room)};
}

/// Returns the pose of offset and orientation: turned by −yaw about y, by pitch about x and by −roll about z,
/// or by a quaternion.
Pose sgctPose(const Part& whole, Room& room) {
  Pose pose{vectorAt(whole, "offset", {"x", "y", "z"}, room), {1.0, 0.0, 0.0, 0.0}};
  const Part* turn = whole.find("orientation");
  if (const Part* quaternion = turn && turn->find("w") ? turn : whole.find("quaternion")) {
    const glm::dvec3 xyz(numberOr(*quaternion, "x", 0.0, room), numberOr(*quaternion, "y", 0.0, room),
                         numberOr(*quaternion, "z", 0.0, room));
    const glm::dquat q(numberOr(*quaternion, "w", 1.0, room), xyz);
    if (glm::length(q) > 0.5) pose.orientation = glm::normalize(q);
  } else if (turn) {
    const glm::dvec3 a = glm::radians(vectorAt(whole, "orientation", {"yaw", "pitch", "roll"}, room));
    pose.orientation = glm::angleAxis(-a.x, glm::dvec3(0, 1, 0)) * glm::angleAxis(a.y, glm::dvec3(1, 0, 0)) *
                       glm::angleAxis(-a.z, glm::dvec3(0, 0, 1));
  }
  if (const Part* matrix = whole.find("matrix"))
    addWarning(room, matrix->at, "the matrix of a tracker is left out: measure its room_from_tracker");
  return pose;
}

/// Reads a device of a tracker: the head's if the user names it, the hand's if its name says so.
void readDevice(const Part& tracker, const Part& device, const Part* user, Room& room) {
  const std::string name = device.textOf("name");
  const Part* tracking = user ? user->find("tracking") : nullptr;
  const bool isHead =
      tracking && tracking->textOf("tracker") == tracker.textOf("name") && tracking->textOf("device") == name;
  const bool isHand = alike(name, "wand") || alike(name, "hand");
  const Part* sensors = device.find("sensors");
  const Part* sensor = sensors && !sensors->parts.empty() ? &sensors->parts.front() : nullptr;
  if (!sensor || (!isHead && !isHand)) {
    device.markRead();
    return addWarning(
        room, device.at,
        fmt::format("device '{}' of tracker '{}' is left out: it is neither the first user's head nor a "
                    "wand",
                    printable(name), printable(tracker.textOf("name"))));
  }
  sensor->isRead = true;
  const int number = static_cast<int>(
      carom::number(*sensor, "identifier", {.least = 0.0, .most = 65535.0}, true, room).value_or(0.0));
  const auto index = addVrpn(tracker.textOf("name"), sensor->textOf("vrpnaddress"), sgctPose(tracker, room),
                             sensor->placeOf("vrpnaddress"), room);
  if (!index) return;
  const Pose bodyInSensor = sgctPose(device, room);
  ViewerSetup& viewer = room.people.front().setup;
  if (isHead) {
    viewer.head.sensor = {*index, number};
    viewer.head.eyesFromSensor = inverse(bodyInSensor);
    room.people.front().isTracked = true;
  } else {
    viewer.hand = HandSetup{{*index, number}, inverse(bodyInSensor), {}};
  }
}

}  // namespace

void addSgctTrackers(const JsonNode& root, Room& room) {
  const JsonNode* list = root.member("trackers");
  if (!list || list->children.empty() || room.viewers.size() != 1) return;
  const JsonNode* users = root.member("users");
  const std::optional<Part> user =
      users && !users->children.empty() ? std::optional(partOf(users->children.front())) : std::nullopt;
  Person person;
  person.setup.head.eyeSeparation_m = room.eyeSeparation_m;
  room.people.push_back(std::move(person));
  const Part trackers = partOf(*list);
  for (const Part& tracker : trackers.parts) {
    tracker.isRead = true;
    if (const Part* scale = tracker.find("scale"); scale && scale->text != "1")
      addWarning(room, scale->textAt, "the tracker's scale is left out: Carom takes its lengths as metres");
    const Part* devices = tracker.find("devices");
    for (const Part& device : partsOf(devices)) {
      device.isRead = true;
      readDevice(tracker, device, user ? &*user : nullptr, room);
    }
  }
  if (const JsonNode* place =
          users && !users->children.empty() ? users->children.front().member("pos") : nullptr)
    leaveOutPlace(0, place->at, room);
  nameUnread(trackers, {}, room);
}

}  // namespace carom
