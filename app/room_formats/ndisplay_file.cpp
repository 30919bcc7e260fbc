#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "app/room_checks/foreign_room.h"
#include "app/room_formats/ndisplay_file.h"
#include "app/room_formats/ndisplay_scene.h"

namespace carom {
namespace {

constexpr double kCentimetre_m = 0.01;
constexpr std::array<std::string_view, 22> kQuietNdisplay{"bufferRatio",
                                                          "description",
                                                          "version",
                                                          "assetPath",
                                                          "misc",
                                                          "diagnostics",
                                                          "gPUIndex",
                                                          "allowCrossGPUTransfer",
                                                          "isShared",
                                                          "overscan",
                                                          "sound",
                                                          "renderHeadless",
                                                          "graphicsAdapter",
                                                          "textureShare",
                                                          "postprocess",
                                                          "ports",
                                                          "network",
                                                          "failover",
                                                          "sync",
                                                          "crossGPUTransfer",
                                                          "GPUIndex",
                                                          "isVisible"};

/// A viewport of a node whose wall is still to be added.
struct NdisplayView {
  const Part* node;
  const Part* viewport;
  const Part* screen;  ///< its name
  const Part* camera;  ///< its part in the scene, or null
};

class NdisplayReading {
 public:
  NdisplayReading(const Part& config, Room& room)
      : config_(config), room_(room), scene_(room), ranks_(room) {}

  void read() {
    readScene();
    const Part* cluster = config_.find("cluster");
    const Part* nodes = cluster ? cluster->find("nodes") : nullptr;
    if (!nodes) {
      addError(room_, cluster ? cluster->at : config_.at,
               "cluster.nodes is missing, expected one node at least");
      return;
    }
    const std::string primary = primaryOf(*cluster);
    for (const Part& node : nodes->parts) {
      if (node.name == primary) collectViews(node);
    }
    for (const Part& node : nodes->parts) {
      if (node.name != primary) collectViews(node);
    }
    findHead();
    readEyes();
    for (const NdisplayView& view : views_) readView(view);
    ranks_.finish();
    scene_.tellUnused(screens_, head_);
    nameUnread(config_, kQuietNdisplay, room_);
  }

 private:
  std::string primaryOf(const Part& cluster) const {
    for (const char* name : {"primaryNode", "masterNode"}) {
      if (const Part* primary = cluster.find(name)) return primary->textOf("id");
    }
    return {};
  }

  void readScene() {
    const Part* scene = config_.find("scene");
    if (!scene) return addError(room_, config_.at, "scene is missing, expected the screens");
    for (const char* kind : {"xforms", "cameras", "screens"}) {
      const Part* group = scene->find(kind);
      for (const Part& part : partsOf(group)) readComponent(part, kind);
    }
    cameras_ = scene->find("cameras");
  }

  void readComponent(const Part& part, std::string_view kind) {
    part.isRead = true;
    SceneNode node{.id = part.name, .parent = part.textOf("parentId")};
    node.at = part.at;
    node.parentAt = part.placeOf("parentId");
    if (const Part* location = part.find("location")) {
      for (int i = 0; i < 3; ++i)
        node.local.position_m[i] =
            kCentimetre_m *
            numberOr(*location, std::array{"x", "y", "z"}[static_cast<std::size_t>(i)], 0.0, room_);
    }
    if (const Part* turn = part.find("rotation")) {
      node.local.matrix =
          unrealRotation(numberOr(*turn, "pitch", 0.0, room_), numberOr(*turn, "yaw", 0.0, room_),
                         numberOr(*turn, "roll", 0.0, room_));
    }
    if (kind == "screens") {
      const Part* size = part.find("size");
      if (!size)
        addError(room_, part.at, fmt::format("size is missing in screen '{}'", printable(part.name)));
      node.width_m = size ? kCentimetre_m * numberOr(*size, "width", 0.0, room_) : 0.0;
      node.height_m = size ? kCentimetre_m * numberOr(*size, "height", 0.0, room_) : 0.0;
      screens_.push_back(part.name);
    }
    node.isCamera = kind == "cameras";
    scene_.add(std::move(node));
  }

