#pragma once
// The frame loop: from the tracker to the photons.

#include <memory>
#include <utility>
#include <vector>

#include "app/input/desk.h"
#include "app/input/keys.h"
#include "app/session/frame_source.h"
#include "app/session/stage.h"
#include "cave/audio/sounds.h"
#include "cave/cluster/cluster.h"
#include "cave/display/display_walls.h"

namespace carom {

/// What every rank has.
struct Node {
  Cluster& cluster;
  Graphics& graphics;
  DisplayWalls& walls;
  World& world;  ///< empty where there is no game
  Recording& recording;
  NodeLock& lock;
  double display_hz;
  bool realTime;
  SpectatorView* outside = nullptr;  ///< where the room is shown from outside, too
  DiagramWindow* diagram = nullptr;  ///< where the spacetime diagram is shown
  Console* console = nullptr;        ///< the operator's, on rank 0
};

/// What rank 0 alone has.
struct Lead {
  Lead(FrameSource& sourceIn, KeysOf keysIn, const Controls& controlsIn,
       std::unique_ptr<Sounds> soundsIn = {})
      : source(sourceIn),
        keys(keysIn),
        controls(controlsIn),
        sounds(std::move(soundsIn)),
        desk(keysIn),
        keyMap(carom::keyMap(keysIn)) {}

  FrameSource& source;
  KeysOf keys;
  Controls controls;
  std::unique_ptr<Sounds> sounds;  ///< where the game is heard
  Desk desk;                       ///< what is held stays held from one game to the next
  std::vector<KeyLine> keyMap;
  bool showsKeys = false;  ///< over the windows of rank 0's walls
  Controls before;         ///< before the operator's last wishes: kept, as copying into it allocates nothing
};

/// What makes the game heard, for who watches it in real time; none for others, or where they want silence.
std::unique_ptr<Sounds> soundsOf(const Stage& stage, bool silent);

Node nodeOf(Cluster& cluster, Stage& stage);

/// As rig and scenario begin.
Controls controlsAtStart(const Stage& stage);

/// Frame after frame until the last, until somebody wants to end, or until the controls ask for another game.
/// `lead` is rank 0's, null elsewhere.
void runFrames(const Node& node, Lead* lead);

}  // namespace carom
