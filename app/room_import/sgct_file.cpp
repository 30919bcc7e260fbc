#include "app/room_import/sgct_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>

#include "app/room_import/foreign_room.h"
#include "app/room_import/json_tree.h"
#include "app/room_import/room_check.h"
#include "cave/room/rectangle.h"

namespace carom {

namespace {

using Keys = std::span<const std::string_view>;
using Kind = JsonNode::Kind;

constexpr double kEyeSeparation_m = 0.06;  // SGCT's own
constexpr int kMostPixels = 16384;
constexpr std::size_t kMostWalls = 512;
constexpr std::array<std::string_view, 3> kCorners{"lowerleft", "upperleft", "upperright"};

constexpr std::array<std::string_view, 13> kRootKeys{
    "version", "masteraddress", "debuglog", "threadaffinity", "firmsync",  "scene", "nodes",
    "users",   "capture",       "trackers", "settings",       "generator", "meta"};
constexpr std::array<std::string_view, 5> kNodeKeys{"address", "port", "datatransferport", "swaplock",
                                                    "windows"};
constexpr std::array<std::string_view, 29> kWindowKeys{"pos",
                                                       "size",
                                                       "res",
                                                       "viewports",
                                                       "id",
                                                       "name",
                                                       "tags",
                                                       "bufferbitdepth",
                                                       "fullscreen",
                                                       "autoiconify",
                                                       "hidemousecursor",
                                                       "floating",
                                                       "alwaysrender",
                                                       "hidden",
                                                       "takescreenshot",
                                                       "alpha",
                                                       "msaa",
                                                       "fxaa",
                                                       "border",
                                                       "resizable",
                                                       "draw2d",
                                                       "draw3d",
                                                       "noerror",
                                                       "blitwindowid",
                                                       "mirrorx",
                                                       "mirrory",
                                                       "monitor",
                                                       "stereo",
                                                       "scalablemesh"};
constexpr std::array<std::string_view, 10> kViewportKeys{
    "pos", "size", "projection", "overlay", "blendmask", "mesh", "tracked", "eye", "user", "blacklevelmask"};
constexpr std::array<std::string_view, 4> kPlaneKeys{"type", "lowerleft", "upperleft", "upperright"};
constexpr std::array<std::string_view, 6> kUserKeys{"name",   "eyeseparation", "pos",
                                                    "matrix", "orientation",   "tracking"};

struct User {
  std::string name;
  double eyeSeparation_m = kEyeSeparation_m;
  glm::dvec3 eyes_m{0.0};
  FilePlace at, eyeSeparationAt;
};

/// What a window says of all its viewports.
struct WindowText {
  const JsonNode& node;
  int rank = 0;
  glm::dvec2 position_px{0.0}, size_px{0.0}, picture_px{0.0};
  int monitor = 0;
  bool fullscreen = false;
  StereoMode stereo = StereoMode::mono;
  Flip flip = Flip::none;
};

class SgctReader {
 public:
  explicit SgctReader(const std::filesystem::path& file)
      : root_(readJson(file)), room_(foreignRoom(file, "an SGCT room")) {}

  Room read() {
    if (root_.kind != Kind::object) {
      addError(room_, root_.at, fmt::format("this is {}, expected an object with nodes", root_.words()));
      return std::move(room_);
    }
    noteUnknown(root_, kRootKeys);
    readUsers();
    if (const JsonNode* nodes = array(root_, "nodes")) {
      for (const JsonNode& node : nodes->children) readNode(node);
    }
    if (room_.walls.empty() && !room_.hasErrors()) {
      addError(
          room_, root_.at,
          "no viewport here shows a flat wall, expected one with a projection of type 'ProjectionPlane'");
    }
    shareWindow();
    noteTrackers();
    assume();
    return std::move(room_);
  }

 private:
  void noteUnknown(const JsonNode& object, Keys known) {
    for (const JsonNode& member : object.children) {
      const bool expected = std::find(known.begin(), known.end(), member.key) != known.end();
      const bool streamed = member.key == "spout" || member.key == "ndi" || member.key == "$schema";
      if (!expected && !streamed) addUnknownKey(room_, member.keyAt, member.key, known);
      if (object.member(member.key) != &member) {
        addWarning(room_, member.keyAt,
                   fmt::format("{} is given twice; the last counts", printable(member.key)));
      }
    }
  }

