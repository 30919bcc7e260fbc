#pragma once
// The frame loop: from the tracker to the photons.

#include <filesystem>
#include <optional>
#include <vector>

#include "app/game.h"
#include "app/head_tracking.h"
#include "cave/cluster.h"
#include "cave/pacer.h"
#include "cave/wall_set.h"
#include "engine/observer.h"

namespace carom {

/// What rank 0 alone has: the tracked person and the game.
struct Play {
  Pacer pacer;
  HeadTracking head;
  Observer observer;
  Game game;
  double eyeSeparation_m = 0.064;
  std::optional<std::uint64_t> frames;  ///< end after so many
};

/// What every rank has.
struct Node {
  Cluster& cluster;
  Graphics& graphics;
  WallSet& walls;
  std::vector<WorldLine> histories;  ///< of every body of the scene
  std::optional<std::filesystem::path> capture;
};

/// Frame after frame until the last. `play` is rank 0's, null elsewhere.
void runFrames(Node& node, Play* play);

}  // namespace carom
