#include "app/room_import/pvx_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <locale>
#include <numbers>
#include <optional>
#include <span>
#include <sstream>
#include <string_view>

#include "app/room_import/foreign_room.h"
#include "app/room_import/xml_tree.h"
#include "cave/room/rectangle.h"

namespace carom {

namespace {

constexpr double kEyeSeparation_m = 0.065;  // ParaView's own
constexpr int kMostPixels = 16384;
constexpr std::size_t kMostMachines = 512;
// What ParaView draws a machine without corners with: a camera of 30 degrees. We hang that picture up here.
constexpr double kViewAngle_rad = 30.0 * std::numbers::pi / 180.0;
constexpr double kAssumedDistance_m = 1.0;
constexpr int kAssumedHeight_px = 1080;

constexpr std::array<std::string_view, 3> kCorners{"LowerLeft", "LowerRight", "UpperRight"};
constexpr std::array<std::string_view, 12> kMachineKeys{
    "Name",       "Environment", "Geometry",  "LowerLeft",      "LowerRight", "UpperRight",
    "StereoType", "ViewerId",    "Coverable", "Show2DOverlays", "FullScreen", "ShowBorders"};

/// One of the three numbers of a corner, or what stands there instead.
struct Token {
  std::string text;
  FilePlace at;
  std::optional<double> value;
};

std::vector<Token> tokensOf(const XmlAttribute& attribute) {
  std::vector<Token> tokens;
  const std::string& text = attribute.value;
  for (std::size_t i = 0; (i = text.find_first_not_of(" \t\r\n", i)) != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_of(" \t\r\n", i), text.size());
    Token token{text.substr(i, end - i), attribute.valueAt, {}};
    token.at.column += static_cast<int>(i);
    token.value = wholeNumber(token.text);
    if (token.value && !within({}, *token.value)) token.value.reset();
    tokens.push_back(std::move(token));
    i = end;
  }
  return tokens;
}

/// As ParaView reads a corner: each number up to the first letter that fits none, zeros from there on.
glm::dvec3 asParaViewReads(const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  glm::dvec3 corner_m(0.0);
  stream >> corner_m.x;
  stream >> corner_m.y;
  stream >> corner_m.z;
  return corner_m;
}

/// The value of one coordinate that makes the three corners a rectangle; none where it does not matter or no
/// value does. Corner 1 is where the right angle is.
std::optional<double> valueThatFits(const std::array<glm::dvec3, 3>& corners_m, std::size_t corner, int axis,
                                    double near) {
  const glm::dvec3 &a = corners_m[0], &m = corners_m[1], &b = corners_m[2];
  double others = 0.0;  // of (a − m)·(b − m), without the axis in question
  for (int i = 0; i < 3; ++i) {
    if (i != axis) others += (a[i] - m[i]) * (b[i] - m[i]);
  }
  std::vector<double> roots;
  if (corner == 1) {  // (a − v)(b − v) + others = 0
    const double middle = 0.5 * (a[axis] + b[axis]), half = 0.5 * (a[axis] - b[axis]);
    const double square = half * half - others;
    if (square >= 0.0) roots = {middle - std::sqrt(square), middle + std::sqrt(square)};
  } else {  // (v − m) other + others = 0
    const double other = corners_m[2 - corner][axis] - m[axis];
    if (std::abs(other) >= kShortestEdge_m) roots = {m[axis] - others / other};
  }
  std::optional<double> best;
  for (const double root : roots) {
    std::array<glm::dvec3, 3> tried = corners_m;
    tried[corner][axis] = root;
    const bool wall = glm::distance(tried[0], tried[1]) >= kShortestEdge_m &&
                      glm::distance(tried[1], tried[2]) >= kShortestEdge_m;
    if (wall && (!best || std::abs(root - near) < std::abs(*best - near))) best = root;
  }
  return best;
}

/// What reading the file as ParaView does would have done to the wall; empty where the other corners do not
/// tell.
std::string harmOf(const std::array<const XmlAttribute*, 3>& texts,
                   const std::array<std::vector<Token>, 3>& tokens, std::size_t corner, int axis) {
  std::array<glm::dvec3, 3> corners_m;
  for (std::size_t i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      const auto& value = tokens[i][static_cast<std::size_t>(k)].value;
      if (!value && (i != corner || k != axis)) return {};
      corners_m[i][k] = value.value_or(0.0);
    }
  }
  const glm::dvec3 taken_m = asParaViewReads(texts[corner]->value);
  const auto fitting = valueThatFits(corners_m, corner, axis, taken_m[axis]);
  if (!fitting) return {};
  glm::dvec3 meant_m = corners_m[corner];
  meant_m[axis] = *fitting;
  corners_m[corner] = taken_m;
  const double moved_m = glm::distance(taken_m, meant_m);
  const double second_m = glm::distance(corners_m[1], corners_m[2]);
  if (!(moved_m > 0.0 && glm::distance(corners_m[0], corners_m[1]) > 0.0 && second_m > 0.0)) return {};
  const double miss_m = std::abs(squareMiss_m(corners_m));
  return fmt::format(
      "; ParaView takes it for {} without a word: the other corners make it {:.6g}, so this corner would be "
      "{:.4g} mm off and the wall {:.3g} mm ({:.2f} degrees) out of square",
      taken_m[axis], *fitting, moved_m * 1e3, miss_m * 1e3,
      std::asin(std::min(1.0, miss_m / second_m)) * 180.0 / std::numbers::pi);
}

