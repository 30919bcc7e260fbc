#include "app/room_formats/blender_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

#include "app/room_checks/foreign_room.h"
#include "app/room_checks/room_check.h"
#include "app/room_formats/blender_vrpn.h"
#include "app/room_parts/room_parts.h"

namespace carom {
namespace {

constexpr double kUsualSeparation_m = 0.06;  // of the manual
/// Below this the number is the distance of an eye from the middle, as the files of the EVE have it.
constexpr double kHalfSeparation_m = 0.045;
constexpr std::array<std::string_view, 8> kQuietBlender{
    "focus", "keyboard", "login", "synchroPort", "synchroAddress", "port", "environment", "id"};

constexpr const char* kAloneLeftOut =
    "graphic_buffers other than left and right are left out of screens in stereo: they are for pictures "
    "without";

/// What an option such as "-f -s hwpageflip" or "-w 400 400 200 300" says.
struct PlayerOptions {
  bool fullscreen = false;
  std::optional<glm::ivec2> size_px;
  glm::ivec2 position_px{0};
  std::string stereo;
};

PlayerOptions optionsOf(const std::string& text) {
  PlayerOptions options;
  std::istringstream words(text);
  std::vector<std::string> list;
  for (std::string word; words >> word && list.size() < 64;) list.push_back(word);
  const auto numberAt = [&](std::size_t i) -> std::optional<int> {
    const auto value = i < list.size() ? wholeNumber(list[i]) : std::nullopt;
    if (!value || *value < 0.0 || *value > kMostRoomPixels) return {};
    return static_cast<int>(*value);
  };
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i] == "-f") options.fullscreen = true;
    if (list[i] == "-s" && i + 1 < list.size()) options.stereo = list[i + 1];
    if (list[i] != "-w" && list[i] != "-f") continue;
    const auto width = numberAt(i + 1), height = numberAt(i + 2);
    if (width && height && *width > 0 && *height > 0) options.size_px = glm::ivec2(*width, *height);
    if (const auto x = numberAt(i + 3), y = numberAt(i + 4); list[i] == "-w" && x && y)
      options.position_px = {*x, *y};
  }
  return options;
}

/// A screen with its computer.
struct BlenderScreen {
  const Part* part;
  const Part* computer;  ///< null if the file does not have it
  std::string computerName;
};

bool isConsole(const BlenderScreen& screen) { return alike(screen.part->textOf("name"), "console"); }

/// Returns the elements in which a screen's settings stand: its own and, in BlenderVR, display and wall.
std::vector<const Part*> sectionsOf(const Part& screen) {
  std::vector<const Part*> sections{&screen};
  for (const char* name : {"display", "wall"}) {
    for (const Part* section : screen.all(name)) sections.push_back(section);
  }
  return sections;
}

std::string displayOf(const BlenderScreen& screen, const Part* player) {
  std::string display = player ? player->textOf("display") : "";
  constexpr std::string_view kVariable = "DISPLAY=";
  for (const Part* section : sectionsOf(*screen.part)) {
    for (const Part* variable : section->all("environment")) {
      if (variable->text.starts_with(kVariable)) display = variable->text.substr(kVariable.size());
    }
  }
  return display;
}

StereoMode modeOf(const std::string& stereo) {
  if (stereo == "sidebyside") return StereoMode::sideBySide;
  if (stereo == "anaglyph") return StereoMode::anaglyph;
  if (stereo == "vinterlace") return StereoMode::interlaced;
  if (stereo == "syncdoubling") return StereoMode::topBottom;
  return StereoMode::quadBuffer;
}

class BlenderReading {
 public:
  BlenderReading(const Part& root, Room& room) : root_(root), room_(room), ranks_(room) {}

  /// Reads the screens of these names; all, if there are none.
  void read(const std::set<std::string>& wanted) {
    readUsers();
    collectScreens(wanted);
    const bool onlyConsoles = std::all_of(screens_.begin(), screens_.end(), isConsole);
    for (const BlenderScreen& screen : screens_) {
      if (isConsole(screen) && !onlyConsoles) {
        screen.part->markRead();
        addWarning(room_, screen.part->at, "screen 'console' is left out: it is an operator's preview");
      } else {
        readScreen(screen);
      }
    }
    readVrpn(root_);
    for (const Part* plugins : root_.all("plugins")) readVrpn(*plugins);
    ranks_.finish();
    placePeople();
    nameUnread(root_, kQuietBlender, room_);
  }

