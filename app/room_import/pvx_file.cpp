#include "app/room_import/pvx_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <span>
#include <string_view>

#include "app/room_checks/foreign_room.h"
#include "app/room_import/pvx_corners.h"
#include "app/room_import/xml_tree.h"

namespace carom {
namespace {

constexpr double kEyeSeparation_m = 0.065;  // ParaView's default
constexpr std::size_t kMostMachines = 512;
constexpr std::array<std::string_view, 12> kMachineKeys{
    "Name",       "Environment", "Geometry",  "LowerLeft",      "LowerRight", "UpperRight",
    "StereoType", "ViewerId",    "Coverable", "Show2DOverlays", "FullScreen", "ShowBorders"};

/// The state while a file is read.
struct PvxReading {
  XmlElement root;
  Room room;
  int rank = 0;                ///< of the next machine
  bool stereoLeftOut = false;  ///< a machine has said nothing of it
};

void noteUnknown(const XmlElement& element, std::span<const std::string_view> known, PvxReading& in) {
  for (const XmlAttribute& attribute : element.attributes) {
    if (std::find(known.begin(), known.end(), attribute.name) == known.end()) {
      addUnknownKey(in.room, attribute.nameAt, attribute.name, known);
    }
  }
}

/// Returns the element with the machines. Old files wrap them into <Process>: that of the server counts,
/// otherwise the last.
const XmlElement& processOf(PvxReading& in) {
  const XmlElement* process = &in.root;
  for (const XmlElement& child : in.root.children) {
    if (child.name != "Process") continue;
    noteUnknown(child, std::array<std::string_view, 1>{"Type"}, in);
    process = &child;
    const XmlAttribute* type = child.attribute("Type");
    if (type && type->value == "server") break;
  }
  return *process;
}

std::optional<double> numberOf(const XmlElement& element, std::string_view key, PvxReading& in) {
  const XmlAttribute* attribute = element.attribute(key);
  if (!attribute) {
    addError(in.room, element.at, fmt::format("{} is missing here", key));
    return {};
  }
  const auto value = wholeNumber(attribute->value);
  if (value && within(kNotNegative, *value)) return value;
  addError(in.room, attribute->valueAt,
           fmt::format("{} is '{}', expected {} and nothing else", key, printable(attribute->value),
                       wordsFor(kNotNegative, false)));
  return {};
}

void readViewers(const XmlElement& viewers, PvxReading& in) {
  constexpr std::array<std::string_view, 2> kKeys{"Id", "EyeSeparation"};
  noteUnknown(viewers, {}, in);
  for (const XmlElement& viewer : viewers.children) {
    if (viewer.name != "Viewer") {
      addUnknownKey(in.room, viewer.at, viewer.name, std::array<std::string_view, 1>{"Viewer"});
      continue;
    }
    noteUnknown(viewer, kKeys, in);
    const auto id = numberOf(viewer, "Id", in);
    const auto separation = numberOf(viewer, "EyeSeparation", in);
    if (!id || !separation || *id != 0.0) continue;
    in.room.eyeSeparation_m = *separation;
    in.room.eyeSeparationAt = viewer.attribute("EyeSeparation")->valueAt;
  }
}

StereoMode stereoOf(const XmlElement& machine, PvxReading& in) {
  struct Named {
    std::string_view name;
    StereoMode mode;
  };
  constexpr std::array<Named, 9> kModes{{{"Crystal Eyes", StereoMode::quadBuffer},
                                         {"Red-Blue", StereoMode::anaglyph},
                                         {"Anaglyph", StereoMode::anaglyph},
                                         {"Interlaced", StereoMode::interlaced},
                                         {"Left", StereoMode::left},
                                         {"Right", StereoMode::right},
                                         {"Checkerboard", StereoMode::checkerboard},
                                         {"SplitViewportHorizontal", StereoMode::sideBySide},
                                         {"Dresden", StereoMode::mono}}};
  const XmlAttribute* type = machine.attribute("StereoType");
  if (!type) {
    in.stereoLeftOut = true;
    return StereoMode::mono;
  }
  for (const Named& mode : kModes) {
    if (type->value != mode.name) continue;
    if (mode.name == "Dresden")
      addWarning(in.room, type->valueAt, "StereoType Dresden cannot be shown here; mono is taken");
    if (mode.name == "Red-Blue")
      in.room.assumptions.push_back("StereoType Red-Blue becomes anaglyph in red and cyan");
    return mode.mode;
  }
  std::string names;
  for (const Named& mode : kModes) names += fmt::format("{}'{}'", names.empty() ? "" : " or ", mode.name);
  addWarning(in.room, type->valueAt,
             fmt::format("StereoType is '{}', which ParaView passes over; mono is taken, expected {}",
                         printable(type->value), names));
  return StereoMode::mono;
}

void readViewerId(const XmlElement& machine, const std::string& wall, PvxReading& in) {
  const XmlAttribute* id = machine.attribute("ViewerId");
  if (!id) return;
  const auto value = wholeNumber(id->value);
  if (!value || *value < 0.0 || *value != std::floor(*value)) {
    addError(in.room, id->valueAt,
             fmt::format("ViewerId is '{}', expected a whole number from 0", printable(id->value)));
  } else if (*value > 0.0) {
    addWarning(
        in.room, id->valueAt,
        fmt::format("wall '{}' is for viewer {}, but one person is tracked here: it is drawn for that one",
                    wall, *value));
  }
}

void readDisplay(const XmlElement& machine, int rank, PvxReading& in) {
  const XmlAttribute* environment = machine.attribute("Environment");
  if (!environment) return;
  constexpr std::string_view kDisplay = "DISPLAY=";
  const std::size_t begin = environment->value.find(kDisplay);
  if (begin == std::string::npos) return;
  const std::string display = environment->value.substr(begin + kDisplay.size());
  const std::string shown = printable(display.substr(0, display.find_first_of(" \t")));
  if (shown.empty()) return;
  in.room.nodes.push_back({rank, shown});
  in.room.nodesAt.push_back(environment->valueAt);
}

/// Reads a window "640x360+100+1200". Returns false, with an error noted, if the text is anything else.
bool readWindow(const XmlElement& machine, Wall& wall, PvxReading& in) {
  const auto on = [&](std::string_view key) {
    const XmlAttribute* attribute = machine.attribute(key);
    return attribute && (attribute->value == "1" || attribute->value == "true");
  };
  wall.window.fullscreen = on("FullScreen");
  const XmlAttribute* geometry = machine.attribute("Geometry");
  if (!geometry || geometry->value.empty()) return true;
  std::array<int, 4> numbers{};
  constexpr std::array<char, 3> kBetween{'x', '+', '+'};
  const char *at = geometry->value.data(), *end = at + geometry->value.size();
  bool sound = true;
  for (std::size_t i = 0; i < numbers.size() && sound; ++i) {
    if (i > 0) sound = at != end && *at++ == kBetween[i - 1];
    if (!sound) break;
    const auto [stop, failed] = std::from_chars(at, end, numbers[i]);
    sound = failed == std::errc();
    at = stop;
  }
  const auto& [width, height, x, y] = numbers;
  sound = sound && at == end && width > 0 && height > 0 && width <= kMostPvxPixels &&
          height <= kMostPvxPixels && std::abs(x) <= 65536 && std::abs(y) <= 65536;
  if (!sound) {
    addError(in.room, geometry->valueAt,
             fmt::format("Geometry is '{}', expected WIDTHxHEIGHT+X+Y in pixels, such as 1920x1080+0+0",
                         printable(geometry->value)));
    return false;
  }
  wall.pixels = wall.window.size_px = {width, height};
  wall.window.position_px = {x, y};
  return true;
}

void readMachine(const XmlElement& machine, PvxReading& in) {
  if (static_cast<std::size_t>(in.rank) >= kMostMachines) {
    if (static_cast<std::size_t>(in.rank++) == kMostMachines) {
      addError(in.room, machine.at, fmt::format("there are more than {} machines", kMostMachines));
    }
    return;
  }
  noteUnknown(machine, kMachineKeys, in);
  RoomWall wall;
  wall.at.wall = machine.at;
  const auto valueAt = [&](std::string_view key) {
    const XmlAttribute* attribute = machine.attribute(key);
    return attribute ? attribute->valueAt : machine.at;
  };
  wall.at.name = valueAt("Name");
  wall.at.corner = valueAt("UpperRight");
  wall.at.pixels = wall.at.window = valueAt("Geometry");
  wall.at.node = machine.at;
  wall.wall.node = in.rank++;
  const XmlAttribute* name = machine.attribute("Name");
  wall.wall.name = rigName(in.room, name ? name->value : fmt::format("machine-{}", wall.wall.node));
  wall.wall.stereo = stereoOf(machine, in);
  readViewerId(machine, wall.wall.name, in);
  readDisplay(machine, wall.wall.node, in);
  const bool placed = readWindow(machine, wall.wall, in);
  if (!readCorners(machine, wall.wall, in.room) || !placed) return;
  if (wall.wall.pixels.x == 0) assumePixels(machine, wall.wall, in.room);
  in.room.walls.push_back(std::move(wall));
}

void readElement(const XmlElement& element, const XmlElement& parent, PvxReading& in) {
  constexpr std::array<std::string_view, 1> kValue{"Value"};
  constexpr std::array<std::string_view, 2> kOption{"Name", "Value"};
  constexpr std::array<std::string_view, 6> kElements{"Machine", "EyeSeparation",      "UseOffAxisProjection",
                                                      "Option",  "IndependentViewers", "Process"};
  if (element.name == "Machine") return readMachine(element, in);
  if (element.name == "EyeSeparation") {
    noteUnknown(element, kValue, in);
    if (const auto value = numberOf(element, "Value", in)) {
      in.room.eyeSeparation_m = *value;
      in.room.eyeSeparationAt = element.attribute("Value")->valueAt;
    }
  } else if (element.name == "UseOffAxisProjection") {
    noteUnknown(element, kValue, in);
    const XmlAttribute* value = element.attribute("Value");
    if (value && (value->value == "0" || value->value == "false")) {
      addWarning(in.room, value->valueAt,
                 "UseOffAxisProjection is off, which walls round a person cannot be drawn with; it is taken "
                 "as on");
    }
  } else if (element.name == "Option") {
    noteUnknown(element, kOption, in);
  } else if (element.name == "IndependentViewers") {
    readViewers(element, in);
  } else if (element.name != "Process" || &parent != &in.root) {
    addUnknownKey(in.room, element.at, element.name, kElements);
  }
}

void assume(PvxReading& in) {
  in.room.viewers = {{{0.0, 0.0, 0.0}, in.root.at, "a viewer at the origin"}};
  in.room.assumptions.push_back(
      "the viewer's eyes start at the file's origin, as in ParaView without a tracker");
  in.room.assumptions.push_back("each <Machine> is drawn by the MPI rank of its place in the file");
  in.room.assumptions.push_back("windows stand on monitor 0, at the place that Geometry says");
  if (in.stereoLeftOut) {
    in.room.assumptions.push_back(
        "walls without StereoType are mono: ParaView asks for stereo on its command line");
  }
}

}  // namespace

Room readPvx(const std::filesystem::path& file) {
  PvxReading in{readXml(file), foreignRoom(file, "a ParaView room")};
  if (in.root.name != "pvx") {
    addError(in.room, in.root.at,
             fmt::format("the first element is <{}>, expected <pvx>", printable(in.root.name)));
    return std::move(in.room);
  }
  in.room.eyeSeparation_m = kEyeSeparation_m;
  in.room.eyeSeparationAt = in.root.at;
  const XmlElement& process = processOf(in);
  noteUnknown(in.root, {}, in);
  for (const XmlElement& element : process.children) readElement(element, process, in);
  if (in.rank == 0) addError(in.room, in.root.at, "there is no wall here, expected one <Machine> at least");
  assume(in);
  return std::move(in.room);
}

}  // namespace carom
