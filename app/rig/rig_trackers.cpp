#include "app/rig/rig_trackers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "app/file_keys/rig_keys.h"
#include "app/toml/toml_values.h"
#include "devices/network/dtrack_tracker.h"
#include "devices/setup/force_factory.h"
#include "devices/setup/tracker_factory.h"

namespace carom {
namespace {

/// Reads and checks the source of a tracker's samples.
std::filesystem::path readSource(const TomlFile& file, const TomlTable& table, TrackerKind kind,
                                 const RoomAxes& axes) {
  const TrackerRow& row = rowOf(kind);
  if (row.source == SourceUse::trace)
    return file.existingFile(table, "source", InputKind::trace, Reach::anywhere);
  if (row.source == SourceUse::none) {
    table.refuse("source", fmt::format("has no meaning for a {} tracker, expected none", row.name));
    return {};
  }
  if (row.source == SourceUse::maybeAddress && !table.has("source")) return {};
  const std::string source = table.text("source");
  if (source.empty()) return {};  // has been reported
  try {
    TrackerSetup setup;
    setup.kind = kind;
    setup.source = source;
    row.make(setup, axes);
  } catch (const std::invalid_argument& wrong) {
    table.fault("source", wrong.what());
  }
  return source;
}

/// Reads whether the session starts DTRACK, for which the source must name the controller.
bool readStart(const TomlTable& table, const std::filesystem::path& source) {
  const bool start = table.flag("start");
  try {
    if (!start || source.empty() || readDtrackSource(source.string()).controller) return start;
  } catch (const std::invalid_argument&) {
    return start;  // has been reported
  }
  table.fault("start",
              "the source does not say which controller to start, expected one such as "
              "'udp://0.0.0.0:5000?controller=10.0.0.7'");
  return start;
}

constexpr const char* kUsualValues = "x y z qx qy qz qw";

std::optional<OscPattern> readPattern(const TomlTable& table, std::string_view key, bool hasIndex) {
  if (!table.has(key)) return {};
  try {
    return OscPattern(table.text(key), hasIndex);
  } catch (const std::invalid_argument& wrong) {
    table.fault(key, wrong.what());
    return {};
  }
}

std::vector<OscValue> readValues(const TomlTable& table) {
  const std::string words = table.text("values", kUsualValues);
  try {
    return readOscValues(words);
  } catch (const std::invalid_argument& wrong) {
    table.fault("values", wrong.what());
    return {};
  }
}

/// Reads which messages of Open Sound Control are what.
OscMapping readOscMapping(const TomlTable& tracker) {
  const auto table = tracker.requiredTable("osc");
  if (!table) return {};
  if (!table->has("pose") && !table->has("buttons") && !table->has("axes")) {
    tracker.fault("osc", "names no message, expected pose, buttons or axes");
  }
  return {.pose = readPattern(*table, "pose", false),
          .values = readValues(*table),
          .unit_m = kMetresPerUnit[table->choice("unit")],
          .buttons = readPattern(*table, "buttons", true),
          .axes = readPattern(*table, "axes", true)};
}

/// Reads what the device calls its sensors 0, 1, ….
std::vector<std::string> readNames(const TomlTable& table) {
  std::vector<std::string> names;
  for (const PlacedText& name : table.texts("names")) {
    if (std::find(names.begin(), names.end(), name.text) != names.end()) {
      table.fault(name.place, fmt::format("'{}' is there twice, expected each name once", name.text));
    }
    names.push_back(name.text);
  }
  return names;
}

/// Refuses the keys that other kinds have for themselves.
void refuseOthersKeys(const TomlTable& table, const TrackerRow& own) {
  for (const TrackerRow& other : trackerRows()) {
    if (other.ownKey.empty() || other.ownKey == own.ownKey) continue;
    std::vector<std::string_view> kinds;
    for (const TrackerRow& row : trackerRows()) {
      if (row.ownKey == other.ownKey) kinds.push_back(row.name);
    }
    if (kinds.front() != other.name) continue;  // has been refused
    table.refuse(other.ownKey,
                 fmt::format("has a meaning for {} alone, expected none", fmt::join(kinds, " and ")));
  }
}

/// Returns the index of the tracker that a key names; beyond the last one if there is none of that name.
std::size_t readTrackerName(const TomlTable& table, std::string_view key,
                            const std::vector<TrackerSetup>& trackers) {
  const std::string name = table.text(key);
  const auto found = std::find_if(trackers.begin(), trackers.end(),
                                  [&](const auto& tracker) { return tracker.name == name; });
  if (found == trackers.end() && table.has(key) && !name.empty()) {
    std::vector<std::string> names;
    for (const TrackerSetup& tracker : trackers) names.push_back(tracker.name);
    table.fault(
        key, names.empty()
                 ? fmt::format("there is no tracker '{}', expected a [[tracker]] of that name", name)
                 : fmt::format("there is no tracker '{}', expected '{}'", name, fmt::join(names, "' or '")));
  }
  return static_cast<std::size_t>(found - trackers.begin());
}

/// Reads `tracker` and `sensor` of the head or the hand.
SensorChoice readSensor(const TomlTable& table, const std::vector<TrackerSetup>& trackers) {
  return {.tracker = readTrackerName(table, "tracker", trackers), .sensor = table.integer("sensor")};
}

void checkForceDevice(const TomlTable& table, const ForceSetup& setup) {
  const ForceRow& row = rowOf(setup.kind);
  if (setup.kind == ForceKind::simulated) {
    table.refuse("source", "has no meaning for a simulated force device, expected none");
  } else if (setup.source.empty() && row.needsSource) {
    table.fault("source", fmt::format("source is missing, expected the address of the {} device", row.name));
  } else {
    try {
      checkForceSource(setup);
    } catch (const std::invalid_argument& wrong) {
      table.fault("source", wrong.what());
    }
  }
}

}  // namespace

TrackerSetup readTracker(const TomlFile& file, const TomlTable& table, double unit_m, const RoomAxes& axes) {
  TrackerSetup tracker;
  tracker.name = table.text("name");
  tracker.kind = trackerRows()[table.choice("kind")].kind;
  tracker.source = readSource(file, table, tracker.kind, axes);
  const TrackerRow& row = rowOf(tracker.kind);
  refuseOthersKeys(table, row);
  if (row.ownKey == "person") tracker.person = static_cast<SimulatedMotion>(table.choice("person"));
  if (row.ownKey == "start") tracker.start = readStart(table, tracker.source);
  if (row.ownKey == "unit") tracker.unit_m = kMetresPerUnit[table.choice("unit")];
  if (row.ownKey == "names") tracker.names = readNames(table);
  if (row.ownKey == "osc") tracker.osc = readOscMapping(table);
  tracker.latency_s = table.number("latency_ms") * 1e-3;
  tracker.roomFromTracker = readPose(table, "room_from_tracker", unit_m);
  return tracker;
}

HandSetup readHand(const TomlTable& table, const std::vector<TrackerSetup>& trackers, double unit_m) {
  HandSetup hand{readSensor(table, trackers), readPose(table, "hand_from_sensor", unit_m)};
  if (!table.has("buttons")) return hand;
  const auto isSpaceMouse = [&](std::size_t tracker) {
    return tracker < trackers.size() && trackers[tracker].kind == TrackerKind::spaceMouse;
  };
  const std::size_t buttons = readTrackerName(table, "buttons", trackers);
  if (isSpaceMouse(buttons)) {
    table.fault("buttons", "a spacemouse steers and holds no cue, expected a tracker with buttons of a hand");
  } else if (isSpaceMouse(hand.tracker)) {
    table.fault("buttons", "a hand on a spacemouse has no place to hold a cue in, expected no buttons");
  }
  if (buttons != hand.tracker) hand.buttons = buttons;
  return hand;
}

HeadSetup readHead(const TomlTable& table, const std::vector<TrackerSetup>& trackers, double unit_m) {
  HeadSetup head;
  constexpr double kWidestEyes_m = 1.0;
  head.sensor = readSensor(table, trackers);
  if (head.sensor.tracker < trackers.size() &&
      trackers[head.sensor.tracker].kind == TrackerKind::spaceMouse) {
    table.fault("tracker", "a spacemouse sends no poses, expected a tracker that does");
  }
  head.eyeSeparation_m =
      table.numberOr("eye_separation", head.eyeSeparation_m / unit_m, kWidestEyes_m / unit_m) * unit_m;
  head.eyesFromSensor = readPose(table, "eyes_from_sensor", unit_m);
  return head;
}

std::optional<ForceSetup> readForce(const TomlTable& hand, double unit_m) {
  const auto table = hand.table("force");
  if (!table) return {};
  ForceSetup setup;
  setup.kind = forceRows()[table->choice("kind")].kind;
  if (setup.kind != ForceKind::simulated && table->has("source")) setup.source = table->text("source");
  checkForceDevice(*table, setup);
  setup.forceMax_n = table->numberOr("force_max_n", setup.forceMax_n);
  if (setup.kind != ForceKind::simulated && !table->has("force_max_n"))
    table->fault(table->place(),
                 "force_max_n is missing, expected the strongest force of the device in newtons");
  if (table->has("stiffness_max_n_m")) setup.stiffnessMax_n_m = table->number("stiffness_max_n_m");
  setup.d0_m = table->number("d0_m");
  setup.roomFromDevice = readPose(*table, "room_from_device", unit_m);
  return setup;
}

void followForceDevices(Rig& rig) {
  for (ViewerSetup& viewer : rig.viewers) {
    if (!viewer.force || viewer.hand || viewer.force->kind != ForceKind::vrpn) continue;
    TrackerSetup tracker;
    tracker.name = "force device of " + viewer.name;
    tracker.kind = TrackerKind::vrpn;
    tracker.source = viewer.force->source;
    tracker.roomFromTracker = viewer.force->roomFromDevice;
    viewer.hand = HandSetup{{rig.trackers.size(), 0}, {}};
    rig.trackers.push_back(tracker);
  }
}

}  // namespace carom
