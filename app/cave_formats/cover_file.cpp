#include "app/cave_formats/cover_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>
#include <string_view>

#include "app/cave_formats/cover_config.h"
#include "app/cave_formats/cover_input.h"
#include "app/cave_formats/cover_windows.h"
#include "app/room_checks/foreign_room.h"
#include "app/room_checks/room_check.h"
#include "app/room_parts/included.h"
#include "app/room_parts/room_parts.h"

namespace carom {
namespace {

constexpr double kUsualWidth_mm = 2000.0, kUsualHeight_mm = 1500.0, kUsualRadius_mm = 2800.0;  // COVER's
constexpr std::array<std::string_view, 12> kQuietCover{"comment",    "name",        "decoration", "ARCH",
                                                       "swapGroup",  "swapBarrier", "type",       "resize",
                                                       "NumWindows", "MultiPC",     "Input",      "enable"};

/// The groups that say what a computer draws where; the others count for the master alone.
constexpr std::array<const char*, 5> kDrawing{"ScreenConfig", "ChannelConfig", "ViewportConfig",
                                              "WindowConfig", "PipeConfig"};

/// A computer with what it sees of the file.
struct CoverHost {
  std::string name;
  Part config;
  bool isMaster = false;
};

/// Where a screen stands, by its middle, or by the angles of a frustum from a point.
struct CoverScreen {
  glm::dvec3 middle_m{0.0};
  glm::dmat3 turn{1.0};
  double width_m = 0.0, height_m = 0.0;
};

/// Returns R = Rz(h)·Rx(p)·Ry(r).
glm::dmat3 coverTurn(const glm::dvec3& hpr_deg) {
  const glm::dvec3 a = glm::radians(hpr_deg);
  return glm::mat3_cast(glm::angleAxis(a.x, glm::dvec3(0, 0, 1)) * glm::angleAxis(a.y, glm::dvec3(1, 0, 0)) *
                        glm::angleAxis(a.z, glm::dvec3(0, 1, 0)));
}

/// A frustum's angles to the left and downwards are negative; its screen is at `radius_mm` along the turned y
/// (coCoverConfig::getScreenConfigEntry).
CoverScreen screenOfFrustum(const std::vector<double>& f, double radius_mm) {
  CoverScreen screen;
  screen.turn = coverTurn({f[3], f[4], f[5]});
  const auto reach_mm = [&](double angle_deg) { return std::tan(glm::radians(angle_deg)) * radius_mm; };
  const double left = -reach_mm(f[6]), right = reach_mm(f[7]), down = -reach_mm(f[8]), up = reach_mm(f[9]);
  screen.width_m = (left + right) * kCoverUnit_m;
  screen.height_m = (down + up) * kCoverUnit_m;
  const glm::dvec3 middle_mm(0.5 * (right - left), radius_mm, 0.5 * (up - down));
  screen.middle_m = kCoverUnit_m * (glm::dvec3(f[0], f[1], f[2]) + screen.turn * middle_mm);
  return screen;
}

struct CoverStereo {
  std::string_view name;
  StereoMode mode;
};
constexpr std::array<CoverStereo, 16> kCoverStereo{{{"LEFT", StereoMode::left},
                                                    {"RIGHT", StereoMode::right},
                                                    {"NONE", StereoMode::mono},
                                                    {"MONO", StereoMode::mono},
                                                    {"MIDDLE", StereoMode::mono},
                                                    {"QUAD_BUFFER", StereoMode::quadBuffer},
                                                    {"QUAD", StereoMode::quadBuffer},
                                                    {"ACTIVE", StereoMode::quadBuffer},
                                                    {"ANAGLYPHIC", StereoMode::anaglyph},
                                                    {"ANAGLYPH", StereoMode::anaglyph},
                                                    {"HORIZONTAL_SPLIT", StereoMode::sideBySide},
                                                    {"VERTICAL_SPLIT", StereoMode::topBottom},
                                                    {"HORIZONTAL_INTERLACE", StereoMode::interlaced},
                                                    {"VERTICAL_INTERLACE", StereoMode::interlaced},
                                                    {"CHECKERBOARD", StereoMode::checkerboard},
                                                    {"", StereoMode::mono}}};

constexpr std::array<std::string_view, 8> kPlaceKeys{"width",   "height", "originX", "originY",
                                                     "originZ", "h",      "p",       "r"};
/// Two screens of one name and place are the eyes of one wall.
bool areTwins(const Part& a, const Part& b) {
  if (a.textOf("comment") != b.textOf("comment")) return false;
  return std::all_of(kPlaceKeys.begin(), kPlaceKeys.end(),
                     [&](std::string_view key) { return a.textOf(key) == b.textOf(key); });
}

std::optional<CoverScreen> placeOf(const Part& screen, Room& room) {
  if (const Part* frustum = screen.find("frustum"); frustum && !frustum->text.empty()) {
    const auto values = numbersIn(*frustum, 10, room);
    if (!values) return {};
    return screenOfFrustum(*values, numberOr(screen, "radius", kUsualRadius_mm, room));
  }
  std::array<double, 8> values{kUsualWidth_mm, kUsualHeight_mm};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Part* part = screen.find(kPlaceKeys[i]);
    const auto value = part ? numberOf(*part, {}, false, room) : std::optional(values[i]);
    if (!value) return {};
    values[i] = *value;
  }
  return CoverScreen{kCoverUnit_m * glm::dvec3(values[2], values[3], values[4]),
                     coverTurn({values[5], values[6], values[7]}), values[0] * kCoverUnit_m,
                     values[1] * kCoverUnit_m};
}

class CoverReading {
 public:
  CoverReading(CoverSections& sections, std::string master, Room& room)
      : sections_(sections), master_(std::move(master)), room_(room), ranks_(room) {}

