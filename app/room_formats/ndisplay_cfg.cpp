#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <string_view>

#include "app/room_checks/foreign_room.h"
#include "app/room_formats/ndisplay_file.h"
#include "app/room_formats/ndisplay_scene.h"

namespace carom {
namespace {

constexpr std::string_view kBlankInLine = " \t\r";
constexpr std::size_t kMostCfgParts = 100'000;

/// Returns the number behind "X=" or "P=" in a text such as "X=1,Y=2,Z=3"; 0 if it is not there.
double partOfTriple(const Part& text, char letter, Room& room) {
  std::string_view rest = text.text;
  while (!rest.empty()) {
    const std::string_view piece = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), piece.size() + 1));
    const std::size_t begin = piece.find_first_not_of(kBlankInLine);
    if (begin == std::string_view::npos || std::toupper(static_cast<unsigned char>(piece[begin])) != letter)
      continue;
    const std::size_t sign = piece.find('=');
    std::string_view number = sign == std::string_view::npos ? "" : piece.substr(sign + 1);
    const std::string_view whole = number;
    if (number.starts_with('+')) number.remove_prefix(1);
    const auto value = wholeNumber(number.substr(0, number.find_last_not_of(kBlankInLine) + 1));
    if (value && within({}, *value)) return *value;
    addError(room, text.textAt,
             fmt::format("'{}' in {} is no number, expected {}=, a number and nothing else",
                         printable(std::string(whole)), printable(text.name), letter));
    return 0.0;
  }
  return 0.0;
}

glm::dvec3 tripleOf(const Part& line, std::string_view name, std::string_view letters, Room& room) {
  glm::dvec3 values(0.0);
  const Part* text = line.find(name);
  if (!text) return values;
  for (int i = 0; i < static_cast<int>(letters.size()); ++i)
    values[i] = partOfTriple(*text, letters[static_cast<std::size_t>(i)], room);
  return values;
}

/// Reads the lines of one file into a room.
class CfgReading {
 public:
  CfgReading(const Part& root, Room& room) : root_(root), room_(room), scene_(room), ranks_(room) {}

  void read() {
    for (const char* kind : {"scene_node", "screen", "camera"}) {
      for (const Part* line : root_.all(kind)) readComponent(*line, kind);
    }
    refuseTwins(root_.all("viewport"), "id", room_);
    refuseTwins(root_.all("input"), "id", room_);
    for (const Part* line : root_.all("viewport")) viewports_[line->textOf("id")] = line;
    findHead();
    readPeople();
    for (const bool isMaster : {true, false}) {
      for (const Part* node : root_.all("cluster_node")) {
        if (flagOr(*node, "master", false, room_) == isMaster) readNode(*node);
      }
    }
    ranks_.finish();
    scene_.tellUnused(screens_, head_);
    constexpr std::array<std::string_view, 8> kQuietCfg{"port_cs", "port_ss", "sound",   "info",
                                                        "version", "general", "network", "custom"};
    nameUnread(root_, kQuietCfg, room_);
  }

 private:
  void readComponent(const Part& line, std::string_view kind) {
    SceneNode node{.id = line.textOf("id"), .parent = line.textOf("parent")};
    node.at = line.at;
    node.parentAt = line.placeOf("parent");
    node.isTracked = !line.textOf("tracker_id").empty();
    node.local.position_m = tripleOf(line, "loc", "XYZ", room_);
    const glm::dvec3 turn_deg = tripleOf(line, "rot", "PYR", room_);
    node.local.matrix = unrealRotation(turn_deg.x, turn_deg.y, turn_deg.z);
    if (kind == "screen") {
      if (!line.find("size"))
        addError(room_, line.at, fmt::format("size is missing in screen '{}'", printable(node.id)));
      const glm::dvec3 size_m = tripleOf(line, "size", "XY", room_);
      node.width_m = size_m.x;
      node.height_m = size_m.y;
      screens_.push_back(node.id);
    }
    if (kind == "camera") cameraParent_ = node.parent;
    node.isCamera = kind == "camera";
    scene_.add(std::move(node));
  }

  /// The head is the tracked component on which the camera hangs, unless all screens do, too.
  void findHead() {
    if (cameraParent_.empty()) return;
    const SceneNode* head = scene_.find(cameraParent_);
    const bool all = std::all_of(screens_.begin(), screens_.end(), [&](const std::string& screen) {
      return scene_.hangsOn(screen, cameraParent_);
    });
    if (head && !all) head_ = cameraParent_;
  }

  void readPeople() {
    double apart_m = 0.064;  // nDisplay's default
    FilePlace at = root_.at;
    for (const Part* stereo : root_.all("stereo")) {
      apart_m = number(*stereo, "eye_dist", kNotNegative, false, room_).value_or(apart_m);
      at = stereo->placeOf("eye_dist");
      swapsEyes_ = flagOr(*stereo, "eye_swap", false, room_);
      if (swapsEyes_)
        addWarning(room_, stereo->placeOf("eye_swap"), "eye_swap: the eyes of all walls change places");
    }
    addPerson("viewer", apart_m, kStandingEyes_m * room_.axes.up, at, "someone standing on the origin",
              room_);
    for (const Part* input : root_.all("input")) readInput(*input);
    for (const Part* line : root_.all("scene_node")) assignTracker(*line);
  }

