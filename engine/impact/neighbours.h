#pragma once
// Which pucks a puck can meet: those in the cells around its own whose straight flights, in single precision,
// do not exclude it (cell_grid.h, disc_cull.h). Games of few pucks compare all with all, in one cell. c = 1.

#include <vector>

#include "engine/game/game_state.h"
#include "engine/impact/cell_grid.h"

namespace carom {

/// Returns the direction in which a flight goes along an axis.
inline int wayAlong(const Disc& disc, int axis) { return (axis == 0 ? disc.u.x : disc.u.y) > 0.0 ? 1 : -1; }

class Neighbours {
 public:
  Neighbours(const BilliardSetup& setup, const GameState& game);

  /// Whether there are more cells than one.
  bool hasCells() const { return hasCells_; }
  const CellGrid& cells() const { return cells_; }
  /// Returns whether pucks have become so fast that they can meet across more than the cells around them.
  bool areTooSmall(const GameState& game) const {
    return game.rules.convention == TurnConvention::signalAtCentre && game.fastest > gammaBound_;
  }
  /// Lays out cells that are large enough, and puts every puck into its own.
  void layOut(GameState& game, double clock);
  /// Takes over the flights of the pucks that have begun legs (`GameState::begun`).
  void update(GameState& game, double clock);
  /// Puts a puck into the cell where its leg has it now, and writes the pucks that it may meet to places
  /// `begin` and on. Returns their end.
  int find(GameState& game, int i, int begin, double clock);
  /// Puts a puck into the cell beside its own along an axis, and does the same for the cells that come into
  /// reach with this, from place 0 on.
  int cross(GameState& game, int i, int axis, int way);
  /// Returns the puck at one of these places.
  int operator[](int place) const { return found_[place]; }

 private:
  CoarseFlight flightOf(const GameState& game, int i) const { return coarseFlight(game.discs[i], epoch_); }
  int enter(GameState& game, int i, double clock);
  void findCellExit(GameState& game, int i, const Leg& leg) const;
  int sortOut(const GameState& game, int i, int begin);

  struct Box {
    double lowX = 0.0, lowY = 0.0, width = 0.0, height = 0.0;
  };
  Box box_;  // around the centres at the start, or the board
  bool hasCells_;
  CellGrid cells_;
  double epoch_ = 0.0;       // the board time of the flights in the cells
  double gammaBound_ = 1.0;  // the greatest γ for which the cells are large enough
  double reach_ = 0.0;       // the distance within which two pucks must be compared
  FoundFlights flights_;     // of the cells that are looked through
  std::vector<int> found_;
};

}  // namespace carom
