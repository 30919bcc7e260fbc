#include "app/cave_formats/cover_input.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "app/cave_formats/cover_config.h"
#include "app/room_checks/foreign_room.h"
#include "app/room_parts/room_parts.h"

namespace carom {
namespace {

constexpr double kEyes_m = 0.064;  // COVER's default separation is 64 mm
constexpr int kDtrackPort = 5000, kFirstFlystick = 100;
constexpr std::array<std::string_view, 14> kQuietCoverInput{
    "MouseNav", "name",         "DebugButtons",  "DebugTracking", "DebugStation",      "value",
    "Joystick", "ButtonSystem", "ButtonAddress", "HeadOnly",      "InterpolationFile", "buttons",
    "MultiPC",  "default"};

glm::dvec3 xyzOf(const Part& part, std::array<std::string_view, 3> names, Room& room) {
  return {numberOr(part, names[0], 0.0, room), numberOr(part, names[1], 0.0, room),
          numberOr(part, names[2], 0.0, room)};
}

class CoverInput {
 public:
  CoverInput(const Part& cover, Room& room) : cover_(cover), room_(room) {}

  void read() {
    const Part* input = cover_.find("Input");
    const Part* persons = input ? input->find("Persons") : nullptr;
    const Part* chosen = nullptr;
    std::vector<const Part*> all = persons ? persons->all("Person") : std::vector<const Part*>();
    for (const Part* person : all) {
      if (!chosen || flagOr(*person, "default", false, room_)) chosen = person;
    }
    addViewer(chosen);
    for (const Part* person : all) {
      if (person == chosen) continue;
      person->markRead();
      addWarning(room_, person->at,
                 fmt::format("person '{}' is left out: '{}' is the one who is tracked",
                             printable(person->textOf("name")), printable(chosen->textOf("name"))));
    }
    if (!input) return;
    readTrackers(*input, chosen);
    if (const Part* position = cover_.find("ViewerPosition")) leaveOutPlace(0, position->at, room_);
    for (const char* group : {"Buttons", "Valuator"}) {
      const Part* found = input->find(group);
      if (!found || found->parts.empty()) continue;
      found->markRead();
      addWarning(room_, found->at,
                 fmt::format("{} is left out: buttons and axes come with the tracker of the hand", group));
    }
    nameUnread(*input, kQuietCoverInput, room_);
  }

 private:
  void readTrackers(const Part& input, const Part* chosen) {
    if (chosen) {
      readBodies(input, *chosen);
    } else if (const Part* system = input.find("TrackingSystem")) {
      readOld(input, *system);
    }
  }

  void addViewer(const Part* person) {
    double apart_m = kEyes_m;
    FilePlace at = cover_.at;
    for (const char* key : {"value", "enable"}) {
      const Part* stereo = cover_.find("Stereo");
      if (stereo && !flagOr(*stereo, key, true, room_))
        addWarning(room_, stereo->placeOf(key),
                   "Stereo is off in the file: walls keep the modes of their channels");
    }
    if (const Part* stereo = cover_.find("Stereo"); stereo && stereo->find("separation")) {
      const auto apart_mm = number(*stereo, "separation", kNotNegative, false, room_);
      apart_m = apart_mm ? *apart_mm * kCoverUnit_m : apart_m;
      at = stereo->placeOf("separation");
    }
    if (person && person->find("eyeDistance")) {
      const auto apart_mm = number(*person, "eyeDistance", kNotNegative, false, room_);
      apart_m = apart_mm ? *apart_mm * kCoverUnit_m : apart_m;
      at = person->placeOf("eyeDistance");
    }
    glm::dvec3 eyes_m(0.0);
    if (const Part* position = cover_.find("ViewerPosition"))
      eyes_m = kCoverUnit_m * xyzOf(*position, {"x", "y", "z"}, room_);
    addPerson(
        person ? person->textOf("name") : "viewer", apart_m, eyes_m, at,
        cover_.find("ViewerPosition") ? "the viewer at ViewerPosition" : "a viewer at the file's origin",
        room_);
  }

