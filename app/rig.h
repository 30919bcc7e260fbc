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

#include "app/input_file.h"
#include "cave/frame_lock.h"
#include "cave/wall.h"
#include "engine/pose.h"

namespace carom {

/// Unit vectors of the person's directions in the axes of the rig.
struct RoomAxes {
  glm::dvec3 right{1.0, 0.0, 0.0};
  glm::dvec3 up{0.0, 1.0, 0.0};
  glm::dvec3 forward{0.0, 0.0, -1.0};
};

enum class TrackerKind {
  simulated,  ///< made up by the program
  recorded,   ///< played from a trace
  vrpn,
  dtrack,
  natnet,
  polhemusUsb,
  hidImu,
  spaceMouse,  ///< buttons and axes, no poses
};

/// As a rig file names it.
std::string_view toString(TrackerKind kind);
std::string_view toString(StereoMode mode);
std::string_view toString(Flip flip);

/// Where eyes are above the floor, until a tracker has said otherwise.
inline constexpr double kStandingEyes_m = 1.7;

struct TrackerSetup {
  std::string name;
  TrackerKind kind = TrackerKind::simulated;
  double latency_s = 0.0;        ///< known age of its samples where they do not say it themselves
  bool still = false;            ///< of a simulated one: the person does not move
  std::filesystem::path source;  ///< of a recorded one: the trace; exists. Of a device: its address
  Pose roomFromTracker;
  bool buttonsAlone = false;  ///< the hand's buttons are all that the rig takes of it
};

/// A sensor of a tracker.
struct SensorChoice {
  std::size_t tracker = 0;  ///< index into Rig::trackers
  int sensor = 0;
};

struct HandSetup : SensorChoice {
  /// Takes the sensor's coordinates to those of the hand (origin where its ray begins; it points along the rig's
  /// forward).
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

/// Reads and checks the whole file. Throws InputErrors (app/input_file.h), which names every fault's place.
/// Traces are looked for beside the file, then in the configuration folder.
Rig readRig(const std::filesystem::path& file);
PlacedRig readPlacedRig(const std::filesystem::path& file);
/// The same of what the file held when a session was recorded.
Rig readRig(const std::filesystem::path& file, const std::string& kept);

}  // namespace carom
