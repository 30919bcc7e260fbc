#pragma once
// A game as a body in spacetime that can be held: the tubes of its pucks, beads for its events, rods for the
// light of strokes and flashes, cushions as sheets, and a base with a frame that stand for the board.

#include <span>
#include <string>
#include <vector>

#include "engine/game/billiard_setup.h"
#include "engine/sculpture/solid.h"
#include "engine/sculpture/spacetime_frame.h"
#include "engine/sculpture/world_tube.h"

namespace carom {

enum class SculpturePartKind {
  tube,     ///< of a puck
  bead,     ///< an event of the game
  light,    ///< of a stroke or a flash, from where it enters the plane of the pucks' tops
  base,     ///< the board at the first moment
  frame,    ///< the rods of the board's corners and edges
  cushion,  ///< a sheet without thickness, for screens; printers get none
};

struct SculpturePart {
  SculpturePartKind kind = SculpturePartKind::tube;
  std::string name;      ///< of the puck, or "event 3 puck-puck"
  std::size_t puck = 0;  ///< of a tube: index into the setup's pucks
  SolidMesh solid;       ///< metres of the board, and of light for the time
};

struct GameSculpture {
  std::vector<SculpturePart> parts;
  double scale = 1.0;        ///< metres of the model for a metre of the board
  double leastWall_m = 0.0;  ///< of the model: the thinnest tube or rod
  double lightSpeed_m_s = 1.0;
  std::size_t thickened = 0;    ///< tubes that are wider than the pucks', to have the least wall
  std::size_t withoutTube = 0;  ///< pucks that are soft or were not there between the two moments
};

/// What a sculpture is made from.
struct SculptureSource {
  const BilliardSetup& setup;
  std::span<const WorldLine> lines;   ///< one for each puck
  std::span<const GameEvent> events;  ///< those outside the span are left out
};

struct SculptureOptions {
  Span span;
  Vec3 beta{0.0};            ///< velocity on the board of the frame in which it is shown, v/c; below 1
  double size_m = 0.15;      ///< of its longest side, with its base; at least a centimetre
  double leastWall_m = 0.0;  ///< thinner tubes and rods are thickened; 0: none
  bool sheets = true;        ///< with the cushions
};

/// Returns the sculpture. The boost leaves the middle of the board at the middle of the span where it is.
/// Throws std::invalid_argument where nothing is shown: no puck between the two moments.
GameSculpture sculptureOf(const SculptureSource& game, const SculptureOptions& options);

}  // namespace carom
