#pragma once
// The frame loop: from the tracker to the photons.

#include <filesystem>
#include <optional>
#include <vector>

#include "app/game.h"
#include "app/journal.h"
#include "app/person.h"
#include "app/stage.h"
#include "cave/cluster.h"
#include "cave/pacer.h"

namespace carom {

/// What rank 0 alone has: the tracked person and the game.
struct Play {
  std::unique_ptr<Clock> clock;
  Pacer pacer;
  Person person;
  Game game;
  double eyeSeparation_m = 0.064;
  std::optional<std::uint64_t> lastFrame;  ///< end after the one of this number
  Switches switches;                       ///< as the keys left them
  std::unique_ptr<Journal> journal;        ///< none: the session is not written
  WallControls controls = {};              ///< as the keys left them
};

/// What every rank has.
struct Node {
  Cluster& cluster;
  Stage& stage;
  std::optional<std::filesystem::path> capture;
};

/// Frame after frame until the last. `play` is rank 0's, null elsewhere.
void runFrames(const Node& node, Play* play);

}  // namespace carom
