#pragma once
// What every node needs to show a game, live or recorded: the rig and the scenario, a display, the scene and
// its walls.

#include <filesystem>
#include <memory>
#include <vector>

#include "app/files/rig.h"
#include "app/files/scenario.h"
#include "app/stage/agreement.h"
#include "app/stage/recording.h"
#include "cave/cluster/cluster.h"
#include "cave/display/display_walls.h"
#include "cave/mesh/tessellation.h"
#include "cave/scene/scene.h"
#include "cave/spectator/spectator_view.h"

namespace carom {

struct SetupOptions {
  InputFile rig, scenario;
  bool live = false;  ///< the rig's trackers will be used: their traces are read before a window opens
  RecordingOptions recording;
  bool noWindow = false;
  bool simulated = false;  ///< in simulated time, unless a device tracks the head
  bool outside = false;    ///< rank 0 shows the room from outside, too
};

struct SessionSetup {
  Rig rig;
  Scenario scenario;
  std::unique_ptr<Graphics> graphics;
  Tessellation tessellation;
  Scene scene;
  std::unique_ptr<DisplayWalls> walls;
  std::unique_ptr<SpectatorView> outside;  ///< where it was asked for
  World world;
  std::unique_ptr<Recording> recording;
  NodeLock lock;           ///< of this node's swaps
  bool realTime = true;    ///< not in simulated time
  bool swapsWait = false;  ///< on rank 0: swaps return at the display's ticks (cave/frame/pacer.h)
};

/// Reads the files, makes sure that every node holds the same, opens this node's windows. Throws RankFailed
/// on every rank when one of them cannot; that one has said why.
SessionSetup setUpSession(Cluster& cluster, const SetupOptions& options);

/// Has every node go on with another scenario, in the same windows; what the setup held of the old game is
/// gone. Where a node cannot read it, or has another, that is said, the setup stays as it is, and false is
/// returned.
bool playNext(Cluster& cluster, SessionSetup& setup, const std::filesystem::path& scenario);

/// The bodies' histories before the game.
std::vector<WorldLine> historiesAtStart(const SessionSetup& setup);

}  // namespace carom