  void read() {
    collectHosts();
    if (hosts_.empty()) return;
    readCoverInput(hosts_.front().config, room_);
    if (const Part* floor = hosts_.front().config.find("FloorHeight")) {
      if (const auto height_mm = number(*floor, "value", {}, false, room_))
        room_.floor_m = *height_mm * kCoverUnit_m;
    }
    const bool slavesDraw = std::any_of(hosts_.begin(), hosts_.end(), [&](const CoverHost& host) {
      return !host.isMaster && !screensOf(host, false).empty();
    });
    for (CoverHost& host : hosts_) readHost(host, slavesDraw);
    ranks_.finish();
    nameUnread(hosts_.front().config, kQuietCover, room_);
    tellFloor();
  }

 private:
  /// A wall that is the floor counts, not FloorHeight: tells where they differ.
  void tellFloor() {
    constexpr double kNear_m = 1e-3;
    const auto floor_m = floorHeight_m(room_);
    if (!room_.floor_m || !floor_m || std::abs(*floor_m - *room_.floor_m) < kNear_m) return;
    addWarning(room_, hosts_.front().config.find("FloorHeight")->at,
               fmt::format("FloorHeight {:g} is left out: the wall that is the floor is at {:g} mm",
                           *room_.floor_m / kCoverUnit_m, *floor_m / kCoverUnit_m));
  }