  /// Returns a body's tracker and sensor, or nothing with a warning noted.
  std::optional<SensorChoice> sensorOf(const Part& input, const Part& body) {
    const Part* devices = input.find("Device");
    const std::string name = body.textOf("device");
    const Part* device = devices ? devices->find(name) : nullptr;
    if (name.empty()) {
      addWarning(room_, body.at,
                 fmt::format("body '{}' has no device: it stays where it is", printable(body.name)));
      return {};
    }
    if (!device) {
      addWarning(room_, body.placeOf("device"),
                 fmt::format("there is no device '{}': body '{}' has no tracker", printable(name),
                             printable(body.name)));
      return {};
    }
    const auto tracker = trackerOf(*device);
    if (!tracker) return {};
    return SensorChoice{*tracker, indexOf(body)};
  }

  std::optional<std::size_t> trackerOf(const Part& device) {
    const std::string driver = device.textOf("driver");
    const Pose roomFromTracker = coverPose(device, room_);
    if (alike(driver, "dtrack")) {
      const auto port = number(device, "port", {.least = 1.0, .most = 65535.0}, true, room_);
      if (const Part* host = device.find("serverHost")) {
        addWarning(
            room_, host->textAt,
            fmt::format("DTRACK's controller {} is left out: it has to send to this computer by itself",
                        printable(host->text)));
      }
      return addDtrack(device.name, static_cast<int>(port.value_or(double{kDtrackPort})), roomFromTracker,
                       device.at, room_);
    }
    if (alike(driver, "vrpn")) {
      std::string sender = device.textOf("tracker");
      if (sender.empty()) sender = device.textOf("device");
      if (sender.empty()) sender = "Tracker0";
      std::string server = device.textOf("server");
      if (server.empty()) server = device.textOf("host");
      if (server.empty()) server = "localhost";
      return addVrpn(device.name, sender + "@" + server, roomFromTracker, device.at, room_);
    }
    if (alike(driver, "cavelib")) return trackdOf(device, roomFromTracker);
    if (alike(driver, "natnet")) {
      const std::string server = device.textOf("server");
      device.find("local");
      return addTracker(
          {.name = device.name,
           .kind = TrackerKind::natnet,
           .source = fmt::format("udp://{}?group=239.255.42.99", server.empty() ? "127.0.0.1" : server),
           .roomFromTracker = roomFromTracker},
          device.at, room_);
    }
    device.markRead();
    addWarning(room_, device.at,
               fmt::format("device '{}' by the driver '{}' is none that Carom has: it is left out",
                           printable(device.name), printable(driver)));
    return {};
  }

  /// CAVELib's shared memory, with COVER's defaults (CAVELIBDriver.cpp).
  std::optional<std::size_t> trackdOf(const Part& device, const Pose& roomFromTracker) {
    constexpr Range kKey{.least = 1.0, .most = 2147483647.0};
    TrackdMemory memory;
    memory.sensors = static_cast<int>(number(device, "SHMID", kKey, true, room_).value_or(4126.0));
    memory.wand = static_cast<int>(number(device, "wandSHMID", kKey, true, room_).value_or(4127.0));
    if (const Part* unit = device.find("unit")) {
      const auto unit_m = rigUnit_m(metresOf(*unit), unit->textAt, room_);
      if (!unit_m) return {};
      memory.unit_m = *unit_m;
    }
    if (!flagOr(device, "Yup", true, room_))
      addWarning(
          room_, device.placeOf("Yup"),
          fmt::format("device '{}' turns about z first, which no rig says: measure its room_from_tracker",
                      printable(device.name)));
    return addTrackd(device.name, memory, roomFromTracker, device.at, room_);
  }

  /// A unit by its name, or as millimetres.
  double metresOf(const Part& unit) {
    constexpr std::array<std::pair<std::string_view, double>, 6> kUnits{
        {{"feet", 0.3048}, {"mm", 0.001}, {"m", 1.0}, {"cm", 0.01}, {"dm", 0.1}, {"inch", 0.0254}}};
    for (const auto& [name, metres] : kUnits) {
      if (alike(unit.text, name)) return metres;
    }
    return kCoverUnit_m * numberOf(unit, {}, false, room_).value_or(0.0);
  }