class PvxReader {
 public:
  explicit PvxReader(const std::filesystem::path& file)
      : root_(readXml(file)), room_(foreignRoom(file, "a ParaView room")) {}

  Room read() {
    if (root_.name != "pvx") {
      addError(room_, root_.at,
               fmt::format("the first element is <{}>, expected <pvx>", printable(root_.name)));
      return std::move(room_);
    }
    room_.eyeSeparation_m = kEyeSeparation_m;
    room_.eyeSeparationAt = root_.at;
    const XmlElement& process = processOf();
    noteUnknown(root_, {});
    for (const XmlElement& element : process.children) readElement(element, process);
    if (rank_ == 0) addError(room_, root_.at, "there is no wall here, expected one <Machine> at least");
    assume();
    return std::move(room_);
  }

 private:
  /// Files of old wrap the machines into <Process>; the server's count, or the last.
  const XmlElement& processOf() {
    const XmlElement* process = &root_;
    for (const XmlElement& child : root_.children) {
      if (child.name != "Process") continue;
      noteUnknown(child, std::array<std::string_view, 1>{"Type"});
      process = &child;
      const XmlAttribute* type = child.attribute("Type");
      if (type && type->value == "server") break;
    }
    return *process;
  }

  void noteUnknown(const XmlElement& element, std::span<const std::string_view> known) {
    for (const XmlAttribute& attribute : element.attributes) {
      if (std::find(known.begin(), known.end(), attribute.name) == known.end()) {
        addUnknownKey(room_, attribute.nameAt, attribute.name, known);
      }
    }
  }

  void readElement(const XmlElement& element, const XmlElement& parent) {
    constexpr std::array<std::string_view, 1> kValue{"Value"};
    constexpr std::array<std::string_view, 2> kOption{"Name", "Value"};
    constexpr std::array<std::string_view, 6> kElements{
        "Machine", "EyeSeparation", "UseOffAxisProjection", "Option", "IndependentViewers", "Process"};
    if (element.name == "Machine") return readMachine(element);
    if (element.name == "EyeSeparation") {
      noteUnknown(element, kValue);
      if (const auto value = numberOf(element, "Value")) {
        room_.eyeSeparation_m = *value;
        room_.eyeSeparationAt = element.attribute("Value")->valueAt;
      }
    } else if (element.name == "UseOffAxisProjection") {
      noteUnknown(element, kValue);
      const XmlAttribute* value = element.attribute("Value");
      if (value && (value->value == "0" || value->value == "false")) {
        addWarning(
            room_, value->valueAt,
            "UseOffAxisProjection is off, which walls round a person cannot be drawn with; it is taken "
            "as on");
      }
    } else if (element.name == "Option") {
      noteUnknown(element, kOption);
    } else if (element.name == "IndependentViewers") {
      readViewers(element);
    } else if (element.name != "Process" || &parent != &root_) {
      addUnknownKey(room_, element.at, element.name, kElements);
    }
  }

  std::optional<double> numberOf(const XmlElement& element, std::string_view key) {
    const XmlAttribute* attribute = element.attribute(key);
    if (!attribute) {
      addError(room_, element.at, fmt::format("{} is missing here", key));
      return {};
    }
    const auto value = wholeNumber(attribute->value);
    if (value && within(kNotNegative, *value)) return value;
    addError(room_, attribute->valueAt,
             fmt::format("{} is '{}', expected {} and nothing else", key, printable(attribute->value),
                         wordsFor(kNotNegative, false)));
    return {};
  }

  void readViewers(const XmlElement& viewers) {
    constexpr std::array<std::string_view, 2> kKeys{"Id", "EyeSeparation"};
    noteUnknown(viewers, {});
    for (const XmlElement& viewer : viewers.children) {
      if (viewer.name != "Viewer") {
        addUnknownKey(room_, viewer.at, viewer.name, std::array<std::string_view, 1>{"Viewer"});
        continue;
      }
      noteUnknown(viewer, kKeys);
      const auto id = numberOf(viewer, "Id");
      const auto separation = numberOf(viewer, "EyeSeparation");
      if (!id || !separation || *id != 0.0) continue;
      room_.eyeSeparation_m = *separation;
      room_.eyeSeparationAt = viewer.attribute("EyeSeparation")->valueAt;
    }
  }