  void collectViews(const Part& node) {
    node.isRead = true;
    const Part* viewports = node.find("viewports");
    if (!viewports || viewports->parts.empty()) {
      node.markRead();
      return addWarning(room_, node.at,
                        fmt::format("node '{}' has no viewport: it draws nothing", printable(node.name)));
    }
    for (const Part& viewport : viewports->parts) {
      viewport.isRead = true;
      const Part* policy = viewport.find("projectionPolicy");
      const Part* type = policy ? policy->find("type") : nullptr;
      const Part* parameters = policy ? policy->find("parameters") : nullptr;
      if (!type || !alike(type->text, "simple")) {
        viewport.markRead();
        addWarning(room_, type ? type->textAt : viewport.at,
                   fmt::format("viewport '{}' by the projection policy '{}' is left out: it names no flat "
                               "screen, expected simple",
                               printable(viewport.name), type ? printable(type->text) : ""));
        continue;
      }
      const Part* screen = parameters ? parameters->find("screen") : nullptr;
      if (!screen || !scene_.find(screen->text)) {
        addError(room_, screen ? screen->textAt : policy->at,
                 screen ? fmt::format("there is no screen '{}'", printable(screen->text))
                        : "parameters.screen is missing, expected the name of a screen");
        continue;
      }
      const std::string camera = viewport.textOf("camera");
      views_.push_back({&node, &viewport, screen, cameras_ ? cameras_->find(camera) : nullptr});
    }
  }

  /// The head is the component on which the cameras hang, unless all screens hang there, too.
  void findHead() {
    for (const NdisplayView& view : views_) {
      const std::string parent = view.camera ? view.camera->textOf("parentId") : "";
      if (!parent.empty() && !std::all_of(screens_.begin(), screens_.end(), [&](const std::string& screen) {
            return scene_.hangsOn(screen, parent);
          })) {
        head_ = parent;
      }
    }
  }

  void readEyes() {
    const Part* camera = nullptr;
    for (const NdisplayView& view : views_) camera = view.camera ? view.camera : camera;
    if (!camera && cameras_ && !cameras_->parts.empty()) camera = &cameras_->parts.front();
    double apart_m = 0.064;  // nDisplay's default
    FilePlace at = config_.at;
    if (camera) {
      const auto distance = number(*camera, "interpupillaryDistance", kNotNegative, false, room_);
      apart_m = distance ? *distance * kCentimetre_m : apart_m;
      at = camera->placeOf("interpupillaryDistance");
      swapsEyes_ = flagOr(*camera, "swapEyes", false, room_);
      if (swapsEyes_)
        addWarning(room_, camera->placeOf("swapEyes"), "swapEyes: the eyes of all walls change places");
    }
    addPerson("viewer", apart_m, kStandingEyes_m * room_.axes.up, at, "someone standing on the origin",
              room_);
    const std::string apart = camera ? camera->textOf("interpupillaryDistance") : "";
    for (const Part& other : partsOf(cameras_)) {
      const bool isUsed = std::any_of(views_.begin(), views_.end(),
                                      [&](const NdisplayView& view) { return view.camera == &other; });
      if (!isUsed) other.markRead();
      if (other.textOf("interpupillaryDistance") == apart) other.find("swapEyes");
    }
    if (!head_.empty()) {
      addWarning(
          room_, at,
          fmt::format("the tracker of '{}' is not in this file: put it into the rig as a [[tracker]] and "
                      "measure its room_from_tracker",
                      printable(head_)));
    }
  }

  StereoMode eyeOf(const NdisplayView& view) {
    const Part* offset = view.camera ? view.camera->find("stereoOffset") : nullptr;
    if (!offset || alike(offset->text, "none") || offset->text.empty()) return StereoMode::mono;
    if (alike(offset->text, "left")) return swapsEyes_ ? StereoMode::right : StereoMode::left;
    if (alike(offset->text, "right")) return swapsEyes_ ? StereoMode::left : StereoMode::right;
    addWarning(room_, offset->textAt,
               fmt::format("stereoOffset is '{}', expected left, right or none: mono is taken",
                           printable(offset->text)));
    return StereoMode::mono;
  }

