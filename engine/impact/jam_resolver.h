#pragma once
// What happens to pucks that press on one another (`Billiard` in billiard.h): gathers those that touch,
// has their jam solved (jam_solver.h), and decides their turns. c = 1. Theory: app/doc/physics.md, Jams.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "engine/game/game_state.h"
#include "engine/impact/cell_grid.h"
#include "engine/impact/jam_solver.h"
#include "engine/impact/shape_contacts.h"

namespace carom {

/// The jam that is being settled. Its memory is used again.
struct Jam {
  explicit Jam(std::size_t pucks = 0) : near(pucks + CellGrid::kSpare), isIn(pucks, 0) {}

  std::vector<JamBody> bodies;
  std::vector<JamContact> contacts;
  std::vector<int> near;   // scratch: neighbours
  std::vector<char> isIn;  // scratch: by puck
};

class JamResolver {
 public:
  /// `cells` tells which pucks are near each other.
  JamResolver(GameState& game, GameHistory& history, const CellGrid& cells, Jam& jam)
      : game_(game), history_(history), cells_(cells), jam_(jam) {}

  /// The kick of two pressed discs: together with all pressed pucks that touch them, in a chain, they come to
  /// where none closes on another.
  void settle(const PuckPair& who, const PairContact& contact, const std::array<LegState, 2>& turn);
  /// Bodies with corners that lie on each other or on a cushion would be kicked at one place after the other,
  /// each kick sending others together. All such kicks are taken at once. Returns whether there are any.
  bool settleEverywhere(std::span<const int> who, std::span<const LegState> turn, const Vec21& touch,
                        const Vec21& U);

 private:
  double slowIn(std::span<const int> who, double hardest) const;
  JamBody bodyOf(int i, const LegState& turn) const;
  std::optional<LegState> joinsAt(int i, const Vec21& touched, const Vec21& U, double earliest) const;
  std::optional<JamContact> contactOf(const JamBody& one, const JamBody& other) const;
  void gather(const Vec21& U, double earliest);
  void gatherContacts();
  JamSolver solver();
  bool commit(const Vec21& touch);

  GameState& game_;
  GameHistory& history_;
  const CellGrid& cells_;
  Jam& jam_;
};

}  // namespace carom
