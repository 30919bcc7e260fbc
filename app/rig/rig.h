#pragma once
// A rig file: the walls of a room, the nodes that draw them, and the trackers of the viewer. The room keeps
// the axes of its file; all lengths here are in metres.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "app/toml/input_file.h"
#include "cave/room/room_geometry.h"
#include "cave/room/wall.h"
#include "devices/setup/force_setup.h"
#include "devices/setup/tracker_setup.h"
#include "engine/base/limits.h"
#include "engine/base/pose.h"
#include "engine/sculpture/sculpture_place.h"

namespace carom {

std::string_view toString(StereoMode mode);
std::string_view toString(Flip flip);

/// One sensor of a tracker.
struct SensorChoice {
  std::size_t tracker = 0;  ///< index into Rig::trackers
  int sensor = 0;

  bool operator==(const SensorChoice&) const = default;
};

struct HandSetup : SensorChoice {
  /// Transforms the sensor's coordinates to those of the hand (origin where its ray begins; it points along
  /// the rig's forward axis).
  Pose handFromSensor;
  /// The tracker whose buttons and axes the hand uses, an index into Rig::trackers; without one, its own
  /// tracker.
  std::optional<std::size_t> buttons{};
};

struct HeadSetup {
  SensorChoice sensor;
  double eyeSeparation_m = 0.064;
  /// Transforms the sensor's coordinates to those of the eyes (origin midway between them; the viewer's
  /// right, up and forward along the rig's axes).
  Pose eyesFromSensor;
};

/// A person in the room whose head is tracked.
struct ViewerSetup {
  std::string name = "viewer";  ///< as in the names of pictures and in the session file
  HeadSetup head;
  std::optional<HandSetup> hand{};
  std::optional<ForceSetup> force{};  ///< the device that lets the hand feel
  std::string language{};             ///< as app/file_keys/session_languages.h; empty: the rig's
};

/// Where one rank of a cluster runs, or several consecutive ones.
struct NodeSetup {
  int rank = 0;         ///< the first of them
  std::string display;  ///< X display, such as ":0.0"; empty: their default display
  std::string host{};   ///< name or address; empty: mpirun is told otherwise
  int slots = 1;        ///< number of ranks
};

/// A computer that a session does without.
struct MissingNode {
  std::string name;  ///< its host, or "node 2" in a rig without hosts
  std::vector<std::string> walls;
};

/// How `carom room` starts the nodes.
struct StartSetup {
  /// A range of TCP ports, both ends included.
  struct Ports {
    int first = 0, last = 0;
  };
  std::string network;                   ///< of MPI's messages, such as "10.0.0.0/24"; empty: any
  std::optional<Ports> ports{};          ///< of MPI; without, any
  std::vector<std::string> environment;  ///< variables of the nodes, as "NAME=VALUE" or "NAME"
};

/// Another room that plays at the same table.
struct LinkSetup {
  std::string name;                 ///< of this room
  std::filesystem::path key;        ///< the file of the shared key; may be missing
  std::string with;                 ///< as app/link/link_address.h; empty: no room
  std::optional<double> apart_m{};  ///< empty: as the line needs
  double reach_m = 0.8, gone_s = 6.0;
};

/// Where phones find the pages of a class or a study.
struct ClassSetup {
  std::string address;        ///< in numbers; empty: that of the default route
  std::uint16_t port = 8080;  ///< 0: any that is free
};

/// What the room spares its visitors.
struct ComfortSetup {
  double most_u = kMostPlatformU;  ///< γβ beyond which the drive makes the platform no faster
  bool aids = false;               ///< darker edges and a resting frame while the room moves
};

struct Rig {
  std::string title;
  RoomAxes axes;
  double display_hz = 60.0;
  double displayLatency_s = 0.0;  ///< from buffer swap to light output, of the slowest wall
  FrameLock frameLock = FrameLock::software;
  std::vector<ViewerSetup> viewers{1};  ///< one to kMostViewers
  std::vector<TrackerSetup> trackers;
  std::vector<NodeSetup> nodes;  ///< if empty, every rank uses its default display
  bool byMouse = false;          ///< mouse and keys move heads and hands: there is a tracker for them alone
  StartSetup start;
  std::vector<MissingNode> missing{};  ///< not of the file: what rigWithout has left out
  std::vector<Wall> walls;             ///< at least one; rectangles to 2 mm
  /// If given, the only window of each node; a wall's `window` is then a position inside it.
  std::optional<WindowPlacement> oneWindow;
  /// Of a headset: the board that is fixed in the room and carries what else stands on the front wall. The
  /// walls then hang on the head, one before each eye.
  std::optional<Wall> board;
  /// Of a room: such a board, where no flat wall carries it.
  std::optional<Wall> panel{};
  ComfortSetup comfort;
  SpacetimeSetup spacetime;
  std::optional<LinkSetup> link{};
  ClassSetup classroom{};
  std::string language{};                ///< as app/file_keys/session_languages.h; empty: the first of these
  std::vector<std::string> languages{};  ///< through which a tile goes; empty: there is none
  std::filesystem::path playlist;        ///< of the room's visitors (app/scenario/playlist.h); empty: none
  std::optional<WindowPlacement> console;  ///< the operator's console, if it is requested
};

/// Returns whether the walls hang on the head.
inline bool isHeadset(const Rig& rig) { return rig.board.has_value(); }

/// Returns the flat walls on which pictures are drawn: a curved screen has several.
std::vector<Wall> drawnWalls(const Rig& rig);

/// Returns those of them that stand in the room.
std::vector<Wall> standingWalls(const Rig& rig);

/// Returns the rig's room for the overlays on the walls and the spectator view; in that of a headset stands
/// the board.
RoomGeometry roomGeometryOf(const Rig& rig);

/// Returns the number of nodes that a rig needs: for all of its walls and all of its [[node]] entries.
int nodesOf(const Rig& rig);

/// Returns the X display of a rank; empty for its default display.
std::string displayOf(const Rig& rig, int rank);

/// Positions in the file of the parts of a wall; a part that is not given has the position of its wall.
struct WallPlaces {
  FilePlace wall;
  FilePlace name;
  FilePlace corner;  ///< the corner to report if the wall is not a rectangle
  FilePlace pixels;
  FilePlace node;
  FilePlace window;
  FilePlace blend;
};

/// A rig and the positions of its parts in the file.
struct PlacedRig {
  Rig rig;
  std::vector<WallPlaces> walls;
  std::vector<FilePlace> nodes;
  FilePlace head;
  FilePlace eyeSeparation;
  double unit_m = 1.0;  ///< of the lengths in the file
};

/// Reads and checks the whole file. Throws InputErrors (app/toml/input_file.h) with the position of every
/// fault. Trace files are searched beside the file, then in the configuration folder.
Rig readRig(const std::filesystem::path& file);
PlacedRig readPlacedRig(const std::filesystem::path& file);
/// Reads `kept`, the content that the file had when a session was recorded or handed over. The files that it
/// names are looked for below `root` first, if one is given.
Rig readRig(const std::filesystem::path& file, const std::string& kept,
            const std::filesystem::path& root = {});

}  // namespace carom