  /// A member that must be of this kind if it is there; null, with an error noted, where it is not.
  const JsonNode* member(const JsonNode& object, std::string_view key, Kind kind, std::string_view words) {
    const JsonNode* found = object.member(key);
    if (!found) return nullptr;
    const bool fits = found->kind == kind || (kind == Kind::number && found->kind == Kind::whole);
    if (fits) return found;
    addError(room_, found->at, fmt::format("{} is {}, expected {}", key, found->words(), words));
    return nullptr;
  }
  const JsonNode* array(const JsonNode& object, std::string_view key) {
    return member(object, key, Kind::array, "an array");
  }
  bool flag(const JsonNode& object, std::string_view key) {
    const JsonNode* found = member(object, key, Kind::flag, "true or false");
    return found && found->flag;
  }
  bool isObject(const JsonNode& node, std::string_view what) {
    if (node.kind == Kind::object) return true;
    addError(room_, node.at, fmt::format("{} is {}, expected an object", what, node.words()));
    return false;
  }
  std::optional<double> number(const JsonNode& object, std::string_view key, const Range& range, bool whole) {
    const JsonNode* found = object.member(key);
    if (!found) return {};
    const bool fits = found->kind == Kind::whole || (!whole && found->kind == Kind::number);
    if (fits && within(range, found->number)) return found->number;
    addError(room_, found->at,
             fmt::format("{} is {}, expected {}", key, found->words(), wordsFor(range, whole)));
    return {};
  }

  /// {x, y} or {x, y, z}; none where the key is absent or, with an error noted, wrong.
  template <std::size_t N>
  std::optional<std::array<double, N>> numbers(const JsonNode& object, std::string_view key,
                                               const Range& range, bool whole) {
    static constexpr std::array<std::string_view, 3> kNames{"x", "y", "z"};
    const JsonNode* found = member(object, key, Kind::object, N == 2 ? "{x, y}" : "{x, y, z}");
    if (!found) return {};
    noteUnknown(*found, Keys(kNames).first(N));
    std::array<double, N> values{};
    bool sound = true;
    for (std::size_t i = 0; i < N; ++i) {
      const auto value = number(*found, kNames[i], range, whole);
      if (!value && !found->member(kNames[i])) {
        addError(room_, found->at, fmt::format("{} is missing in {}", kNames[i], key));
      }
      sound = sound && value;
      values[i] = value.value_or(0.0);
    }
    if (!sound) return {};
    return values;
  }

  void readUsers() {
    if (const JsonNode* users = array(root_, "users")) {
      for (const JsonNode& user : users->children) readUser(user);
    }
    if (users_.empty()) users_.push_back({"", kEyeSeparation_m, {}, root_.at, root_.at});
    const User& user = users_.front();
    room_.eyeSeparation_m = user.eyeSeparation_m;
    room_.eyeSeparationAt = user.eyeSeparationAt;
    room_.viewer = {user.eyes_m, user.at, "the viewer"};
    if (users_.size() > 1) {
      addWarning(room_, users_[1].at,
                 fmt::format("there are {} users, but one person is tracked here: the first", users_.size()));
    }
  }

  void readUser(const JsonNode& node) {
    if (!isObject(node, "a user")) return;
    noteUnknown(node, kUserKeys);
    User user{"", kEyeSeparation_m, {}, node.at, node.at};
    if (const JsonNode* name = member(node, "name", Kind::text, "a text")) user.name = name->text;
    if (const auto separation = number(node, "eyeseparation", kNotNegative, false)) {
      user.eyeSeparation_m = *separation;
      user.eyeSeparationAt = node.member("eyeseparation")->at;
    }
    if (const auto at = numbers<3>(node, "pos", {}, false)) {
      user.eyes_m = {(*at)[0], (*at)[1], (*at)[2]};
      user.at = node.member("pos")->at;
    }
    for (const std::string_view key : {"matrix", "orientation"}) {
      if (const JsonNode* found = node.member(key)) {
        addWarning(room_, found->at,
                   fmt::format("{} of the user cannot be taken over: the viewer's place is pos alone", key));
      }
    }
    users_.push_back(std::move(user));
  }