  void readInput(const Part& input) {
    const std::string id = input.textOf("id");
    if (!alike(input.textOf("type"), "tracker")) {
      input.markRead();
      return addWarning(room_, input.at,
                        fmt::format("input '{}' of type '{}' is left out: buttons and axes come with the "
                                    "tracker of a hand",
                                    printable(id), printable(input.textOf("type"))));
    }
    Pose roomFromTracker{turned(tripleOf(input, "loc", "XYZ", room_)), {1.0, 0.0, 0.0, 0.0}};
    const glm::dvec3 turn_deg = tripleOf(input, "rot", "PYR", room_);
    const auto turn =
        turnOfAxes(input.textOf("right"), input.textOf("up"), input.textOf("front"), input.at, room_);
    if (turn) roomFromTracker.orientation = turnedRotation(turn_deg) * *turn;
    if (const auto tracker = addVrpn(id, input.textOf("addr"), roomFromTracker, input.placeOf("addr"), room_))
      trackers_[id] = *tracker;
  }

  /// Returns the rotation of Unreal's axes as one of axes with x right, y up, z back.
  static glm::dquat turnedRotation(const glm::dvec3& turn_deg) {
    const glm::dmat3 turn = unrealRotation(turn_deg.x, turn_deg.y, turn_deg.z);
    const glm::dmat3 columns(turned(turn[1]), turned(turn[2]), -turned(turn[0]));
    return rotationOf(columns).value_or(glm::dquat(1, 0, 0, 0));
  }

  /// A tracked scene node is the head if the camera hangs on it, otherwise the hand.
  void assignTracker(const Part& line) {
    const std::string name = line.textOf("tracker_id"), id = line.textOf("id");
    if (name.empty()) return;
    const auto known = trackers_.find(name);
    if (known == trackers_.end()) {
      return addWarning(room_, line.placeOf("tracker_id"),
                        fmt::format("'{}' has no tracker: '{}' is none that was taken over", printable(id),
                                    printable(name)));
    }
    const int sensor = static_cast<int>(
        number(line, "tracker_ch", {.least = 0.0, .most = 65535.0}, true, room_).value_or(0.0));
    Person& person = room_.people.front();
    if (id == head_) {
      person.setup.head.sensor = {known->second, sensor};
      person.isTracked = true;
    } else if (!person.setup.hand) {
      person.setup.hand = HandSetup{{known->second, sensor}, {}, {}};
      room_.assumptions.push_back(fmt::format("the hand is '{}', line {}", printable(id), line.at.line));
    } else {
      addWarning(room_, line.at,
                 fmt::format("'{}' is tracked and left out: it is neither head nor hand", printable(id)));
    }
  }

  /// The command line of a node says which eye it draws, but two nodes of one screen are often named by it.
  StereoMode eyeOf(const Part& node) {
    const std::string id = node.textOf("id");
    const auto has = [&](const char* words) { return id.find(words) != std::string::npos; };
    bool left = has("eye_left"), right = has("eye_right");
    if (left == right) {
      left = has("left_eye");
      right = has("right_eye");
    }
    if (left == right) return StereoMode::mono;
    return left != swapsEyes_ ? StereoMode::left : StereoMode::right;
  }

  void readNode(const Part& node) {
    const std::string id = node.textOf("id"), screen = node.textOf("screen");
    if (!nodes_.emplace(id, node.at.line).second)
      addError(room_, node.at,
               fmt::format("the name '{}' is taken in line {}, expected another", printable(id), nodes_[id]));
    node.find("addr");
    node.find("viewport");
    if (!scene_.find(screen)) {
      return addError(room_, node.placeOf("screen"),
                      fmt::format("there is no screen '{}'", printable(screen)));
    }
    if (!head_.empty() && scene_.hangsOn(screen, head_)) {
      RoomWall preview;
      placeViewport(node, preview);
      return addWarning(
          room_, node.placeOf("screen"),
          fmt::format("node '{}' is left out: its screen '{}' hangs on the head '{}', an operator's "
                      "preview",
                      printable(id), printable(screen), printable(head_)));
    }
    RoomWall wall;
    wall.at = {node.at, node.at, scene_.find(screen)->at, node.placeOf("viewport"), node.at,
               node.at, node.at};
    wall.wall.name = id;
    wall.wall.stereo = eyeOf(node);
    placeViewport(node, wall);
    const auto corners = scene_.cornersOf(screen);
    if (!corners) return;
    const std::string host = node.textOf("addr");
    wall.wall.node =
        ranks_.next(host == "127.0.0.1" || host == "localhost" ? "" : host, node.placeOf("addr"));
    addWall(std::move(wall), *corners, room_);
  }