 private:
  void readUsers() {
    std::vector<const Part*> users = root_.all("user");
    for (const Part* group : root_.all("users")) {
      for (const Part* user : group->all("user")) users.push_back(user);
    }
    refuseTwins(users, "name", room_);
    for (std::size_t i = 0; i < users.size(); ++i) {
      const Part& user = *users[i];
      const std::string name = user.textOf("name");
      if (i >= kMostViewers) {
        addWarning(room_, user.at,
                   fmt::format("user '{}' is left out: a rig has at most {} viewers", printable(name),
                               kMostViewers));
        continue;
      }
      glm::dvec3 eyes_m(0.0);
      const Part* position = user.find("default_position");
      if (position) {
        if (const auto values = numbersIn(*position, 3, room_))
          eyes_m = {(*values)[0], (*values)[1], (*values)[2]};
      }
      const std::size_t person =
          addPerson(name, separationOf(user), eyes_m, position ? position->textAt : user.at,
                    fmt::format("user '{}'", printable(name)), room_);
      placesAt_.push_back(position ? std::optional(position->textAt) : std::nullopt);
      for (const std::string& key : {name, user.textOf("ID"), fmt::format("{}", i)}) {
        if (!key.empty()) users_.emplace(key, person);
      }
    }
    if (room_.people.empty())
      addPerson("viewer", kUsualSeparation_m, {}, root_.at, "a viewer at the origin", room_);
  }

  double separationOf(const Part& user) {
    const Part* given = user.find("eye_separation");
    if (!given) {
      room_.assumptions.push_back(fmt::format(
          "the eyes of users without eye_separation are {} m apart, the manual's", kUsualSeparation_m));
      return kUsualSeparation_m;
    }
    const double value_m = numberOf(*given, kNotNegative, false, room_).value_or(kUsualSeparation_m);
    if (value_m <= 0.0 || value_m >= kHalfSeparation_m) return value_m;
    addWarning(
        room_, given->textAt,
        fmt::format("eye_separation {} is taken as the distance of an eye from the middle: the eyes are {} m "
                    "apart",
                    value_m, 2.0 * value_m));
    return 2.0 * value_m;
  }

  void collectScreens(const std::set<std::string>& wanted) {
    std::map<std::string, const Part*> computers;
    for (const Part* computer : root_.all("computer")) {
      for (const Part* screen : computer->all("screen"))
        screens_.push_back({screen, computer, computer->textOf("name")});
    }
    for (const Part* group : root_.all("computers")) {
      refuseTwins(group->all("computer"), "name", room_);
      for (const Part* computer : group->all("computer"))
        computers.emplace(computer->textOf("name"), computer);
    }
    for (const Part* group : root_.all("screens")) {
      for (const Part* screen : group->all("screen")) {
        const std::string name = screen->textOf("name"), computer = screen->textOf("computer");
        if (!wanted.empty() && !wanted.contains(name)) {
          screen->markRead();
          addWarning(
              room_, screen->at,
              fmt::format("screen '{}' is left out: this configuration does not show it", printable(name)));
          continue;
        }
        const auto known = computers.find(computer);
        screens_.push_back({screen, known == computers.end() ? nullptr : known->second, computer});
      }
    }
  }

  void readScreen(const BlenderScreen& screen) {
    const std::string name = screen.part->textOf("name");
    if (const Part* headset = screen.part->find("hmd")) {
      screen.part->markRead();
      return addWarning(room_, headset->at,
                        fmt::format("screen '{}' is left out: it hangs on the head", printable(name)));
    }
    RoomWall wall;
    const FilePlace at = screen.part->at;
    wall.at = {at, screen.part->placeOf("name"), at, at, at, at, at};
    // The screens of a room often have one name, such as main: that of the computer tells them apart.
    const auto same = [&](const BlenderScreen& other) {
      return other.part != screen.part && other.part->textOf("name") == name;
    };
    wall.wall.name = name;
    if (std::any_of(screens_.begin(), screens_.end(), same)) {
      wall.wall.name = screen.computerName + "-" + name;
      room_.assumptions.push_back(
          fmt::format("one of the screens '{}' is called '{}' by its computer, line {}", printable(name),
                      printable(wall.wall.name), at.line));
    }
    std::map<std::string, const Part*> corners;
    const Part *viewport = nullptr, *player = nullptr;
    for (const Part* section : sectionsOf(*screen.part)) {
      refuseTwins(section->all("corner"), "name", room_);
      for (const Part* corner : section->all("corner")) corners[corner->textOf("name")] = corner;
      if (const Part* found = section->find("viewport")) viewport = found;
      if (const Part* found = section->find("player")) player = found;
      if (section->find("options")) player = section;
    }
    const PlayerOptions options = optionsOf(player ? player->textOf("options") : "");
    const auto cornersOfWall = cornersOf(screen, corners, wall);
    if (!cornersOfWall) return;
    readBuffers(*screen.part, options, player, wall);
    place(viewport, options, wall);
    wall.wall.node = ranks_.of(hostOf(screen), displayOf(screen, player), at);
    addWall(std::move(wall), *cornersOfWall, room_);
  }