  void readNode(const JsonNode& node) {
    const int rank = ranks_++;
    if (!isObject(node, "a node")) return;
    noteUnknown(node, kNodeKeys);
    const JsonNode* windows = array(node, "windows");
    if (!windows || windows->children.empty()) {
      addWarning(room_, node.at, fmt::format("node {} has no window: it would draw nothing", rank));
      return;
    }
    for (const JsonNode& window : windows->children) readWindow(window, rank);
  }

  void readWindow(const JsonNode& node, int rank) {
    ++windows_;
    if (!isObject(node, "a window")) return;
    noteUnknown(node, kWindowKeys);
    constexpr Range kSize{.least = 1.0, .most = kMostPixels};
    constexpr Range kPlace{.least = -65536.0, .most = 65536.0};
    const auto size = numbers<2>(node, "size", kSize, true);
    const auto picture = numbers<2>(node, "res", kSize, true);
    const auto position = numbers<2>(node, "pos", kPlace, true);
    if (!node.member("size")) addError(room_, node.at, "size is missing here");
    const auto monitor = number(node, "monitor", {.least = -1.0, .most = 63.0}, true);
    if (!size) return;
    WindowText window{.node = node, .rank = rank};
    window.size_px = {(*size)[0], (*size)[1]};
    window.picture_px = picture ? glm::dvec2((*picture)[0], (*picture)[1]) : window.size_px;
    if (position) window.position_px = {(*position)[0], (*position)[1]};
    window.monitor = std::max(0, static_cast<int>(monitor.value_or(0.0)));
    window.fullscreen = flag(node, "fullscreen");
    window.stereo = stereoOf(node);
    window.flip = flag(node, "mirrorx") ? (flag(node, "mirrory") ? Flip::both : Flip::horizontal)
                                        : (flag(node, "mirrory") ? Flip::vertical : Flip::none);
    noteIgnored(node, "scalablemesh", "a warping of its own kind");
    const JsonNode* viewports = array(node, "viewports");
    if (!viewports || viewports->children.empty()) {
      addWarning(room_, node.at,
                 "this window has no viewport, so nothing says which wall it shows: it is left out");
      return;
    }
    for (const JsonNode& viewport : viewports->children) readViewport(viewport, window);
  }

  void noteIgnored(const JsonNode& node, std::string_view key, std::string_view what) {
    if (const JsonNode* found = node.member(key)) {
      addWarning(room_, found->at, fmt::format("{} cannot be taken over: {}", key, what));
    }
  }

  StereoMode stereoOf(const JsonNode& window) {
    struct Named {
      std::string_view name;
      StereoMode mode;
      std::string_view differs;  // from what SGCT shows
    };
    constexpr std::array<Named, 15> kModes{{
        {"none", StereoMode::mono, ""},
        {"no_stereo", StereoMode::mono, ""},
        {"active", StereoMode::quadBuffer, ""},
        {"quadbuffer", StereoMode::quadBuffer, ""},
        {"checkerboard", StereoMode::checkerboard, ""},
        {"checkerboard_inverted", StereoMode::checkerboard, "the eyes change places"},
        {"anaglyph_red_cyan", StereoMode::anaglyph, ""},
        {"anaglyph_amber_blue", StereoMode::anaglyph, "it is shown in red and cyan"},
        {"anaglyph_wimmer", StereoMode::anaglyph, "it is shown in plain red and cyan"},
        {"vertical_interlaced", StereoMode::interlaced, ""},
        {"vertical_interlaced_inverted", StereoMode::interlaced, "the eyes change places"},
        {"side_by_side", StereoMode::sideBySide, ""},
        {"side_by_side_inverted", StereoMode::sideBySide, "the eyes change places"},
        {"top_bottom", StereoMode::topBottom, ""},
        {"top_bottom_inverted", StereoMode::topBottom, "the eyes change places"},
    }};
    const JsonNode* stereo = member(window, "stereo", Kind::text, "a text");
    stereoLeftOut_ = stereoLeftOut_ || !stereo;
    if (!stereo) return StereoMode::mono;
    std::string names;
    for (const Named& mode : kModes) {
      names += fmt::format("{}'{}'", names.empty() ? "" : " or ", mode.name);
      if (stereo->text != mode.name) continue;
      if (!mode.differs.empty()) {
        addWarning(room_, stereo->at,
                   fmt::format("stereo '{}' is not known here: {}", mode.name, mode.differs));
      }
      return mode.mode;
    }
    addWarning(room_, stereo->at,
               fmt::format("stereo is '{}', taken as mono, expected {}", printable(stereo->text), names));
    return StereoMode::mono;
  }

