#include "app/room_parts/room_parts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <set>
#include <stdexcept>

#include "app/file_keys/rig_keys.h"
#include "app/rig/rig_screen.h"
#include "app/room_checks/foreign_room.h"
#include "cave/room/rectangle.h"
#include "cave/screen/flat_pieces.h"
#include "devices/setup/tracker_factory.h"

namespace carom {
namespace {

constexpr std::size_t kMostRoomWalls = 512;
constexpr int kAssumedLines_px = 1080;

/// Returns whether the room may have one more curved wall of this many pixels: meshes take memory and time.
bool takesCurved(const RoomWall& wall, const Room& room) {
  constexpr int kMostCurved_px = 8192;
  constexpr std::ptrdiff_t kMostCurved = 16;
  return std::max(wall.wall.pixels.x, wall.wall.pixels.y) <= kMostCurved_px &&
         std::count_if(room.walls.begin(), room.walls.end(),
                       [](const RoomWall& other) { return other.wall.screen != nullptr; }) < kMostCurved;
}

bool isPlain(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

/// Returns whether a rig takes the text for a computer's name.
bool isHostName(const std::string& host) {
  return !host.empty() && isPlain(host[0]) && std::all_of(host.begin(), host.end(), [](char c) {
    return isPlain(c) || c == '-' || c == '_' || c == '.';
  });
}

void assumePixels(RoomWall& wall, Room& room) {
  const double width_m = glm::distance(wall.wall.lowerLeft_m, wall.wall.lowerRight_m);
  const double height_m = glm::distance(wall.wall.lowerLeft_m, wall.wall.upperLeft_m);
  const double width_px = std::clamp(kAssumedLines_px * width_m / height_m, 1.0, kMostRoomPixels);
  wall.wall.pixels = {static_cast<int>(std::lround(width_px)), kAssumedLines_px};
  if (wall.wall.window.size_px.x == 0) wall.wall.window.size_px = wall.wall.pixels;
  addWarning(room, wall.at.pixels,
             fmt::format("nothing gives the pixels of wall '{}'; {} × {} are taken", wall.wall.name,
                         wall.wall.pixels.x, wall.wall.pixels.y));
}

/// Returns whether the room may have one wall more; adds an error if not.
bool takesWall(const RoomWall& wall, Room& room) {
  if (room.walls.size() < kMostRoomWalls) return true;
  addError(room, wall.at.wall, fmt::format("there are more than {} walls", kMostRoomWalls));
  return false;
}

/// Gives the wall a name that a rig takes, and tells where it differs from the file's.
void nameWall(RoomWall& wall, Room& room) {
  const std::string given = printable(wall.wall.name), plain = plainName(given);
  const FilePlace at = wall.at.name;
  wall.wall.name = rigName(room, given);
  if (wall.wall.name != plain) {
    const auto first = std::find_if(room.walls.begin(), room.walls.end(),
                                    [&](const RoomWall& other) { return other.wall.name == plain; });
    addWarning(room, at,
               fmt::format("the name '{}' is that of the wall of line {}, too: this one is called '{}'",
                           plain, first->at.name.line, wall.wall.name));
  } else if (!given.empty() && plain != given) {
    room.assumptions.push_back(
        fmt::format("the wall '{}' is called '{}', as a rig's names are, line {}", given, plain, at.line));
  }
}

bool sameWindow(const RoomWall& a, const RoomWall& b) {
  return a.wall.node == b.wall.node && a.wall.window == b.wall.window;
}

bool overlap(const Viewport& a, const Viewport& b) {
  const glm::ivec2 low = glm::max(a.position_px, b.position_px);
  const glm::ivec2 high = glm::min(a.position_px + a.size_px, b.position_px + b.size_px);
  return low.x < high.x && low.y < high.y;
}

Viewport partOf(const RoomWall& wall) {
  return wall.wall.viewport.value_or(Viewport{{0, 0}, wall.wall.window.size_px});
}

/// Leaves out people for whom no wall is, with a warning: a rig has none.
void dropUnseen(Room& room) {
  std::vector<bool> seen(room.people.size(), false);
  for (const RoomWall& wall : room.walls) {
    if (wall.wall.eyes.empty()) seen.at(wall.wall.viewer) = true;
    for (const ViewerEye& eye : wall.wall.eyes) seen.at(eye.viewer) = true;
  }
  std::vector<std::size_t> now(room.people.size());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < room.people.size(); ++i) {
    now[i] = kept;
    if (seen[i]) {
      if (kept != i) {
        room.people[kept] = std::move(room.people[i]);
        room.viewers[kept] = std::move(room.viewers[i]);
      }
      ++kept;
    } else {
      addWarning(room, room.viewers[i].at,
                 fmt::format("viewer '{}' is left out: no wall is for them", room.people[i].setup.name));
    }
  }
  room.people.resize(kept);
  room.viewers.resize(kept);
  room.eyeSeparation_m = room.people.front().setup.head.eyeSeparation_m;
  for (RoomWall& wall : room.walls) {
    wall.wall.viewer = wall.wall.eyes.empty() ? now[wall.wall.viewer] : now[wall.wall.eyes.front().viewer];
    for (ViewerEye& eye : wall.wall.eyes) eye.viewer = now[eye.viewer];
  }
}

/// Tells that a device is the same tracker as one before it, and what of it does not count therefore.
void tellSame(const TrackerSetup& first, const TrackerSetup& other, const std::string& name, FilePlace at,
              Room& room) {
  constexpr double kNear_m = 1e-6, kNear = 1e-9;
  const Pose &a = first.roomFromTracker, &b = other.roomFromTracker;
  const bool isThere = glm::distance(a.position_m, b.position_m) < kNear_m &&
                       std::abs(glm::dot(a.orientation, b.orientation)) > 1.0 - kNear;
  addWarning(room, at,
             fmt::format("tracker '{}' is the one that is called '{}' here{}", name, first.name,
                         isThere ? "" : ", whose place in the room counts"));
}

/// Returns the unit vector of an axis by its name, "X" or "-Z"; none for other words.
std::optional<glm::dvec3> axisNamed(std::string_view name) {
  double sign = 1.0;
  if (!name.empty() && (name[0] == '-' || name[0] == '+')) {
    if (name[0] == '-') sign = -1.0;
    name.remove_prefix(1);
  }
  for (int i = 0; i < 3; ++i) {
    if (!alike(name, std::string_view("XYZ").substr(static_cast<std::size_t>(i), 1))) continue;
    glm::dvec3 axis(0.0);
    axis[i] = sign;
    return axis;
  }
  return {};
}

}  // namespace

Room roomOfFormat(const std::filesystem::path& file, std::string format, std::string unit, double unit_m) {
  Room room;
  room.file = file;
  room.title = printable(file.stem().string());
  room.format = std::move(format);
  room.unit = std::move(unit);
  room.unit_m = unit_m;
  room.originUnderViewer = false;
  return room;
}

ReadCorners rectangleAround(const glm::dvec3& middle_m, const glm::dvec3& right, const glm::dvec3& up,
                            double width_m, double height_m) {
  const glm::dvec3 across_m = 0.5 * width_m * right, upwards_m = 0.5 * height_m * up;
  return {middle_m - across_m - upwards_m, middle_m + across_m - upwards_m, middle_m - across_m + upwards_m};
}

bool addWall(RoomWall wall, const ReadCorners& corners, Room& room) {
  if (!takesWall(wall, room)) return false;
  nameWall(wall, room);
  const ThreeCorners three{{corners.lowerRight_m, corners.lowerLeft_m, corners.upperLeft_m},
                           {corners.names[1], corners.names[0], corners.names[2]}};
  if (const auto fault = rectangleFault(wall.wall.name, three)) {
    addError(room, wall.at.corner, fault->what);
    return false;
  }
  wall.wall.lowerLeft_m = corners.lowerLeft_m;
  wall.wall.lowerRight_m = corners.lowerRight_m;
  wall.wall.upperLeft_m = corners.upperLeft_m;
  if (wall.wall.pixels.x <= 0 || wall.wall.pixels.y <= 0) assumePixels(wall, room);
  room.walls.push_back(std::move(wall));
  return true;
}

bool addCurvedWall(RoomWall wall, const ScreenFormula& shape, Room& room) {
  if (!takesWall(wall, room)) return false;
  if (!takesCurved(wall, room)) {
    addError(room, wall.at.wall, "expected at most 16 curved walls, of at most 8192 pixels each way");
    return false;
  }
  nameWall(wall, room);
  if (const auto fault = curve({.shape = shape, .sagitta_m = sagittaFor_m(shape)}, room.axes, wall.wall)) {
    addError(
        room, wall.at.wall,
        fault->isOfFile
            ? fault->what
            : fmt::format("the screen of wall '{}' takes more than {} flat pieces, expected a smaller one",
                          wall.wall.name, kMostPieces));
    return false;
  }
  room.walls.push_back(std::move(wall));
  return true;
}

void placeInWindow(const WindowPlacement& window, glm::ivec2 position_px, glm::ivec2 size_px, RoomWall& wall,
                   Room& room) {
  wall.wall.window = window;
  const glm::ivec2 low = glm::clamp(position_px, glm::ivec2(0), window.size_px - 1);
  const glm::ivec2 high = glm::clamp(position_px + size_px, low + 1, window.size_px);
  if (low != position_px || high - low != size_px) {
    addWarning(
        room, wall.at.pixels,
        fmt::format("this part of {} × {} pixels at ({}, {}) reaches out of its window of {} × {}: it is "
                    "cut to {} × {}",
                    size_px.x, size_px.y, position_px.x, position_px.y, window.size_px.x, window.size_px.y,
                    high.x - low.x, high.y - low.y));
  }
  wall.wall.pixels = high - low;
  if (high - low != window.size_px) wall.wall.viewport = Viewport{low, high - low};
}

void separateOverlaps(Room& room) {
  for (std::size_t i = 0; i < room.walls.size(); ++i) {
    RoomWall& wall = room.walls[i];
    const bool overlaps = std::any_of(
        room.walls.begin(), room.walls.begin() + static_cast<std::ptrdiff_t>(i), [&](const RoomWall& other) {
          return sameWindow(other, wall) && overlap(partOf(other), partOf(wall)) &&
                 (other.wall.viewport || wall.wall.viewport);
        });
    if (!overlaps) continue;
    const Viewport part = partOf(wall);
    addWarning(room, wall.at.window,
               fmt::format("wall '{}' overlaps another in its window: it gets a window of its own at that "
                           "place",
                           wall.wall.name));
    wall.wall.window.position_px += part.position_px;
    wall.wall.window.size_px = part.size_px;
    wall.wall.window.fullscreen = false;
    wall.wall.viewport.reset();
  }
}

int Ranks::of(const std::string& host, const std::string& display, FilePlace at) {
  const auto found = std::find_if(seats_.begin(), seats_.end(), [&](const Seat& seat) {
    return seat.host == host && seat.display == display;
  });
  if (found != seats_.end()) return static_cast<int>(found - seats_.begin());
  return add({host, display, at});
}

int Ranks::next(const std::string& host, FilePlace at) { return add({host, "", at}); }

int Ranks::add(Seat seat) {
  if (seats_.size() >= static_cast<std::size_t>(kMostRanks)) {
    addError(room_, seat.at, fmt::format("there are more than {} computers and displays", kMostRanks));
    return 0;
  }
  seats_.push_back(std::move(seat));
  return static_cast<int>(seats_.size()) - 1;
}

void Ranks::finish() {
  for (std::size_t i = 0; i < seats_.size(); ++i) {
    Seat& seat = seats_[i];
    const std::string host = isHostName(seat.host) ? seat.host : "";
    if (host != seat.host) {
      addWarning(room_, seat.at,
                 fmt::format("'{}' is no name of a computer that a rig takes, expected letters, digits, -, _ "
                             "and dots: rank {} has none",
                             printable(seat.host), i));
    }
    const std::string display = printable(seat.display);
    if (host.empty() && display.empty()) continue;
    NodeSetup* last = room_.nodes.empty() ? nullptr : &room_.nodes.back();
    if (last && display.empty() && last->display.empty() && last->host == host &&
        last->rank + last->slots == static_cast<int>(i)) {
      ++last->slots;
      continue;
    }
    room_.nodes.push_back({static_cast<int>(i), display, host});
    room_.nodesAt.push_back(seat.at);
  }
}

std::string viewerName(const Room& room, std::string_view given) {
  std::string plain(given);
  std::replace_if(
      plain.begin(), plain.end(), [](char c) { return !isPlain(c) && c != '-' && c != '_'; }, '-');
  if (plain.empty()) plain = "viewer";
  std::string name = plain;
  const auto taken = [&] {
    return std::any_of(room.people.begin(), room.people.end(),
                       [&](const Person& person) { return person.setup.name == name; });
  };
  for (int number = 2; taken(); ++number) name = fmt::format("{}-{}", plain, number);
  return name;
}

std::size_t addPerson(std::string_view name, double eyeSeparation_m, const glm::dvec3& eyes_m, FilePlace at,
                      std::string words, Room& room) {
  Person person;
  person.setup.name = viewerName(room, name);
  person.setup.head.eyeSeparation_m = eyeSeparation_m;
  room.people.push_back(std::move(person));
  room.viewers.push_back({eyes_m, at, std::move(words)});
  if (room.people.size() == 1) {
    room.eyeSeparation_m = eyeSeparation_m;
    room.eyeSeparationAt = at;
  }
  return room.people.size() - 1;
}

void leaveOutPlace(std::size_t person, FilePlace at, Room& room) {
  if (!room.people.at(person).isTracked) return;
  room.assumptions.push_back(
      fmt::format("the place of {} is left out, for the tracker says where the eyes are, line {}",
                  room.viewers.at(person).words, at.line));
}

std::optional<std::size_t> addTracker(TrackerSetup tracker, FilePlace at, Room& room) {
  const std::string given = tracker.name.empty() ? "tracker" : printable(tracker.name);
  try {
    rowOf(tracker.kind).make(tracker, room.axes);
  } catch (const std::invalid_argument& wrong) {
    addWarning(room, at, fmt::format("tracker '{}' is left out: {}", given, wrong.what()));
    return {};
  }
  for (std::size_t i = 0; i < room.trackers.size(); ++i) {
    if (room.trackers[i].kind != tracker.kind || room.trackers[i].source != tracker.source) continue;
    if (room.trackers[i].name != given) tellSame(room.trackers[i], tracker, given, at, room);
    return i;
  }
  if (room.trackers.size() >= kMostTrackers) {
    addWarning(room, at, fmt::format("a tracker is left out: a rig has at most {}", kMostTrackers));
    return {};
  }
  const auto taken = [&] {
    return std::any_of(room.trackers.begin(), room.trackers.end(),
                       [&](const TrackerSetup& other) { return other.name == tracker.name; });
  };
  tracker.name = given;
  for (int number = 2; taken(); ++number) tracker.name = fmt::format("{}-{}", given, number);
  if (tracker.name != given)
    addWarning(room, at,
               fmt::format("the name '{}' is that of another tracker: this one is called '{}'", given,
                           tracker.name));
  room.trackers.push_back(std::move(tracker));
  return room.trackers.size() - 1;
}

std::optional<std::size_t> addVrpn(std::string_view name, std::string_view address,
                                   const Pose& roomFromTracker, FilePlace at, Room& room) {
  const std::size_t sign = address.find('@');
  std::string host(sign == std::string_view::npos ? "localhost" : address.substr(sign + 1));
  const std::string sender(address.substr(0, sign));
  if (host.find("://") == std::string::npos) host = "tcp://" + host;
  return addTracker({.name = std::string(name),
                     .kind = TrackerKind::vrpn,
                     .source = sender + "@" + host,
                     .roomFromTracker = roomFromTracker},
                    at, room);
}

std::optional<std::size_t> addDtrack(std::string_view name, int port, const Pose& roomFromTracker,
                                     FilePlace at, Room& room) {
  return addTracker({.name = std::string(name),
                     .kind = TrackerKind::dtrack,
                     .source = fmt::format("udp://0.0.0.0:{}", port),
                     .roomFromTracker = roomFromTracker},
                    at, room);
}

std::optional<std::size_t> addTrackd(std::string_view name, const TrackdMemory& memory,
                                     const Pose& roomFromTracker, FilePlace at, Room& room) {
  return addTracker({.name = std::string(name),
                     .kind = TrackerKind::trackd,
                     .source = fmt::format("shm://{}{}", memory.sensors,
                                           memory.wand ? fmt::format("?wand={}", *memory.wand) : ""),
                     .unit_m = memory.unit_m,
                     .roomFromTracker = roomFromTracker},
                    at, room);
}

std::optional<double> rigUnit_m(double unit_m, FilePlace at, Room& room) {
  constexpr double kSame = 1e-3;  // files round the foot
  for (const double known_m : kMetresPerUnit) {
    if (std::abs(unit_m - known_m) <= kSame * known_m) return known_m;
  }
  addWarning(
      room, at,
      fmt::format("lengths in units of {} m are none that a rig has, expected mm, cm, m, in or ft", unit_m));
  return {};
}

std::optional<glm::dquat> rotationOf(const glm::dmat3& matrix) {
  constexpr double kRounding = 1e-3;
  const glm::dmat3 square = glm::transpose(matrix) * matrix;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      if (std::abs(square[i][k] - (i == k ? 1.0 : 0.0)) > kRounding) return {};
    }
  }
  if (glm::determinant(matrix) < 0.0) return {};
  return glm::normalize(glm::quat_cast(matrix));
}

