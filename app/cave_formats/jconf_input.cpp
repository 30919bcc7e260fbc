#include "app/cave_formats/jconf_input.h"

#include <fmt/format.h>

#include <array>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <optional>
#include <set>
#include <string_view>

#include "app/room_checks/foreign_room.h"
#include "app/room_parts/room_parts.h"

namespace carom {
namespace {

constexpr double kInterocular_m = 0.069;  // VR Juggler's default

/// What a chain of position filters does: room = pre · sensor · post, the sensor's lengths in `unit_m`.
struct JconfFilter {
  Pose pre, post;
  double unit_m = 1.0;
  FilePlace unitAt{};
};

Pose poseOf(const Part& filter, std::string_view translate, std::string_view rotate, Room& room) {
  Pose pose;
  const auto moved = filter.all(translate), turned = filter.all(rotate);
  if (!moved.empty()) {
    if (const auto at = vectorOf(moved, filter.at, translate, room)) pose.position_m = *at;
  }
  if (turned.empty()) return pose;
  if (const auto turn_deg = vectorOf(turned, filter.at, rotate, room)) {
    const glm::dvec3 turn = glm::radians(*turn_deg);
    // gmtl::EulerAngleXYZ: the matrix is Rx·Ry·Rz (PositionXformFilter.cpp of VR Juggler).
    pose.orientation = glm::angleAxis(turn.x, glm::dvec3(1, 0, 0)) *
                       glm::angleAxis(turn.y, glm::dvec3(0, 1, 0)) *
                       glm::angleAxis(turn.z, glm::dvec3(0, 0, 1));
  }
  return pose;
}

/// Reads the filters of a device or proxy.
JconfFilter filterOf(const Part& element, Room& room) {
  JconfFilter whole;
  for (const Part* filters : element.all("position_filters")) {
    for (const Part& filter : filters->parts) {
      filter.isRead = true;
      whole.pre = poseOf(filter, "pre_translate", "pre_rotation", room) * whole.pre;
      whole.post = whole.post * poseOf(filter, "post_translate", "post_rotation", room);
      const double scale = number(filter, "device_units", {}, false, room).value_or(1.0);
      const double custom = number(filter, "custom_scale", {}, false, room).value_or(1.0);
      whole.unit_m *= scale == 0.0 ? custom : scale;
      whole.unitAt = filter.placeOf("device_units");
    }
  }
  return whole;
}

class JconfInput {
 public:
  JconfInput(const Part& elements, Room& room) : elements_(elements), room_(room) {}

  std::map<std::string, std::size_t> read() {
    std::map<std::string, std::size_t> index;
    const glm::dvec3 standing_m = kStandingEyes_m * room_.axes.up;
    refuseTwins(elements_.all("user"), "name", room_);
    for (const Part* user : elements_.all("user")) {
      const std::string name = user->textOf("name");
      if (room_.people.size() >= kMostViewers) {
        addWarning(room_, user->at,
                   fmt::format("user '{}' is left out: a rig has at most {} viewers", printable(name),
                               kMostViewers));
        continue;
      }
      const double apart_m =
          number(*user, "interocular_distance", kNotNegative, false, room_).value_or(kInterocular_m);
      const std::size_t person = addPerson(name, apart_m, standing_m, user->placeOf("interocular_distance"),
                                           "someone standing on the origin", room_);
      index.emplace(name, person);
      if (const auto sensor = sensorOf(user->textOf("head_position"), user->placeOf("head_position"))) {
        room_.people[person].setup.head.sensor = sensor->choice;
        room_.people[person].setup.head.eyesFromSensor = inverse(sensor->post);
        room_.people[person].isTracked = true;
      }
    }
    if (room_.people.empty())
      addPerson("viewer", kInterocular_m, standing_m, elements_.at, "someone standing on the origin", room_);
    if (const auto wand = hasProxy("VJWand") ? sensorOf("VJWand", elements_.at) : std::nullopt)
      room_.people.front().setup.hand = HandSetup{wand->choice, inverse(wand->post), {}};
    nameOthers();
    return index;
  }

 private:
  struct JconfSensor {
    SensorChoice choice;
    Pose post;
  };

  const Part* named(std::string_view kind, const std::string& name) const {
    for (const Part* element : elements_.all(kind)) {
      if (element->textOf("name") == name) return element;
    }
    return nullptr;
  }

  bool hasProxy(const std::string& name) const {
    return named("alias", name) || named("position_proxy", name);
  }