  /// Returns the number of a sensor: bodies count as they are, F1 is the first Flystick.
  int indexOf(const Part& body) {
    const Part* index = body.find("bodyIndex");
    if (!index) return 0;
    std::string_view text = index->text;
    const bool isFlystick = !text.empty() && (text[0] == 'F' || text[0] == 'f');
    if (isFlystick) text.remove_prefix(1);
    const auto value = wholeNumber(text);
    if (!value || !within({.least = 0.0, .most = 65000.0}, *value)) {
      addError(
          room_, index->textAt,
          fmt::format("bodyIndex is '{}', expected a whole number, or F and one", printable(index->text)));
      return 0;
    }
    if (isFlystick)
      room_.assumptions.push_back(fmt::format("bodyIndex {} is DTRACK's Flystick of that number, line {}",
                                              printable(index->text), index->at.line));
    return static_cast<int>(*value) + (isFlystick ? kFirstFlystick : 0);
  }

  void readBodies(const Part& input, const Part& person) {
    const Part* bodies = input.find("Body");
    if (!bodies) return;
    Person& viewer = room_.people.front();
    if (const Part* head = bodies->find(person.textOf("head"))) {
      const Pose headInSensor = coverPose(*head, room_);
      if (const auto sensor = sensorOf(input, *head)) {
        viewer.setup.head.sensor = *sensor;
        viewer.setup.head.eyesFromSensor = inverse(headInSensor);
        viewer.isTracked = true;
      }
    }
    if (const Part* hand = bodies->find(person.textOf("hand"))) {
      const Pose handInSensor = coverPose(*hand, room_);
      if (const auto sensor = sensorOf(input, *hand))
        viewer.setup.hand = HandSetup{*sensor, inverse(handInSensor), {}};
    }
  }

  /// Reads the form of before 2014: one TrackingSystem, and the sensors' numbers.
  void readOld(const Part& input, const Part& system) {
    if (!alike(system.textOf("value"), "DTRACK")) {
      system.markRead();
      return addWarning(room_, system.at,
                        fmt::format("the tracking system '{}' is none that Carom has: it is left out",
                                    printable(system.textOf("value"))));
    }
    const auto tracker = addDtrack("dtrack", kDtrackPort, coverPose(system, room_), system.at, room_);
    room_.assumptions.push_back(
        fmt::format("DTRACK sends to port {}: the file says none, line {}", kDtrackPort, system.at.line));
    const auto addressOf = [&](const char* name) -> std::optional<int> {
      const Part* part = input.find(name);
      const auto value =
          part ? number(*part, "value", {.least = 0.0, .most = 65535.0}, true, room_) : std::nullopt;
      return value ? std::optional(static_cast<int>(*value)) : std::nullopt;
    };
    if (!tracker) return;
    Person& viewer = room_.people.front();
    if (const auto address = addressOf("HeadAddress")) {
      viewer.setup.head.sensor = {*tracker, *address};
      viewer.isTracked = true;
      if (const Part* device = input.find("HeadDevice"))
        viewer.setup.head.eyesFromSensor = inverse(coverPose(*device, room_));
    }
    if (const auto address = addressOf("HandAddress")) {
      viewer.setup.hand = HandSetup{{*tracker, *address}, {}, {}};
      if (const Part* device = input.find("HandDevice"))
        viewer.setup.hand->handFromSensor = inverse(coverPose(*device, room_));
    }
  }

  const Part& cover_;
  Room& room_;
};

}  // namespace

Pose coverPose(const Part& whole, Room& room) {
  Pose pose;
  if (const Part* offset = whole.find("Offset"))
    pose.position_m = kCoverUnit_m * xyzOf(*offset, {"x", "y", "z"}, room);
  if (const Part* turn = whole.find("Orientation")) {
    const glm::dvec3 hpr = glm::radians(xyzOf(*turn, {"h", "p", "r"}, room));
    pose.orientation = glm::angleAxis(hpr.x, glm::dvec3(0, 0, 1)) *
                       glm::angleAxis(hpr.y, glm::dvec3(1, 0, 0)) *
                       glm::angleAxis(hpr.z, glm::dvec3(0, 1, 0));
  }
  return pose;
}

void readCoverInput(const Part& cover, Room& room) { CoverInput(cover, room).read(); }

}  // namespace carom
