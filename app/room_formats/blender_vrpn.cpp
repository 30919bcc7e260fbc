#include "app/room_formats/blender_vrpn.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string_view>

#include "app/room_checks/foreign_room.h"
#include "app/room_parts/room_parts.h"

namespace carom {
namespace {

glm::dvec3 xyzOf(const Part& element, Room& room) {
  return {numberOr(element, "x", 0.0, room), numberOr(element, "y", 0.0, room),
          numberOr(element, "z", 0.0, room)};
}

/// Returns the pose of a <transformation>: a translation is multiplied from the right, a rotation from the
/// left (blender_cave/vrpn/configure/transformation.py). Angles are radians.
Pose transformationOf(const Part& whole, Room& room) {
  Pose pose;
  const Part* transformation = whole.find("transformation");
  for (const Part& step : partsOf(transformation)) {
    if (alike(step.name, "translate")) {
      step.isRead = true;
      pose = pose * Pose{xyzOf(step, room), {1.0, 0.0, 0.0, 0.0}};
    } else if (alike(step.name, "rotate")) {
      step.isRead = true;
      const glm::dvec3 axis = xyzOf(step, room);
      const double angle = numberOr(step, "angle", 0.0, room);
      if (!(glm::length(axis) > 1e-6)) {
        addError(room, step.at, "the axis of this rotation is of length 0");
        continue;
      }
      pose = Pose{{}, glm::angleAxis(angle, glm::normalize(axis))} * pose;
    }
  }
  return pose;
}

/// Returns the user whom a sensor is for; nothing if it is for none that is here.
std::optional<std::size_t> userOf(const Part& sensor, const std::map<std::string, std::size_t>& users) {
  for (const char* key : {"users", "user", "viewer", "viewers"}) {
    const auto known = users.find(sensor.textOf(key));
    if (known != users.end()) return known->second;
  }
  return {};
}

}  // namespace

void readBlenderVrpn(const Part& vrpn, const std::map<std::string, std::size_t>& users, Room& room) {
  for (const Part& device : vrpn.parts) {
    if (!alike(device.name, "tracker")) {
      if (device.parts.empty()) continue;
      device.markRead();
      addWarning(room, device.at,
                 fmt::format("the {} '{}' is left out: buttons and axes come with the tracker of a hand",
                             printable(device.name), printable(device.textOf("name"))));
      continue;
    }
    device.isRead = true;
    const std::string name = device.textOf("name");
    if (numberOr(device, "scale", 1.0, room) != 1.0)
      addWarning(room, device.placeOf("scale"),
                 "the tracker's scale is left out: Carom takes its lengths as metres");
    const auto tracker = addVrpn(name, fmt::format("{}@{}", name, device.textOf("host")),
                                 transformationOf(device, room), device.placeOf("host"), room);
    for (const Part* sensor : device.all("sensor")) {
      const int id =
          static_cast<int>(number(*sensor, "id", {.least = 0.0, .most = 65535.0}, true, room).value_or(0.0));
      const std::string method = sensor->textOf("processor_method");
      const auto user = userOf(*sensor, users);
      const Pose eyesInSensor = transformationOf(*sensor, room);
      if (!tracker) continue;
      if (user && method == "user_position" && !room.people[*user].isTracked) {
        room.people[*user].setup.head.sensor = {*tracker, id};
        room.people[*user].setup.head.eyesFromSensor = inverse(eyesInSensor);
        room.people[*user].isTracked = true;
      } else {
        addWarning(room, sensor->at,
                   fmt::format("sensor {} of tracker '{}' is left out: it places no user of this room", id,
                               printable(name)));
      }
    }
  }
}

}  // namespace carom