  std::optional<ReadCorners> cornersOf(const BlenderScreen& screen,
                                       const std::map<std::string, const Part*>& given, RoomWall& wall) {
    std::array<std::optional<glm::dvec3>, 3> read;
    constexpr std::array<const char*, 3> kNames{"topLeftCorner", "topRightCorner", "bottomRightCorner"};
    for (std::size_t i = 0; i < read.size(); ++i) {
      const auto found = given.find(kNames[i]);
      if (found == given.end()) {
        addError(
            room_, screen.part->at,
            fmt::format("{} is missing in screen '{}'", kNames[i], printable(screen.part->textOf("name"))));
        continue;
      }
      wall.at.corner = found->second->textAt;
      if (const auto values = numbersIn(*found->second, 3, room_))
        read[i] = {(*values)[0], (*values)[1], (*values)[2]};
    }
    if (!read[0] || !read[1] || !read[2]) return {};
    const glm::dvec3 down_m = *read[2] - *read[1];
    return ReadCorners{*read[0] + down_m, *read[2], *read[0], {"bottom left corner", kNames[2], kNames[0]}};
  }

  std::string hostOf(const BlenderScreen& screen) const {
    std::string host = screen.computer ? screen.computer->textOf("hostname") : "";
    if (host.empty()) host = screen.computerName;
    return host == "*" || host == "localhost" || host == "127.0.0.1" || host == "Any" ? "" : host;
  }

  /// A picture for a channel: whose eye it is.
  std::optional<ViewerEye> eyeOf(const Part& buffer) {
    ViewerEye eye;
    const std::string user = buffer.textOf("user"), which = buffer.textOf("eye");
    if (const auto known = users_.find(user); known != users_.end()) {
      eye.viewer = known->second;
    } else if (!user.empty()) {
      addError(room_, buffer.placeOf("user"), fmt::format("there is no user '{}'", printable(user)));
      return {};
    }
    if (which == "left") eye.eye = Eye::left;
    if (which == "right") eye.eye = Eye::right;
    if (which.empty() || which == "left" || which == "right" || which == "middle") return eye;
    addError(room_, buffer.placeOf("eye"),
             fmt::format("eye is '{}', expected left, middle or right", printable(which)));
    return {};
  }

  void readBuffers(const Part& screen, const PlayerOptions& options, const Part* player, RoomWall& wall) {
    std::optional<ViewerEye> left, right, alone;
    for (const Part* section : sectionsOf(screen)) {
      for (const Part* buffer : section->all("graphic_buffer")) {
        std::string name = buffer->textOf("buffer");
        if (name.empty()) name = buffer->textOf("name");
        const auto eye = eyeOf(*buffer);
        if (!eye) continue;
        (name == "left" ? left : name == "right" ? right : alone) = eye;
      }
    }
    if (left && right && options.stereo != "nostereo") {
      if (alone) room_.assumptions.push_back(kAloneLeftOut);
      wall.wall.stereo = modeOf(options.stereo);
      wall.wall.viewer = left->viewer;
      const bool usual = left->viewer == right->viewer && left->eye == Eye::left && right->eye == Eye::right;
      if (!usual) wall.wall.eyes = {*left, *right};
      if (options.stereo.empty()) {
        room_.assumptions.push_back(
            "screens with a left and a right graphic_buffer and no -s are quad-buffered");
      } else if (options.stereo == "syncdoubling") {
        addWarning(room_, player->placeOf("options"), "stereo syncdoubling becomes top-bottom");
      }
      return;
    }
    const ViewerEye shown = alone ? *alone : left ? *left : right ? *right : ViewerEye{};
    wall.wall.viewer = shown.viewer;
    wall.wall.stereo = shown.eye == Eye::left    ? StereoMode::left
                       : shown.eye == Eye::right ? StereoMode::right
                                                 : StereoMode::mono;
  }

