#pragma once
// A rig file: the walls of a room, who draws them, and how the person in it is tracked. The room keeps the
// axes of its file; every length here is in metres.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "app/files/input_file.h"
#include "cave/room/room_geometry.h"
#include "cave/room/wall.h"
#include "devices/setup/tracker_setup.h"
#include "engine/base/pose.h"

namespace carom {

std::string_view toString(StereoMode mode);
std::string_view toString(Flip flip);

/// A sensor of a tracker.
struct SensorChoice {
  std::size_t tracker = 0;  ///< index into Rig::trackers
  int sensor = 0;
};

struct HandSetup : SensorChoice {
  /// Takes the sensor's coordinates to those of the hand (origin where its ray begins; it points along the
  /// rig's forward).
  Pose handFromSensor;
  /// Whose buttons and axes are the hand's, an index into Rig::trackers; none: those of its own tracker.
  std::optional<std::size_t> buttons{};
};

struct HeadSetup {
  SensorChoice sensor;
  double eyeSeparation_m = 0.064;
  /// Takes the sensor's coordinates to those of the eyes (origin midway between them, the person's
  /// right, up and forward along the rig's axes).
  Pose eyesFromSensor;
};

/// Where a rank of a cluster draws.
struct NodeSetup {
  int rank = 0;
  std::string display;  ///< X display, such as ":0.0"
};

struct Rig {
  std::string title;
  RoomAxes axes;
  double display_hz = 60.0;
  double displayLatency_s = 0.0;  ///< from the swap to the photons, of the slowest wall
  FrameLock frameLock = FrameLock::software;
  HeadSetup head;
  std::optional<HandSetup> hand;
  std::vector<TrackerSetup> trackers;
  std::vector<NodeSetup> nodes;  ///< empty: every rank uses the display it finds
  std::vector<Wall> walls;       ///< at least one; rectangles to 2 mm
  /// Where given, the only window of each node; a wall's `window` is then a place inside it.
  std::optional<WindowPlacement> oneWindow;
  std::optional<WindowPlacement> console;  ///< where the operator's console is, if it is asked for
};

/// What the walls' aids and the view from outside know of a rig's room.
RoomGeometry roomGeometryOf(const Rig& rig);

/// The X display of a rank; empty: the one it finds.
std::string displayOf(const Rig& rig, int rank);

/// Where the parts of a wall stand in its file; where one is left out, the place of its wall.
struct WallPlaces {
  FilePlace wall;
  FilePlace name;
  FilePlace corner;  ///< the one that is to blame where the wall is askew
  FilePlace pixels;
  FilePlace node;
  FilePlace window;
  FilePlace blend;
};

/// A rig and where its parts stand in the file.
struct PlacedRig {
  Rig rig;
  std::vector<WallPlaces> walls;
  std::vector<FilePlace> nodes;
  FilePlace head;
  FilePlace eyeSeparation;
  double unit_m = 1.0;  ///< of the file's lengths
};

/// Reads and checks the whole file. Throws InputErrors (app/files/input_file.h), which names every fault's
/// place. Traces are looked for beside the file, then in the configuration folder.
Rig readRig(const std::filesystem::path& file);
PlacedRig readPlacedRig(const std::filesystem::path& file);
/// The same of what the file held when a session was recorded.
Rig readRig(const std::filesystem::path& file, const std::string& kept);

}  // namespace carom
