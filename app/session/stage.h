#pragma once
// What every node needs to show a game, live or recorded: the rig and the scenario, a display, the scene and
// its walls.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/files/rig.h"
#include "app/files/scenario.h"
#include "app/session/console.h"
#include "app/session/diagram_window.h"
#include "app/stage/recording.h"
#include "cave/cluster/cluster.h"
#include "cave/display/display_walls.h"
#include "cave/mesh/tessellation.h"
#include "cave/scene/scene.h"
#include "cave/spectator/spectator_view.h"

namespace carom {

/// A file that people wrote, as it is or, where it is given, as it was when a session was recorded.
struct InputFile {
  std::filesystem::path file;
  std::optional<std::string> kept;
};

/// What it holds; empty where it cannot be read.
std::string textOf(const InputFile& input);

struct StageOptions {
  InputFile rig, scenario;
  bool live = false;  ///< the rig's trackers will be used: their traces are read before a window opens
  RecordingOptions recording;
  bool noWindow = false;
  bool simulated = false;  ///< in simulated time, unless a device tracks the head
  bool outside = false;    ///< rank 0 shows the room from outside, too
  bool diagram = false;    ///< and the spacetime diagram, where there are windows
};

struct Stage {
  Rig rig;
  Scenario scenario;
  std::unique_ptr<Graphics> graphics;
  Tessellation tessellation;
  Scene scene;
  std::unique_ptr<DisplayWalls> walls;
  std::unique_ptr<SpectatorView> outside;  ///< where it was asked for
  std::unique_ptr<DiagramWindow> diagram;  ///< where it was asked for
  std::unique_ptr<Console> console;        ///< where it was opened
  World world;
  std::unique_ptr<Recording> recording;
  NodeLock lock;           ///< of this node's swaps
  bool realTime = true;    ///< not in simulated time
  bool swapsWait = false;  ///< on rank 0: swaps return at the display's ticks (cave/frame/pacer.h)
};

/// Gives every node rank 0's rig and scenario, which it has from a session file.
void shareInputs(const Cluster& cluster, StageOptions& options);

/// Reads the files, makes sure that every node holds the same, opens this node's windows. Throws RankFailed
/// on every rank when one of them cannot; that one has said why.
Stage openStage(Cluster& cluster, const StageOptions& options);

/// Opens the operator's console on rank 0. The stage stays where it is from now on.
void openConsole(Cluster& cluster, Stage& stage, KeysOf keys);

/// Has every node go on with another scenario, in the same windows; what the stage held of the old game is
/// gone. Where a node cannot read it, or has another, that is said, the stage stays as it is, and false is
/// returned.
bool playNext(Cluster& cluster, Stage& stage, const std::filesystem::path& scenario);

/// The bodies' histories before the game.
std::vector<WorldLine> historiesAtStart(const Stage& stage);

/// Makes sure that every node holds the same rig, the files of its projectors included. Throws NodesDiffer on
/// every rank where one does not.
void agreeOnRig(const Cluster& cluster, const InputFile& input, const Rig& rig);

/// Reads the walls' blend pictures once before there is a window; throws InputErrors, which name what is
/// wrong at its line of the rig.
void openBlends(const InputFile& input, const Rig& rig);

}  // namespace carom
