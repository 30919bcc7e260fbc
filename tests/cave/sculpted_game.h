#pragma once
// What the sculpture shows of a game that stands in no file.

#include <algorithm>

#include "cave/frame/bodies.h"
#include "cave/scene/scene.h"

namespace carom::test {

/// Returns the pucks of a game, all of one colour, and the height of the highest.
inline SculptedGame sculptedOf(const BilliardSetup& setup, const glm::vec3& colour) {
  SculptedGame game;
  for (std::size_t i = 0; i < setup.pucks.size(); ++i) {
    game.bodies.push_back({kFirstPuck + i, setup.pucks[i], colour});
    game.top_m = std::max(game.top_m, setup.pucks[i].height_m);
  }
  return game;
}

}  // namespace carom::test