std::optional<glm::dquat> turnOfAxes(const std::string& right, const std::string& up,
                                     const std::string& forward, FilePlace at, Room& room) {
  const auto x = axisNamed(right), y = axisNamed(up), z = axisNamed(forward);
  if (x && y && z) {
    // Rows: the room's x is the tracker's axis to the right, and so on.
    if (const auto turn = rotationOf(glm::transpose(glm::dmat3(*x, *y, -*z)))) return turn;
  }
  addWarning(room, at,
             fmt::format("the tracker's axes right '{}', up '{}' and forward '{}' are no rotation of a "
                         "right-handed tracker: measure its room_from_tracker by carom calibrate",
                         printable(right), printable(up), printable(forward)));
  return {};
}

void finishRoom(std::string_view expected, Room& room, FilePlace at) {
  std::set<std::string> told;
  std::erase_if(room.assumptions, [&](const std::string& text) { return !told.insert(text).second; });
  if (room.walls.empty() && !room.hasErrors())
    addError(room, at, fmt::format("there is no wall here, expected {}", expected));
  separateOverlaps(room);
  if (!room.walls.empty() && room.people.size() > 1) dropUnseen(room);
  if (room.viewers.empty()) room.viewers.push_back({kStandingEyes_m * room.axes.up, {}, "a viewer"});
}