  void readViewport(const JsonNode& node, const WindowText& window) {
    if (!isObject(node, "a viewport")) return;
    noteUnknown(node, kViewportKeys);
    for (const std::string_view key : {"overlay", "blendmask", "blacklevelmask", "mesh"}) {
      noteIgnored(node, key, "put the projector's warp and blend into the rig by hand");
    }
    const JsonNode* projection = member(node, "projection", Kind::object, "an object");
    if (!projection) {
      if (!node.member("projection")) {
        addWarning(room_, node.at,
                   "this viewport has no projection, so nothing says which wall it shows: it is left out");
      }
      return;
    }
    RoomWall wall;
    wall.at = {
        .wall = node.at,
        .name = node.at,
        .corner = projection->at,
        .pixels = (window.node.member("res") ? window.node.member("res") : window.node.member("size"))->at,
        .node = node.at,
        .window = window.node.at,
        .blend = node.at};
    wall.wall.node = window.rank;
    wall.wall.flip = window.flip;
    wall.wall.stereo = eyeOf(node, window);
    checkUser(node);
    const bool placed = readPlace(node, window, wall.wall);
    if (!readPlane(*projection, wall) || !placed) return;
    if (room_.walls.size() == kMostWalls) {
      return addError(room_, node.at, fmt::format("there are more than {} walls", kMostWalls));
    }
    wall.wall.name = rigName(room_, sideOf(wall.wall, room_.axes));
    room_.walls.push_back(std::move(wall));
    ofWindow_.push_back(windows_);
    places_.push_back({window.position_px, window.size_px, window.monitor, window.fullscreen});
  }

  StereoMode eyeOf(const JsonNode& viewport, const WindowText& window) {
    const JsonNode* eye = member(viewport, "eye", Kind::text, "a text");
    if (!eye || eye->text == "center") return window.stereo;
    if (eye->text == "left") return StereoMode::left;
    if (eye->text == "right") return StereoMode::right;
    addWarning(room_, eye->at,
               fmt::format("eye is '{}', taken as both, expected 'center' or 'left' or 'right'",
                           printable(eye->text)));
    return window.stereo;
  }

  void checkUser(const JsonNode& viewport) {
    const JsonNode* user = member(viewport, "user", Kind::text, "a text");
    if (!user) return;
    const auto known =
        std::find_if(users_.begin(), users_.end(), [&](const User& u) { return u.name == user->text; });
    if (known == users_.end()) {
      addWarning(room_, user->at,
                 fmt::format("there is no user '{}'; the first is taken", printable(user->text)));
    }
  }

  /// SGCT counts a viewport from its window's lower left, in parts of it.
  bool readPlace(const JsonNode& viewport, const WindowText& window, Wall& wall) {
    const auto position = numbers<2>(viewport, "pos", {.least = 0.0, .most = 1.0}, false);
    const auto size = numbers<2>(viewport, "size", {.least = 0.0, .most = 1.0, .above = true}, false);
    if ((viewport.member("pos") && !position) || (viewport.member("size") && !size)) return false;
    const glm::dvec2 low = position ? glm::dvec2((*position)[0], (*position)[1]) : glm::dvec2(0.0);
    const glm::dvec2 part = size ? glm::dvec2((*size)[0], (*size)[1]) : glm::dvec2(1.0);
    const auto rounded = [](const glm::dvec2& v) {
      return glm::ivec2(static_cast<int>(std::lround(v.x)), static_cast<int>(std::lround(v.y)));
    };
    wall.pixels = glm::max(rounded(window.picture_px * part), glm::ivec2(1));
    wall.window.monitor = window.monitor;
    wall.window.size_px = glm::max(rounded(window.size_px * part), glm::ivec2(1));
    wall.window.position_px =
        rounded(window.position_px + window.size_px * glm::dvec2(low.x, 1.0 - low.y - part.y));
    wall.window.fullscreen = window.fullscreen && part == glm::dvec2(1.0);
    return true;
  }