  /// The viewport is in pixels of the window: left, bottom, right and top. A window of unknown size reaches
  /// as far beyond it on the right as it begins after the left.
  void place(const Part* viewport, const PlayerOptions& options, RoomWall& wall) {
    WindowPlacement window;
    window.fullscreen = options.fullscreen;
    window.position_px = options.position_px;
    const auto values = viewport ? numbersIn(*viewport, 4, room_) : std::nullopt;
    if (!values) {
      if (viewport) return;
      if (options.size_px)
        return placeInWindow({.position_px = options.position_px,
                              .size_px = *options.size_px,
                              .fullscreen = options.fullscreen},
                             {0, 0}, *options.size_px, wall, room_);
      wall.wall.window.fullscreen = options.fullscreen;
      return;
    }
    wall.at.pixels = viewport->textAt;
    const bool sound = std::all_of(values->begin(), values->end(),
                                   [](double value) { return value >= 0.0 && value <= kMostRoomPixels; }) &&
                       (*values)[2] >= (*values)[0] + 1.0 && (*values)[3] >= (*values)[1] + 1.0;
    if (!sound) {
      return addError(room_, viewport->textAt,
                      fmt::format("viewport is '{}', expected left, bottom, right and top in pixels",
                                  printable(viewport->text)));
    }
    const glm::ivec2 low((*values)[0], (*values)[1]), high((*values)[2], (*values)[3]);
    window.size_px =
        options.size_px.value_or(glm::min(low + high, glm::ivec2(static_cast<int>(kMostRoomPixels))));
    if (!options.size_px) {
      room_.assumptions.push_back(fmt::format(
          "a window with a viewport from {} to {} is taken to be {} pixels wide, as if it were in the middle",
          low.x, high.x, window.size_px.x));
    }
    placeInWindow(window, {low.x, window.size_px.y - high.y}, high - low, wall, room_);
  }

  void readVrpn(const Part& whole) {
    for (const Part* vrpn : whole.all("vrpn")) readBlenderVrpn(*vrpn, users_, room_);
  }

  /// The origin is at the eyes or on the floor: a floor screen decides. Users whose place is on the floor
  /// stand there.
  void placePeople() {
    for (std::size_t i = 0; i < placesAt_.size(); ++i) {
      if (placesAt_[i]) leaveOutPlace(i, *placesAt_[i], room_);
    }
    const auto floor_m = floorHeight_m(room_);
    if (!floor_m) return;
    constexpr double kOnFloor_m = 0.3;
    for (Viewer& viewer : room_.viewers) {
      if (viewer.eyes_m.y - *floor_m > kOnFloor_m) continue;
      room_.assumptions.push_back(
          fmt::format("{} stands on the place of line {}, which is on the floor: the eyes are "
                      "{} m above it",
                      viewer.words, viewer.at.line, kStandingEyes_m));
      viewer.eyes_m.y = *floor_m + kStandingEyes_m;
    }
  }

  const Part& root_;
  Room& room_;
  Ranks ranks_;
  std::map<std::string, std::size_t> users_;
  std::vector<std::optional<FilePlace>> placesAt_;  // of the users' default positions
  std::vector<BlenderScreen> screens_;
};

/// Returns the screens of the wanted one of several configurations; none if there are no configurations.
std::set<std::string> screensOf(const Part& root, const std::string& wanted,
                                const std::filesystem::path& file) {
  std::vector<std::string> names;
  std::vector<FilePlace> places;
  std::vector<const Part*> configurations;
  for (const Part* starter : root.all("starter")) {
    for (const Part* configuration : starter->all("config")) {
      names.push_back(configuration->textOf("name"));
      places.push_back(configuration->at);
      configurations.push_back(configuration);
    }
  }
  std::set<std::string> screens;
  if (configurations.empty()) {
    refuseRoomName(wanted, file);
    return screens;
  }
  std::istringstream list(configurations[chooseRoom(names, places, wanted, file)]->text);
  for (std::string name; std::getline(list, name, ',');) {
    const std::size_t begin = name.find_first_not_of(" \t\r\n");
    if (begin != std::string::npos)
      screens.insert(name.substr(begin, name.find_last_not_of(" \t\r\n") + 1 - begin));
  }
  return screens;
}

}  // namespace

Room readBlender(const std::filesystem::path& file, const Part& root,
                 const std::vector<OutsideEntity>& leftOut, const std::string& wanted) {
  Room room =
      roomOfFormat(file, alike(root.name, "blendervr") ? "a BlenderVR room" : "a BlenderCAVE room", "m", 1.0);
  if (const std::string name = root.textOf("name"); !name.empty()) room.title = printable(name);
  for (const OutsideEntity& entity : leftOut) {
    addWarning(
        room, entity.at,
        fmt::format("the file '{}' is named here as an entity and left out: its trackers are to be put into "
                    "the rig by hand",
                    printable(entity.file)));
  }
  BlenderReading(root, room).read(screensOf(root, wanted, file));
  room.assumptions.push_back("lengths are metres, axes x right, y up, z back, as BlenderCAVE has them");
  room.assumptions.push_back("each computer with walls is drawn by an MPI rank, in the order of the file");
  finishRoom("a screen with three corners", room);
  return room;
}

}  // namespace carom