  /// The master comes first, then the computers of MultiPC/SyncMode, which are all if it names any.
  void collectHosts() {
    if (!master_.empty()) add(master_, true);
    const Part first = master_.empty() && !sections_.hosts().empty()
                           ? sections_.configOf(sections_.hosts().front(), "")
                       : hosts_.empty() ? sections_.configOf("", "")
                                        : hosts_.front().config;
    const Part* multi = first.find("MultiPC");
    const Part* mode = multi ? multi->find("SyncMode") : nullptr;
    const Part* list = mode ? mode->find("hosts") : nullptr;
    if (list) {
      std::string name;
      for (const char c : list->text + ",") {
        if (c != ',' && c != ' ') {
          name += c;
          continue;
        }
        if (!name.empty()) add(name, name == master_);
        name.clear();
      }
    }
    for (const std::string& host : sections_.hosts()) {
      if (isThere(host)) continue;
      if (!list) {
        add(host, false);
      } else if (const Part config = sections_.configOf(host, master_); config.find("ScreenConfig")) {
        addWarning(room_, config.find("ScreenConfig")->at,
                   fmt::format("the screens of computer '{}' are left out: SyncMode does not name it",
                               printable(host)));
      }
    }
    if (hosts_.empty()) add("", false);  // sections for all computers alone
  }
  bool isThere(const std::string& name) const {
    return std::any_of(hosts_.begin(), hosts_.end(),
                       [&](const CoverHost& host) { return host.name == name; });
  }
  void add(const std::string& name, bool isMaster) {
    constexpr std::size_t kMostCoverHosts = 512;
    if (!isThere(name) && hosts_.size() < kMostCoverHosts)
      hosts_.push_back({name, sections_.configOf(name, master_), isMaster});
  }

  /// Returns the screens that a computer uses; with `tell`, says what it makes of NumScreens.
  std::vector<const Part*> screensOf(const CoverHost& host, bool tell) {
    std::vector<const Part*> screens = coverElements(host.config, "ScreenConfig", "Screen");
    const Part* given = host.config.find("NumScreens");
    if (!given || screens.empty()) return screens;
    const auto most = number(*given, "value", {.least = 0.0, .most = 512.0}, true, room_);
    if (!most || *most >= static_cast<double>(screens.size())) return screens;
    if (*most == 0.0) {
      if (tell)
        addWarning(room_, given->at,
                   fmt::format("NumScreens is 0 for computer '{}', which has {}: all are taken",
                               printable(host.name), screens.size()));
      return screens;
    }
    for (std::size_t i = static_cast<std::size_t>(*most); tell && i < screens.size(); ++i) {
      screens[i]->markRead();
      addWarning(room_, screens[i]->at,
                 fmt::format("screen '{}' of computer '{}' is left out: NumScreens is {}",
                             printable(screens[i]->textOf("comment")), printable(host.name), *most));
    }
    screens.resize(static_cast<std::size_t>(*most));
    return screens;
  }

  void readHost(const CoverHost& host, bool slavesDraw) {
    const std::vector<const Part*> screens = screensOf(host, true);
    if (host.isMaster && slavesDraw) {
      for (const Part* screen : screens) {
        addWarning(room_, screen->at,
                   fmt::format("screen '{}' of the master '{}' is left out: an operator's preview",
                               printable(screen->textOf("comment")), printable(host.name)));
      }
      for (const char* group : kDrawing) {
        if (const Part* found = host.config.find(group)) found->markRead();
      }
      return;
    }
    const std::vector<const Part*> channels = coverElements(host.config, "ChannelConfig", "Channel");
    const bool twins = screens.size() > 1 && areTwins(*screens[0], *screens[1]);
    for (std::size_t i = 0; i < std::max(screens.size(), channels.size()); ++i) {
      const Part* channel = i < channels.size() ? channels[i] : nullptr;
      const auto chosen = channel
                              ? number(*channel, "screenIndex", {.least = 0.0, .most = 512.0}, true, room_)
                              : std::nullopt;
      const auto index = static_cast<std::size_t>(chosen.value_or(static_cast<double>(i)));
      if (index >= screens.size()) {
        if (channel && !screens.empty())
          addWarning(room_, channel->at,
                     fmt::format("channel {} of computer '{}' is left out: it has no screen {}", i,
                                 printable(host.name), index));
        continue;
      }
      if (!flagOr(*screens[index], "render", true, room_)) {
        addWarning(room_, screens[index]->at,
                   fmt::format("screen '{}' of computer '{}' is left out: it is not rendered",
                               printable(screens[index]->textOf("comment")), printable(host.name)));
        continue;
      }
      readScreen(host, *screens[index], {i, channel}, twins);
    }
    for (const char* group : {"PBOConfig", "BlendingTextureConfig"}) {
      const Part* found = host.config.find(group);
      if (found) found->markRead();
      if (found && !found->parts.empty())
        addWarning(room_, found->at,
                   fmt::format("{} is left out: put the projector's warp and blend into the rig by "
                               "hand",
                               group));
    }
    if (screens.empty()) return;
    for (const char* group : kDrawing) {
      const Part* found = host.config.find(group);
      if (!found) continue;
      for (const Part& element : found->parts) {
        // What old files say in both a channel and its viewport.
        for (const char* twice : {"screen", "channel", "window", "windowIndex"}) element.find(twice);
      }
      nameUnread(*found, kQuietCover, room_);
    }
  }