  void readMachine(const XmlElement& machine) {
    if (static_cast<std::size_t>(rank_) >= kMostMachines) {
      if (static_cast<std::size_t>(rank_++) == kMostMachines) {
        addError(room_, machine.at, fmt::format("there are more than {} machines", kMostMachines));
      }
      return;
    }
    noteUnknown(machine, kMachineKeys);
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
    wall.wall.node = rank_++;
    const XmlAttribute* name = machine.attribute("Name");
    wall.wall.name = rigName(room_, name ? name->value : fmt::format("machine-{}", wall.wall.node));
    wall.wall.stereo = stereoOf(machine);
    readViewerId(machine, wall.wall.name);
    readDisplay(machine, wall.wall.node);
    const bool placed = readWindow(machine, wall.wall);
    if (!readCorners(machine, wall.wall) || !placed) return;
    if (wall.wall.pixels.x == 0) assumePixels(machine, wall.wall);
    room_.walls.push_back(std::move(wall));
  }

  StereoMode stereoOf(const XmlElement& machine) {
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
      stereoLeftOut_ = true;
      return StereoMode::mono;
    }
    for (const Named& mode : kModes) {
      if (type->value != mode.name) continue;
      if (mode.name == "Dresden")
        addWarning(room_, type->valueAt, "StereoType Dresden cannot be shown here; mono is taken");
      if (mode.name == "Red-Blue")
        room_.assumptions.push_back("StereoType Red-Blue becomes anaglyph in red and cyan");
      return mode.mode;
    }
    std::string names;
    for (const Named& mode : kModes) names += fmt::format("{}'{}'", names.empty() ? "" : " or ", mode.name);
    addWarning(room_, type->valueAt,
               fmt::format("StereoType is '{}', which ParaView passes over; mono is taken, expected {}",
                           printable(type->value), names));
    return StereoMode::mono;
  }

  void readViewerId(const XmlElement& machine, const std::string& wall) {
    const XmlAttribute* id = machine.attribute("ViewerId");
    if (!id) return;
    const auto value = wholeNumber(id->value);
    if (!value || *value < 0.0 || *value != std::floor(*value)) {
      addError(room_, id->valueAt,
               fmt::format("ViewerId is '{}', expected a whole number from 0", printable(id->value)));
    } else if (*value > 0.0) {
      addWarning(
          room_, id->valueAt,
          fmt::format("wall '{}' is for viewer {}, but one person is tracked here: it is drawn for that one",
                      wall, *value));
    }
  }

  void readDisplay(const XmlElement& machine, int rank) {
    const XmlAttribute* environment = machine.attribute("Environment");
    if (!environment) return;
    constexpr std::string_view kDisplay = "DISPLAY=";
    const std::size_t begin = environment->value.find(kDisplay);
    if (begin == std::string::npos) return;
    const std::string display = environment->value.substr(begin + kDisplay.size());
    const std::string shown = printable(display.substr(0, display.find_first_of(" \t")));
    if (shown.empty()) return;
    room_.nodes.push_back({rank, shown});
    room_.nodesAt.push_back(environment->valueAt);
  }

  /// "640x360+100+1200". False, with an error noted, where it is something else.
  bool readWindow(const XmlElement& machine, Wall& wall) {
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
    sound = sound && at == end && width > 0 && height > 0 && width <= kMostPixels && height <= kMostPixels &&
            std::abs(x) <= 65536 && std::abs(y) <= 65536;
    if (!sound) {
      addError(room_, geometry->valueAt,
               fmt::format("Geometry is '{}', expected WIDTHxHEIGHT+X+Y in pixels, such as 1920x1080+0+0",
                           printable(geometry->value)));
      return false;
    }
    wall.pixels = wall.window.size_px = {width, height};
    wall.window.position_px = {x, y};
    return true;
  }

  /// False, with errors noted, where the corners make no wall.
  bool readCorners(const XmlElement& machine, Wall& wall) {
    std::array<const XmlAttribute*, 3> texts{};
    int given = 0;
    for (std::size_t i = 0; i < 3; ++i) given += (texts[i] = machine.attribute(kCorners[i])) != nullptr;
    if (given == 0) {
      hangUp(machine, wall);
      return true;
    }
    bool sound = true;
    std::array<std::vector<Token>, 3> tokens;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!texts[i]) {
        addError(room_, machine.at,
                 fmt::format(
                     "{} is missing at wall '{}', expected all three corners: ParaView drops the other two "
                     "without a word",
                     kCorners[i], wall.name));
        sound = false;
        continue;
      }
      tokens[i] = tokensOf(*texts[i]);
      if (tokens[i].size() == 3) continue;
      addError(room_, texts[i]->valueAt,
               fmt::format("{} of wall '{}' has {} value{}, expected 3 numbers", kCorners[i], wall.name,
                           tokens[i].size(), tokens[i].size() == 1 ? "" : "s"));
      sound = false;
    }
    if (!sound || !readNumbers(texts, tokens, wall.name)) return false;
    const auto corner = [&](std::size_t i) {
      return glm::dvec3(*tokens[i][0].value, *tokens[i][1].value, *tokens[i][2].value);
    };
    const ThreeCorners corners{{corner(0), corner(1), corner(2)}, kCorners};
    wall.lowerLeft_m = corner(0);
    wall.lowerRight_m = corner(1);
    wall.upperLeft_m = corner(0) + (corner(2) - corner(1));
    if (const auto fault = rectangleFault(wall.name, corners)) {
      addError(room_, texts[fault->corner]->valueAt, fault->what);
      return false;
    }
    return true;
  }

  bool readNumbers(const std::array<const XmlAttribute*, 3>& texts,
                   const std::array<std::vector<Token>, 3>& tokens, const std::string& wall) {
    bool sound = true;
    for (std::size_t i = 0; i < 3; ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        const Token& token = tokens[i][static_cast<std::size_t>(axis)];
        if (token.value) continue;
        sound = false;
        const bool number = wholeNumber(token.text).has_value();
        addError(room_, token.at,
                 fmt::format("'{}' in {} of wall '{}' is {}, expected {}{}", printable(token.text),
                             kCorners[i], wall, number ? "out of range" : "no number",
                             number ? wordsFor({}, false) : "a number and nothing else",
                             harmOf(texts, tokens, i, axis)));
      }
    }
    return sound;
  }

  /// A machine without corners shows ParaView's ordinary view.
  void hangUp(const XmlElement& machine, Wall& wall) {
    if (wall.pixels.x == 0) wall.pixels = wall.window.size_px = {kAssumedHeight_px, kAssumedHeight_px};
    const double up_m = kAssumedDistance_m * std::tan(0.5 * kViewAngle_rad);
    const double right_m = up_m * wall.pixels.x / wall.pixels.y;
    wall.lowerLeft_m = {-right_m, -up_m, -kAssumedDistance_m};
    wall.lowerRight_m = {right_m, -up_m, -kAssumedDistance_m};
    wall.upperLeft_m = {-right_m, up_m, -kAssumedDistance_m};
    const std::string what = fmt::format(
        "machine '{}' has no corners, so where its screen stands is unknown; it is taken to hang {:.0f} mm "
        "ahead of "
        "the eyes, {:.0f} × {:.0f} mm: ParaView's view angle of 30 degrees",
        wall.name, kAssumedDistance_m * 1e3, 2e3 * right_m, 2e3 * up_m);
    addWarning(room_, machine.at, what);
    room_.assumptions.push_back(what);
  }

  void assumePixels(const XmlElement& machine, Wall& wall) {
    const double width_m = glm::distance(wall.lowerLeft_m, wall.lowerRight_m);
    const double height_m = glm::distance(wall.lowerLeft_m, wall.upperLeft_m);
    const double width_px = kAssumedHeight_px * width_m / height_m;
    wall.pixels = {static_cast<int>(std::lround(std::clamp(width_px, 1.0, double{kMostPixels}))),
                   kAssumedHeight_px};
    wall.window.size_px = wall.pixels;
    const std::string what = fmt::format("machine '{}' has no Geometry; {} × {} pixels are taken", wall.name,
                                         wall.pixels.x, wall.pixels.y);
    addWarning(room_, machine.at, what);
    room_.assumptions.push_back(what);
  }

  void assume() {
    room_.viewer = {{0.0, 0.0, 0.0}, root_.at, "a viewer at the origin"};
    room_.assumptions.push_back(
        "the viewer's eyes start at the file's origin, as in ParaView without a tracker");
    room_.assumptions.push_back("each <Machine> is drawn by the MPI rank of its place in the file");
    room_.assumptions.push_back("windows stand on monitor 0, at the place that Geometry says");
    if (stereoLeftOut_) {
      room_.assumptions.push_back(
          "walls without StereoType are mono: ParaView asks for stereo on its command line");
    }
  }

  XmlElement root_;
  Room room_;
  int rank_ = 0;
  bool stereoLeftOut_ = false;
};

}  // namespace

Room readPvx(const std::filesystem::path& file) { return PvxReader(file).read(); }

}  // namespace carom
