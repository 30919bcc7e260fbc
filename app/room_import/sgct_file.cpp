#include "app/room_import/sgct_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/vec2.hpp>
#include <string_view>
#include <utility>

#include "app/room_import/sgct_values.h"
#include "app/room_import/sgct_viewport.h"

namespace carom {
namespace {

using Kind = JsonNode::Kind;

constexpr int kMostPixels = 16384;

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
constexpr std::array<std::string_view, 6> kUserKeys{"name",   "eyeseparation", "pos",
                                                    "matrix", "orientation",   "tracking"};

void readUser(const JsonNode& node, SgctReading& in) {
  if (!isObject(node, "a user", in.room)) return;
  noteUnknown(node, kUserKeys, in.room);
  SgctUser user{"", SgctUser().eyeSeparation_m, {}, node.at, node.at};
  if (const JsonNode* name = member(node, "name", Kind::text, "a text", in.room)) user.name = name->text;
  if (const auto separation = number(node, "eyeseparation", kNotNegative, false, in.room)) {
    user.eyeSeparation_m = *separation;
    user.eyeSeparationAt = node.member("eyeseparation")->at;
  }
  if (const auto at = numbers<3>(node, "pos", {}, false, in.room)) {
    user.eyes_m = {(*at)[0], (*at)[1], (*at)[2]};
    user.at = node.member("pos")->at;
  }
  for (const std::string_view key : {"matrix", "orientation"}) {
    if (const JsonNode* found = node.member(key)) {
      addWarning(in.room, found->at,
                 fmt::format("{} of the user cannot be taken over: the viewer's place is pos alone", key));
    }
  }
  in.users.push_back(std::move(user));
}

void readUsers(SgctReading& in) {
  if (const JsonNode* users = array(in.root, "users", in.room)) {
    for (const JsonNode& user : users->children) readUser(user, in);
  }
  if (in.users.empty()) in.users.push_back({"", SgctUser().eyeSeparation_m, {}, in.root.at, in.root.at});
  const SgctUser& user = in.users.front();
  in.room.eyeSeparation_m = user.eyeSeparation_m;
  in.room.eyeSeparationAt = user.eyeSeparationAt;
  in.room.viewers = {{user.eyes_m, user.at, "the viewer"}};
  if (in.users.size() > 1) {
    addWarning(in.room, in.users[1].at,
               fmt::format("there are {} users, but one person is tracked here: the first", in.users.size()));
  }
}

StereoMode stereoOf(const JsonNode& window, SgctReading& in) {
  struct Named {
    std::string_view name;
    StereoMode mode;
    std::string_view differs;  // difference from what SGCT shows
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
  const JsonNode* stereo = member(window, "stereo", Kind::text, "a text", in.room);
  in.stereoLeftOut = in.stereoLeftOut || !stereo;
  if (!stereo) return StereoMode::mono;
  std::string names;
  for (const Named& mode : kModes) {
    names += fmt::format("{}'{}'", names.empty() ? "" : " or ", mode.name);
    if (stereo->text != mode.name) continue;
    if (!mode.differs.empty()) {
      addWarning(in.room, stereo->at,
                 fmt::format("stereo '{}' is not known here: {}", mode.name, mode.differs));
    }
    return mode.mode;
  }
  addWarning(in.room, stereo->at,
             fmt::format("stereo is '{}', taken as mono, expected {}", printable(stereo->text), names));
  return StereoMode::mono;
}

void readWindow(const JsonNode& node, int rank, SgctReading& in) {
  ++in.windows;
  if (!isObject(node, "a window", in.room)) return;
  noteUnknown(node, kWindowKeys, in.room);
  constexpr Range kSize{.least = 1.0, .most = kMostPixels};
  constexpr Range kPlace{.least = -65536.0, .most = 65536.0};
  const auto size = numbers<2>(node, "size", kSize, true, in.room);
  const auto picture = numbers<2>(node, "res", kSize, true, in.room);
  const auto position = numbers<2>(node, "pos", kPlace, true, in.room);
  if (!node.member("size")) addError(in.room, node.at, "size is missing here");
  const auto monitor = number(node, "monitor", {.least = -1.0, .most = 63.0}, true, in.room);
  if (!size) return;
  SgctWindow window{.node = node, .rank = rank};
  window.size_px = {(*size)[0], (*size)[1]};
  window.picture_px = picture ? glm::dvec2((*picture)[0], (*picture)[1]) : window.size_px;
  if (position) window.position_px = {(*position)[0], (*position)[1]};
  window.monitor = std::max(0, static_cast<int>(monitor.value_or(0.0)));
  window.fullscreen = flag(node, "fullscreen", in.room);
  window.stereo = stereoOf(node, in);
  window.flip = flag(node, "mirrorx", in.room)
                    ? (flag(node, "mirrory", in.room) ? Flip::both : Flip::horizontal)
                    : (flag(node, "mirrory", in.room) ? Flip::vertical : Flip::none);
  noteIgnored(node, "scalablemesh", "a warping of its own kind", in.room);
  const JsonNode* viewports = array(node, "viewports", in.room);
  if (!viewports || viewports->children.empty()) {
    addWarning(in.room, node.at,
               "this window has no viewport, so nothing says which wall it shows: it is left out");
    return;
  }
  for (const JsonNode& viewport : viewports->children) readViewport(viewport, window, in);
}

void readNode(const JsonNode& node, SgctReading& in) {
  const int rank = in.ranks++;
  if (!isObject(node, "a node", in.room)) return;
  noteUnknown(node, kNodeKeys, in.room);
  const JsonNode* windows = array(node, "windows", in.room);
  if (!windows || windows->children.empty()) {
    addWarning(in.room, node.at, fmt::format("node {} has no window: it would draw nothing", rank));
    return;
  }
  for (const JsonNode& window : windows->children) readWindow(window, rank, in);
}

/// Converts one window with several viewports to a rig's one_window. Several such windows are separated.
void shareWindow(SgctReading& in) {
  const bool several = in.room.walls.size() > 1 && in.windows == 1;
  bool split = false;
  for (std::size_t i = 1; i < in.ofWindow.size(); ++i) split = split || in.ofWindow[i] == in.ofWindow[i - 1];
  if (!several) {
    if (split) {
      in.room.assumptions.push_back(
          "a window with several viewports becomes a window for each, at its place");
    }
    return;
  }
  const SgctReading::Place& place = in.places.front();
  in.room.oneWindow = WindowPlacement{place.monitor, glm::ivec2(place.position_px), glm::ivec2(place.size_px),
                                      place.fullscreen};
  for (RoomWall& wall : in.room.walls) {
    wall.wall.window.position_px -= in.room.oneWindow->position_px;
    wall.wall.window.monitor = 0;
    wall.wall.window.fullscreen = false;
  }
}

void assume(SgctReading& in) {
  in.room.assumptions.push_back("the viewer's eyes start where the first user's pos has them");
  in.room.assumptions.push_back("each node is drawn by the MPI rank of its place in the file");
  if (in.stereoLeftOut) in.room.assumptions.push_back("windows that name no stereo are mono, as in SGCT");
  if (std::any_of(in.room.walls.begin(), in.room.walls.end(), [](const RoomWall& wall) {
        return wall.wall.stereo == StereoMode::sideBySide || wall.wall.stereo == StereoMode::topBottom;
      })) {
    in.room.assumptions.push_back(
        "each eye's picture has all pixels of its viewport and is squeezed into its half");
  }
}

}  // namespace

Room readSgct(const std::filesystem::path& file) { return readSgct(file, readJson(file)); }

Room readSgct(const std::filesystem::path& file, JsonNode root) {
  SgctReading in{std::move(root), foreignRoom(file, "an SGCT room")};
  if (in.root.kind != Kind::object) {
    addError(in.room, in.root.at, fmt::format("this is {}, expected an object with nodes", in.root.words()));
    return std::move(in.room);
  }
  noteUnknown(in.root, kRootKeys, in.room);
  readUsers(in);
  if (const JsonNode* nodes = array(in.root, "nodes", in.room)) {
    for (const JsonNode& node : nodes->children) readNode(node, in);
  }
  if (in.room.walls.empty() && !in.room.hasErrors()) {
    addError(in.room, in.root.at,
             "no viewport here shows a wall, expected one with a projection of type 'ProjectionPlane', "
             "'PlanarProjection', 'FisheyeProjection', 'EquirectangularProjection', "
             "'CylindricalProjection' or 'SphericalMirrorProjection'");
  }
  shareWindow(in);
  assume(in);
  return std::move(in.room);
}

}  // namespace carom
