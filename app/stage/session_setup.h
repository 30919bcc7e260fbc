#pragma once
// Everything that a node needs to show a live or recorded game: rig, scenario, graphics, scene and walls.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/file_keys/session_languages.h"
#include "app/rig/rig.h"
#include "app/scenario/scenario.h"
#include "app/stage/desk_windows.h"
#include "app/stage/handover.h"
#include "app/stage/recording.h"
#include "app/stage/sky_rig.h"
#include "cave/cluster/cluster.h"
#include "cave/display/display_walls.h"
#include "cave/headset/headset_pacer.h"
#include "cave/mesh/tessellation.h"
#include "cave/scene/scene.h"
#include "cave/spectator/spectator_view.h"

namespace carom {

struct SetupOptions {
  InputFile rig, scenario;
  bool live = false;  ///< the rig's trackers will be used, so their traces are read before a window opens
  RecordingOptions recording;
  bool noWindow = false;
  bool simulated = false;  ///< simulated time, unless a device tracks the head
  /// What rank 0 shows besides the walls; without windows, the view from outside is drawn all the same.
  ExtraWindows extra;
  /// The viewer for whom alone walls are drawn, "" for the first; without a value, everybody's are.
  std::optional<std::string> onlyFor{};
  std::vector<int> withoutNodes{};  ///< of the rig, which are left out with their walls
  glm::ivec2 eye_px{
      0};  ///< of a headset that is not there, in a replay: of its recorded pictures; 0: unknown
  std::optional<SkyPicture> sky{};  ///< drawn in the place of the rig's walls
  bool hideRight = false;           ///< lessons do not tell the right answer
  bool mayLeave = true;             ///< the walls have buttons for other games; in a study they do not
  double textSize = 1.0;            ///< of the walls' words, a factor
  bool people = false;              ///< of another room are shown; rank 0 decides
  bool byMouse = false;          ///< mouse and keys move heads and wands in the place of the rig's trackers
  SessionLanguages languages{};  ///< rank 0 decides
};

struct SessionSetup {
  Rig rig;
  Scenario scenario;
  bool hideRight = false, mayLeave = true;  ///< as in the options, for later games, too
  bool people = false;                      ///< likewise
  std::vector<std::string> languages;       ///< by their numbers in the records
  std::unique_ptr<Graphics> graphics;
  DeskWindows desk;  ///< rank 0 only: where the windows besides the walls' open
  /// The names under which the places of the walls' windows are remembered; empty in simulated time.
  std::vector<std::string> wallMemory;
  Tessellation tessellation;
  Scene scene;
  std::unique_ptr<DisplayWalls> walls;
  std::unique_ptr<SpectatorView> outside;  ///< null unless requested
  std::unique_ptr<Headset> headset;        ///< null unless the rig is one, and is worn
  World world;
  std::unique_ptr<Recording> recording;
  NodeLock lock;           ///< of this node's buffer swaps
  bool realTime = true;    ///< false in simulated time
  bool swapsWait = false;  ///< rank 0 only: buffer swaps wait for the display's refresh (cave/frame/pacer.h)
};

/// Reads the files on rank 0, hands them to the other nodes, and opens this node's windows. Throws RankFailed
/// on every rank if one of them cannot; that one has logged the reason.
SessionSetup setUpSession(Cluster& cluster, const SetupOptions& options);

/// Replaces the scenario on every node, in the same windows; everything of the old game in `setup` is
/// discarded. If the scenario cannot be read, logs this, leaves the setup as it is and returns false.
bool playNext(Cluster& cluster, SessionSetup& setup, const InputFile& scenario);

/// Returns the histories of all bodies before the game.
std::vector<WorldLine> historiesAtStart(const SessionSetup& setup);

}  // namespace carom
