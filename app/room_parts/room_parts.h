#pragma once
// The steps by which all readers of this folder put walls, windows, computers and trackers into a room.

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "app/rig/rig_screen.h"
#include "app/room_checks/room.h"
#include "app/room_parts/part.h"

namespace carom {

inline constexpr double kMostRoomPixels = 16384.0;  ///< largest texture size of common GPUs
/// The size of a window, and its place on a desktop of several monitors.
inline constexpr Range kWindowSize_px{.least = 1.0, .most = kMostRoomPixels},
    kWindowPlace_px{.least = -65536.0, .most = 65536.0};

/// Returns an empty room: no walls yet, the axes of rigs with y up, lengths of a rig of it in `unit`.
Room roomOfFormat(const std::filesystem::path& file, std::string format, std::string unit, double unit_m);

/// Three corners with their names in the file and the place to report if they make no rectangle.
struct ReadCorners {
  glm::dvec3 lowerLeft_m{0.0}, lowerRight_m{0.0}, upperLeft_m{0.0};
  std::array<std::string_view, 3> names{"lower left", "lower right", "upper left"};
};

/// Returns the corners of a rectangle by its middle and its unit vectors to the right and upwards.
ReadCorners rectangleAround(const glm::dvec3& middle_m, const glm::dvec3& right, const glm::dvec3& up,
                            double width_m, double height_m);

/// Adds a wall under its name, or, with a warning, that name with a number if it is taken. Adds an error
/// instead if its corners make no rectangle or there are too many walls. A wall without pixels gets 1080
/// lines, with a warning. Returns whether the wall was added.
bool addWall(RoomWall wall, const ReadCorners& corners, Room& room);

/// Adds a wall whose screen is curved, like addWall. Its pixels are set before. Adds an error instead if the
/// screen takes too many flat pieces.
bool addCurvedWall(RoomWall wall, const ScreenFormula& shape, Room& room);

/// Gives the wall its part of a window, in pixels from the window's top left, and its pixels. A part that
/// reaches out of the window is cut, with a warning. The whole window is no part.
void placeInWindow(const WindowPlacement& window, glm::ivec2 position_px, glm::ivec2 size_px, RoomWall& wall,
                   Room& room);

/// Gives walls whose parts of one window overlap windows of their own at those places, with a warning: a rig
/// has no overlaps in a window.
void separateOverlaps(Room& room);

/// Numbers the computers and displays that draw walls, in the order in which they are first asked for, and
/// makes the room's nodes of them.
class Ranks {
 public:
  explicit Ranks(Room& room) : room_(room) {}
  /// Returns the rank of a computer's display; either may be empty.
  int of(const std::string& host, const std::string& display, FilePlace at);
  /// Returns a rank of its own for another process of a computer.
  int next(const std::string& host, FilePlace at);
  /// Makes the room's nodes: one entry for consecutive ranks of a computer without displays of their own.
  void finish();

 private:
  struct Seat {
    std::string host, display;
    FilePlace at;
  };
  int add(Seat seat);

  Room& room_;
  std::vector<Seat> seats_;
};

/// Returns a valid name for a viewer, unique among the room's people.
std::string viewerName(const Room& room, std::string_view given);

/// Adds somebody whose eyes start at `eyes_m`. Returns their index.
std::size_t addPerson(std::string_view name, double eyeSeparation_m, const glm::dvec3& eyes_m, FilePlace at,
                      std::string words, Room& room);

/// Tells, of somebody who is tracked, that the place that the file gives them is left out: a rig has none.
void leaveOutPlace(std::size_t person, FilePlace at, Room& room);

/// Adds a tracker. Returns its index, or nothing, with a warning noted, if its source is none that the kind
/// can use. A tracker of that source that is there already is not added again.
std::optional<std::size_t> addTracker(TrackerSetup tracker, FilePlace at, Room& room);
/// The same of a VRPN tracker by its address "name@host".
std::optional<std::size_t> addVrpn(std::string_view name, std::string_view address,
                                   const Pose& roomFromTracker, FilePlace at, Room& room);
/// The same of a tracker by ART that sends to this port of the first computer.
std::optional<std::size_t> addDtrack(std::string_view name, int port, const Pose& roomFromTracker,
                                     FilePlace at, Room& room);

/// The shared memory of CAVELib's daemon: the keys of its segments and the unit of its lengths.
struct TrackdMemory {
  int sensors = 4126;
  std::optional<int> wand;
  double unit_m = 0.3048;  ///< one of kMetresPerUnit (app/file_keys/rig_keys.h)
};
std::optional<std::size_t> addTrackd(std::string_view name, const TrackdMemory& memory,
                                     const Pose& roomFromTracker, FilePlace at, Room& room);
/// Returns the unit of a rig that is this long; nothing, with a warning noted, if there is none.
std::optional<double> rigUnit_m(double unit_m, FilePlace at, Room& room);

/// Returns the rotation whose matrix has these columns; none if they are no rotation (mirrored axes).
std::optional<glm::dquat> rotationOf(const glm::dmat3& matrix);

/// Returns the tracker's turn into a room with x right, y up, z back from the tracker's axes ("X", "-Z") that
/// point to the right, up and forward. Returns nothing, with a warning noted, if that is no rotation.
std::optional<glm::dquat> turnOfAxes(const std::string& right, const std::string& up,
                                     const std::string& forward, FilePlace at, Room& room);

/// Ends the reading: an error at `at` if there is no wall, its text telling what was expected; walls apart in
/// their windows; a person if there is none.
void finishRoom(std::string_view expected, Room& room, FilePlace at = {});

/// Throws InputErrors if one of several rooms is wanted of a file that has one.
void refuseRoomName(const std::string& wanted, const std::filesystem::path& file);

/// Returns the wanted of several rooms by their names. Throws InputErrors with all names if there are several
/// and none is wanted, or none has the wanted name.
std::size_t chooseRoom(const std::vector<std::string>& names, const std::vector<FilePlace>& places,
                       const std::string& wanted, const std::filesystem::path& file);

}  // namespace carom