  void placeViewport(const Part& node, RoomWall& wall) {
    const auto found = viewports_.find(node.textOf("viewport"));
    if (found == viewports_.end()) {
      return addError(room_, node.placeOf("viewport"),
                      fmt::format("there is no viewport '{}'", printable(node.textOf("viewport"))));
    }
    const Part& viewport = *found->second;
    constexpr Range kSize{.least = 1.0, .most = kMostRoomPixels}, kPlace{.least = -65536.0, .most = 65536.0};
    const auto width = number(viewport, "width", kSize, true, room_),
               height = number(viewport, "height", kSize, true, room_);
    const auto x = number(viewport, "x", kPlace, true, room_), y = number(viewport, "y", kPlace, true, room_);
    const bool across = flagOr(viewport, "flip_h", false, room_),
               upright = flagOr(viewport, "flip_v", false, room_);
    wall.wall.flip = across    ? (upright ? Flip::both : Flip::horizontal)
                     : upright ? Flip::vertical
                               : Flip::none;
    if (!width || !height) return;
    wall.wall.pixels = wall.wall.window.size_px = {static_cast<int>(*width), static_cast<int>(*height)};
    wall.wall.window.position_px = {static_cast<int>(x.value_or(0.0)), static_cast<int>(y.value_or(0.0))};
  }

  const Part& root_;
  Room& room_;
  NdisplayScene scene_;
  Ranks ranks_;
  std::map<std::string, const Part*> viewports_;
  std::map<std::string, int> nodes_;  // lines of their names
  std::map<std::string, std::size_t> trackers_;
  std::vector<std::string> screens_;
  std::string cameraParent_, head_;
  bool swapsEyes_ = false;
};

/// Splits one line, which begins with a bracket, into its keys.
Part lineOf(std::string_view text, std::size_t begin, const LineIndex& lines,
            const std::filesystem::path& file) {
  const auto refuse = [&](std::size_t at, const char* what) {
    const FilePlace place = lines.at(begin + at);
    throw InputErrors({InputError(file.string(), place.line, place.column, what)});
  };
  const std::size_t close = text.find(']');
  if (close == std::string_view::npos)
    refuse(0, "this line has no closing bracket, expected [kind] key=value …");
  Part line{std::string(text.substr(1, close - 1)), {}, lines.at(begin), lines.at(begin)};
  std::size_t i = close + 1;
  while ((i = text.find_first_not_of(kBlankInLine, i)) != std::string_view::npos) {
    const std::size_t sign = text.find('=', i);
    if (sign == std::string_view::npos) break;  // words without a value
    const std::string_view key = text.substr(i, sign - i);
    std::size_t value = std::min(text.find_first_not_of(kBlankInLine, sign + 1), text.size());
    const bool quoted = value < text.size() && text[value] == '"';
    if (quoted) ++value;
    const std::size_t end =
        quoted ? text.find('"', value) : std::min(text.find_first_of(kBlankInLine, value), text.size());
    if (end == std::string_view::npos) refuse(value - 1, "this text has no closing quote");
    line.parts.push_back({std::string(key.substr(0, key.find_last_not_of(kBlankInLine) + 1)),
                          std::string(text.substr(value, end - value)), lines.at(begin + i),
                          lines.at(begin + value)});
    i = end + (quoted ? 1 : 0);
  }
  return line;
}

}  // namespace

Part readCfgLines(const std::filesystem::path& file) {
  const std::string text = readText(file, InputKind::xml);
  const LineIndex lines(text);
  Part root;
  std::size_t parts = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = std::string_view(text).substr(begin, end - begin);
    const std::size_t first = line.find_first_not_of(kBlankInLine);
    if (first != std::string_view::npos && line[first] == '[') {
      root.parts.push_back(lineOf(line.substr(first), begin + first, lines, file));
      parts += 1 + root.parts.back().parts.size();
    }
    if (parts > kMostCfgParts) {
      const FilePlace at = lines.at(begin);
      throw InputErrors({InputError(file.string(), at.line, at.column,
                                    fmt::format("too many values, expected at most {}", kMostCfgParts))});
    }
    begin = end + 1;
  }
  return root;
}

Room readNdisplayCfg(const std::filesystem::path& file, const Part& root) {
  Room room = roomOfFormat(file, "an nDisplay room", "m", 1.0);
  CfgReading(root, room).read();
  room.assumptions.push_back(
      "the file is left-handed, x forward, y right, z up, in metres: it is turned to x right, y up, z back");
  room.assumptions.push_back("each node with walls is drawn by an MPI rank, the master first");
  room.assumptions.push_back(
      "a node whose name says eye_left or eye_right draws that eye, any other is mono");
  finishRoom("a cluster_node with a screen", room);
  return room;
}

}  // namespace carom