  /// A channel without a mode has the computer's; where the first two screens are one, channels are for the
  /// left and the right eye in turn.
  StereoMode stereoOf(const CoverHost& host, const CoverChannel& channel, bool twins) {
    const Part* mode = channel.part ? channel.part->find("stereoMode") : nullptr;
    if (mode && !mode->text.empty()) return modeOf(*mode);
    if (twins) return channel.index % 2 == 0 ? StereoMode::left : StereoMode::right;
    const Part* ofAll = host.config.find("StereoMode");
    const Part* value = ofAll ? ofAll->find("value") : nullptr;
    return value ? modeOf(*value) : StereoMode::mono;
  }

  StereoMode modeOf(const Part& mode) {
    for (const CoverStereo& known : kCoverStereo) {
      if (alike(mode.text, known.name)) return known.mode;
    }
    addWarning(room_, mode.textAt,
               fmt::format("stereoMode '{}' is not known here: mono is taken", printable(mode.text)));
    return StereoMode::mono;
  }

  void readScreen(const CoverHost& host, const Part& screen, const CoverChannel& channel, bool twins) {
    RoomWall wall;
    wall.wall.stereo = stereoOf(host, channel, twins);
    std::string name = screen.textOf("comment");
    if (name.empty()) name = "screen";
    const bool oneEye = wall.wall.stereo == StereoMode::left || wall.wall.stereo == StereoMode::right;
    wall.wall.name =
        oneEye ? fmt::format("{}-{}", name, wall.wall.stereo == StereoMode::left ? "left" : "right") : name;
    const FilePlace at = screen.at;
    wall.at = {at, screen.placeOf("comment"), at, channel.part ? channel.part->at : at, at, at, at};
    const auto place = placeOf(screen, room_);
    CoverWindows windows(host.config, room_);
    windows.placeOnWindow(channel, wall);
    if (!place) return;
    wall.wall.node = ranks_.of(host.name, windows.displayOf(channel), at);
    addWall(std::move(wall),
            rectangleAround(place->middle_m, place->turn[0], place->turn[2], place->width_m, place->height_m),
            room_);
  }

  CoverSections& sections_;
  std::string master_;
  Room& room_;
  Ranks ranks_;
  std::deque<CoverHost> hosts_;
};

}  // namespace

Room readCover(const std::filesystem::path& file, Part root, const std::string& wanted) {
  Room room = roomOfFormat(file, "an OpenCOVER room", "mm", kCoverUnit_m);
  room.axes = {.right = {1, 0, 0}, .up = {0, 0, 1}, .forward = {0, 1, 0}};
  Included(file, "INCLUDE", room).expand(root);
  CoverSections sections(root, room);
  std::string master;
  if (sections.masters().empty()) {
    refuseRoomName(wanted, file);
  } else {
    std::vector<FilePlace> places;
    for (const std::string& each : sections.masters()) places.push_back(sections.placeOfMaster(each));
    master = sections.masters()[chooseRoom(sections.masters(), places, wanted, file)];
  }
  CoverReading(sections, master, room).read();
  room.assumptions.push_back("lengths are millimetres, axes x right, y forward, z up, as COVER has them");
  room.assumptions.push_back(
      "each computer with walls is drawn by an MPI rank, the master first, then as SyncMode has them");
  finishRoom("a Screen in the ScreenConfig of a computer", room);
  return room;
}

}  // namespace carom