  /// Returns x, y, w and h of a window or region in pixels.
  std::optional<std::array<int, 4>> pixelsOf(const Part& whole, std::string_view name) {
    const Part* rectangle = whole.find(name);
    if (!rectangle) return {};
    std::array<int, 4> values{};
    constexpr std::array<std::string_view, 4> kNames{"x", "y", "w", "h"};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Range range =
          i < 2 ? Range{.least = -65536.0, .most = 65536.0} : Range{.least = 1.0, .most = kMostRoomPixels};
      if (!rectangle->find(kNames[i]))
        addError(room_, rectangle->at, fmt::format("{} is missing in {}", kNames[i], name));
      const auto value = number(*rectangle, kNames[i], range, true, room_);
      if (!value) return {};
      values[i] = static_cast<int>(*value);
    }
    return values;
  }

  void readView(const NdisplayView& view) {
    const std::string& screen = view.screen->text;
    if (!head_.empty() && scene_.hangsOn(screen, head_)) {
      view.viewport->markRead();
      for (const char* ofNode : {"host", "window", "fullScreen"}) {
        if (const Part* part = view.node->find(ofNode)) part->markRead();
      }
      return addWarning(
          room_, view.screen->textAt,
          fmt::format("viewport '{}' of node '{}' is left out: its screen '{}' hangs on the head "
                      "'{}', an operator's preview",
                      printable(view.viewport->name), printable(view.node->name), printable(screen),
                      printable(head_)));
    }
    RoomWall wall;
    const Part& viewport = *view.viewport;
    wall.at = {viewport.at, viewport.at, scene_.find(screen)->at, viewport.placeOf("region"), view.node->at,
               viewport.at, viewport.at};
    wall.wall.name = viewport.name;
    wall.wall.stereo = eyeOf(view);
    const auto window = pixelsOf(*view.node, "window"), region = pixelsOf(viewport, "region");
    if (window) {
      WindowPlacement placed;
      placed.position_px = {(*window)[0], (*window)[1]};
      placed.size_px = {(*window)[2], (*window)[3]};
      placed.fullscreen = flagOr(*view.node, "fullScreen", false, room_);
      placeInWindow(placed, region ? glm::ivec2((*region)[0], (*region)[1]) : glm::ivec2(0),
                    region ? glm::ivec2((*region)[2], (*region)[3]) : placed.size_px, wall, room_);
    } else if (region) {
      wall.wall.pixels = wall.wall.window.size_px = {(*region)[2], (*region)[3]};
    }
    if (const Part* remap = viewport.find("outputRemap")) remap->isRead = true;
    warnOfRemap(*view.node);
    const std::string host = view.node->textOf("host");
    const auto corners = scene_.cornersOf(screen);
    if (!corners) return;
    // Two processes of a computer, one for each eye, are two ranks of it.
    wall.wall.node = rankOf(view.node, host);
    addWall(std::move(wall), *corners, room_);
  }

  int rankOf(const Part* node, const std::string& host) {
    const auto known = rankOfNode_.find(node);
    if (known != rankOfNode_.end()) return known->second;
    const int rank = ranks_.next(host == "127.0.0.1" || host == "localhost" ? "" : host, node->at);
    rankOfNode_.emplace(node, rank);
    return rank;
  }

  void warnOfRemap(const Part& node) {
    const Part* remap = node.find("outputRemap");
    if (!remap) return;
    remap->markRead();
    if (flagOr(*remap, "bEnable", false, room_))
      addWarning(
          room_, remap->at,
          fmt::format("the output of node '{}' is warped: put the projector's warp into the rig by hand",
                      printable(node.name)));
  }

  const Part& config_;
  Room& room_;
  NdisplayScene scene_;
  Ranks ranks_;
  const Part* cameras_ = nullptr;
  std::vector<std::string> screens_;
  std::vector<NdisplayView> views_;
  std::string head_;
  bool swapsEyes_ = false;
  std::map<const Part*, int> rankOfNode_;
};

}  // namespace

Room readNdisplay(const std::filesystem::path& file, const Part& root) {
  Room room = roomOfFormat(file, "an nDisplay room", "cm", kCentimetre_m);
  refuseTwinMembers(root, room);
  NdisplayReading(*root.find("nDisplay"), room).read();
  room.assumptions.push_back(
      "the file is left-handed, x forward, y right, z up, in centimetres: it is turned to x right, y up, z "
      "back");
  room.assumptions.push_back("each node with walls is drawn by an MPI rank, the primary node first");
  finishRoom("a viewport by the policy 'simple' with a screen", room);
  return room;
}

}  // namespace carom