  bool readPlane(const JsonNode& projection, RoomWall& wall) {
    const JsonNode* type = member(projection, "type", Kind::text, "a text");
    if (!type) {
      if (!projection.member("type")) addError(room_, projection.at, "type is missing in projection");
      return false;
    }
    if (type->text != "ProjectionPlane") {
      addWarning(room_, type->at,
                 fmt::format(
                     "a projection of type '{}' is an opening angle or a curved screen, not a flat wall with "
                     "corners: this viewport is left out, expected 'ProjectionPlane'",
                     printable(type->text)));
      return false;
    }
    noteUnknown(projection, kPlaneKeys);
    std::array<std::optional<std::array<double, 3>>, 3> read;
    bool sound = true;
    for (std::size_t i = 0; i < 3; ++i) {
      read[i] = numbers<3>(projection, kCorners[i], {}, false);
      if (!projection.member(kCorners[i])) {
        addError(room_, projection.at, fmt::format("{} is missing in projection", kCorners[i]));
      }
      sound = sound && read[i];
    }
    if (!sound) return false;
    const auto corner = [&](std::size_t i) {
      return glm::dvec3((*read[i])[0], (*read[i])[1], (*read[i])[2]);
    };
    const ThreeCorners corners{{corner(0), corner(1), corner(2)}, kCorners, false};
    wall.wall.lowerLeft_m = corner(0);
    wall.wall.upperLeft_m = corner(1);
    wall.wall.lowerRight_m = corner(0) + (corner(2) - corner(1));
    wall.at.corner = projection.member("upperright")->at;
    if (const auto fault = rectangleFault("of this viewport", corners)) {
      addError(room_, projection.member(kCorners[fault->corner])->at, fault->what);
      return false;
    }
    return true;
  }

  /// One window with several viewports is what a rig calls one_window. Several such windows are taken apart.
  void shareWindow() {
    const bool several = room_.walls.size() > 1 && windows_ == 1;
    bool split = false;
    for (std::size_t i = 1; i < ofWindow_.size(); ++i) split = split || ofWindow_[i] == ofWindow_[i - 1];
    if (!several) {
      if (split) {
        room_.assumptions.push_back(
            "a window with several viewports becomes a window for each, at its place");
      }
      return;
    }
    const Place& place = places_.front();
    room_.oneWindow = WindowPlacement{place.monitor, glm::ivec2(place.position_px), glm::ivec2(place.size_px),
                                      place.fullscreen};
    for (RoomWall& wall : room_.walls) {
      wall.wall.window.position_px -= room_.oneWindow->position_px;
      wall.wall.window.monitor = 0;
      wall.wall.window.fullscreen = false;
    }
  }

  void noteTrackers() {
    const JsonNode* trackers = array(root_, "trackers");
    if (!trackers || trackers->children.empty()) return;
    addWarning(
        room_, trackers->at,
        "the trackers are not taken over: put each into the rig as a [[tracker]] of kind 'vrpn' and measure "
        "its room_from_tracker");
  }

  void assume() {
    room_.assumptions.push_back("the viewer's eyes start where the first user's pos has them");
    room_.assumptions.push_back("each node is drawn by the MPI rank of its place in the file");
    if (stereoLeftOut_) room_.assumptions.push_back("windows that name no stereo are mono, as in SGCT");
    if (std::any_of(room_.walls.begin(), room_.walls.end(), [](const RoomWall& wall) {
          return wall.wall.stereo == StereoMode::sideBySide || wall.wall.stereo == StereoMode::topBottom;
        })) {
      room_.assumptions.push_back(
          "each eye's picture has all pixels of its viewport and is squeezed into its half");
    }
  }

  struct Place {
    glm::dvec2 position_px, size_px;
    int monitor = 0;
    bool fullscreen = false;
  };

  JsonNode root_;
  Room room_;
  std::vector<User> users_;
  bool stereoLeftOut_ = false;
  int ranks_ = 0;
  int windows_ = 0;
  std::vector<int> ofWindow_;  // of each wall
  std::vector<Place> places_;  // of each wall's whole window
};

}  // namespace

Room readSgct(const std::filesystem::path& file) { return SgctReader(file).read(); }

}  // namespace carom