  /// Follows an alias to its proxy and the proxy to its device. Returns nothing, with a warning noted, if the
  /// device is none that is known here.
  std::optional<JconfSensor> sensorOf(std::string name, FilePlace at) {
    if (const Part* alias = named("alias", name)) name = alias->textOf("proxy");
    const Part* proxy = named("position_proxy", name);
    if (!proxy) {
      addWarning(room_, at,
                 fmt::format("there is no position_proxy '{}': it has no tracker", printable(name)));
      return {};
    }
    used_.insert(proxy);
    const std::string device = proxy->textOf("device");
    const JconfFilter ofProxy = filterOf(*proxy, room_);
    const int unit =
        static_cast<int>(number(*proxy, "unit", {.least = 0.0, .most = 65535.0}, true, room_).value_or(0.0));
    for (const Part& element : elements_.parts) {
      if (element.textOf("name") != device || alike(element.name, "position_proxy")) continue;
      element.isRead = true;
      return sensorOn(element, ofProxy, unit);
    }
    addWarning(room_, proxy->placeOf("device"),
               fmt::format("there is no device '{}' here: the tracker of '{}' is left out", printable(device),
                           printable(name)));
    return {};
  }

  std::optional<JconfSensor> sensorOn(const Part& device, const JconfFilter& ofProxy, int unit) {
    const JconfFilter ofDevice = filterOf(device, room_);
    const Pose roomFromTracker = ofProxy.pre * ofDevice.pre;
    const std::string name = device.textOf("name");
    std::optional<std::size_t> tracker;
    if (alike(device.name, "vrpn")) {
      const char* key = device.find("tracker_server") ? "tracker_server" : "tracker_name";
      tracker = addVrpn(name, device.textOf(key), roomFromTracker, device.placeOf(key), room_);
    } else if (alike(device.name, "dtrack") || alike(device.name, "dtrack_standalone")) {
      const char* key = device.find("server_port") ? "server_port" : "port";
      const auto port = number(device, key, {.least = 1.0, .most = 65535.0}, true, room_);
      tracker = addDtrack(name, static_cast<int>(port.value_or(5000.0)), roomFromTracker, device.placeOf(key),
                          room_);
    } else if (alike(device.name, "trackd_sensor")) {
      tracker = trackdOf(device, ofDevice, roomFromTracker);
    } else {
      if (told_.insert(&device).second) {
        device.markRead();
        addWarning(
            room_, device.at,
            fmt::format("the device '{}' of kind '{}' is none that Carom has: a simulated person stands for "
                        "what it tracks",
                        printable(name), printable(device.name)));
      }
      return {};
    }
    if (!tracker) return {};
    if (ofDevice.unit_m != 1.0 && room_.trackers[*tracker].kind != TrackerKind::trackd) {
      addWarning(
          room_, ofDevice.unitAt,
          fmt::format("the lengths of device '{}' are {} m: Carom takes those of its own protocol, which are "
                      "metres",
                      printable(name), ofDevice.unit_m));
    }
    const Pose& known = room_.trackers[*tracker].roomFromTracker;
    if (glm::distance(known.position_m, roomFromTracker.position_m) > 1e-6 ||
        std::abs(glm::dot(known.orientation, roomFromTracker.orientation)) < 1.0 - 1e-9) {
      addWarning(
          room_, device.at,
          fmt::format("the proxies of device '{}' place it differently: the first counts", printable(name)));
    }
    const Pose post = ofDevice.post * ofProxy.post;
    return JconfSensor{{*tracker, unit}, post};
  }

  /// The sensors' shared memory, with that of the wand if the file has one.
  std::optional<std::size_t> trackdOf(const Part& device, const JconfFilter& filter,
                                      const Pose& roomFromTracker) {
    constexpr Range kKey{.least = 1.0, .most = 2147483647.0};
    const auto keyOf = [&](const Part& memory, double usual) {
      return static_cast<int>(number(memory, "shared_memory_key", kKey, true, room_).value_or(usual));
    };
    TrackdMemory memory;
    memory.sensors = keyOf(device, 4126.0);
    for (const Part* wand : elements_.all("trackd_controller")) memory.wand = keyOf(*wand, 4127.0);
    const auto unit_m = rigUnit_m(filter.unit_m, filter.unitAt, room_);
    if (!unit_m) return {};
    memory.unit_m = *unit_m;
    return addTrackd(device.textOf("name"), memory, roomFromTracker, device.at, room_);
  }

  /// Names the unused proxies; their aliases are names alone.
  void nameOthers() {
    for (const Part* alias : elements_.all("alias")) alias->markRead();
    for (const Part* proxy : elements_.all("position_proxy")) {
      if (used_.contains(proxy)) continue;
      proxy->markRead();
      addWarning(room_, proxy->at,
                 fmt::format("position_proxy '{}' is left out: it is neither a user's head nor the wand",
                             printable(proxy->textOf("name"))));
    }
  }

  const Part& elements_;
  Room& room_;
  std::set<const Part*> told_, used_;
};

}  // namespace

std::map<std::string, std::size_t> readJconfUsers(const Part& elements, Room& room) {
  return JconfInput(elements, room).read();
}

}  // namespace carom