void refuseRoomName(const std::string& wanted, const std::filesystem::path& file) {
  if (wanted.empty()) return;
  throw InputErrors({InputError(
      file.string(), 1, 1,
      fmt::format("this file has one room without a name, expected no --room '{}'", printable(wanted)))});
}

std::size_t chooseRoom(const std::vector<std::string>& names, const std::vector<FilePlace>& places,
                       const std::string& wanted, const std::filesystem::path& file) {
  const auto found = std::find(names.begin(), names.end(), wanted);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  if (names.size() == 1 && wanted.empty()) return 0;
  constexpr std::size_t kMostNamed = 100;
  std::vector<std::string> shown;
  for (std::size_t i = 0; i < std::min(names.size(), kMostNamed); ++i) shown.push_back(printable(names[i]));
  const std::string all = fmt::format("--room with one of '{}'{}", fmt::join(shown, "', '"),
                                      names.size() > kMostNamed ? ", …" : "");
  const FilePlace at = places.empty() ? FilePlace{} : places.front();
  throw InputErrors({InputError(
      file.string(), at.line, at.column,
      wanted.empty()
          ? fmt::format("there are {} rooms in this file, expected {}", names.size(), all)
          : fmt::format("there is no room '{}' in this file, expected {}", printable(wanted), all))});
}

}  // namespace carom
