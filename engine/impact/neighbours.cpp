#include "engine/impact/neighbours.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carom {

namespace {

constexpr int kPucksWithoutCells = 32;
constexpr double kCellsPerEpoch = 64.0;  // which light crosses before the epoch of the flights moves on

}  // namespace

Neighbours::Neighbours(const BilliardSetup& setup, const GameState& game)
    : hasCells_(game.count() > kPucksWithoutCells), gammaBound_(1.25 * game.fastest) {
  if (setup.board) {
    box_ = {-0.5 * setup.board->length_m, -0.5 * setup.board->width_m, setup.board->length_m,
            setup.board->width_m};
  } else if (!game.discs.empty()) {
    double lowX = kNever, lowY = kNever, highX = -kNever, highY = -kNever;
    for (const Disc& disc : game.discs) {
      lowX = std::min(lowX, disc.start.x);
      highX = std::max(highX, disc.start.x);
      lowY = std::min(lowY, disc.start.y);
      highY = std::max(highY, disc.start.y);
    }
    box_ = {lowX, lowY, highX - lowX, highY - lowY};
  }
}

// A pair must be neighbours from before either's own moment of the contact on. In the rest frame of either
// puck the other's centre is then at most reach away, and the board shows that distance contracted:
// * simultaneous with the contact, reach = R1 + R2 whatever the speeds;
// * by the puck's own simultaneity, R2 + R1 γ (1 + β β_2) < (2γ + 1) R.
void Neighbours::layOut(GameState& game, double clock) {
  const int count = game.count();
  for (int i = 0; i < count; ++i) {
    const double gamma = game.lastLeg(i).u.t;
    if (gamma > gammaBound_) gammaBound_ = 2.0 * gamma;
  }
  const bool simultaneous = game.rules.convention == TurnConvention::simultaneousWithContact;
  reach_ = (simultaneous ? 2.0 : 2.0 * gammaBound_ + 1.0) * game.rules.largestRadius;
  const double onePuckEach = std::sqrt(box_.width * box_.height / std::max(1, count));
  const double edge = 1.01 * std::max(reach_, onePuckEach);
  const auto fit = [&](double length) {
    return !hasCells_ ? 1 : std::max(1, static_cast<int>(std::min(length / edge, 4096.0)));
  };
  cells_ = CellGrid(box_.lowX, box_.lowY, edge, fit(box_.width), fit(box_.height), count);
  found_.resize(2 * static_cast<std::size_t>(count) + CellGrid::kSpare);
  flights_ = FoundFlights(static_cast<std::size_t>(count));
  epoch_ = clock;
  game.fastest = 1.0;
  game.begun.clear();
  for (int i = 0; i < count; ++i) enter(game, i, clock);
}

// The flights in the cells lose digits with the time between their epoch and the present.
void Neighbours::update(GameState& game, double clock) {
  if (hasCells_ && clock - epoch_ >= kCellsPerEpoch * cells_.cellEdge()) {
    epoch_ = clock;
    for (int i = 0; i < game.count(); ++i) cells_.change(i, flightOf(game, i));
  } else if (hasCells_) {
    for (const int i : game.begun) cells_.change(i, flightOf(game, i));
  }
  game.begun.clear();
}

int Neighbours::find(GameState& game, int i, int begin, double clock) {
  // A puck that was waited for is behind the others: those it can meet may be farther off by now.
  const double behind =
      std::max(0.0, clock - std::max(game.predictions[i].next.ownTime, game.discs[i].start.t));
  const double reachInCells = (reach_ + 2.0 * behind) / cells_.cellEdge();
  const int reach = reachInCells <= 1.0 ? 1 : static_cast<int>(std::min(std::ceil(reachInCells), 4096.0));
  cells_.findNear(enter(game, i, clock), reach, flights_);
  return sortOut(game, i, begin);
}

int Neighbours::cross(GameState& game, int i, int axis, int way) {
  const int into = cells_.beside(cells_.cellOf(i), axis, way);
  cells_.move(i, into, flightOf(game, i));
  findCellExit(game, i, game.flightOf(i));
  cells_.findAhead(into, axis, way, flights_);
  return sortOut(game, i, 0);
}

// Returns the cell.
int Neighbours::enter(GameState& game, int i, double clock) {
  const Leg leg = game.flightOf(i);
  const Vec21 x = placeAt(leg, std::max(clock, leg.start.t)).x;
  const int cell = cells_.cellAt(x.x, x.y);
  if (cell != cells_.cellOf(i)) cells_.move(i, cell, flightOf(game, i));
  findCellExit(game, i, leg);
  return cell;
}

void Neighbours::findCellExit(GameState& game, int i, const Leg& leg) const {
  const int cell = cells_.cellOf(i);
  const auto leaves = [&](int axis) {
    const int way = wayAlong(game.discs[i], axis);
    if ((axis == 0 ? leg.u.x : leg.u.y) == 0.0 || !cells_.canLeave(cell, axis, way)) return kNever;
    return reaches(leg, axis, cells_.edge(cell, axis, way));
  };
  const double alongX = leaves(0), alongY = leaves(1);
  Prediction& own = game.predictions[i];
  own.leavesAlongY = alongY < alongX;
  own.leavesCell = own.leavesAlongY ? alongY : alongX;
}

// Keeps of flights_ those that the coarse flights do not exclude, without a branch, and asks for their data.
// Returns the end of the places that they are written to.
int Neighbours::sortOut(const GameState& game, int i, int begin) {
  int* const found = found_.data();
  const int* const items = flights_.items.data();
  const bool all = !game.rules.areStraightDiscs();
  const DiscCull coarse(game.discs[i], game.rules.largestRadius, game.rules.convention, epoch_);
  int kept = begin;
  for (int first = 0; first < flights_.count; first += FoundFlights::kRoom) {
    std::array<int, FoundFlights::kRoom> may;
    const float *const x = &flights_.x[first], *const y = &flights_.y[first];
    const float *const vx = &flights_.vx[first], *const vy = &flights_.vy[first];
    const int end = std::min(FoundFlights::kRoom, flights_.count - first);
    const int fours = (end + 3) / 4 * 4;  // which an instruction computes at once
    for (int k = 0; k < fours; ++k) may[k] = coarse.mayMeet(x[k], y[k], vx[k], vy[k]) ? 1 : 0;
    for (int k = 0; k < end; ++k) {
      found[kept] = items[first + k];
      kept += static_cast<int>(items[first + k] != i) & (may[k] | static_cast<int>(all));
    }
  }
  for (int k = begin; k < kept; ++k) {
    prefetch(&game.discs[found[k]]);
    prefetch(&game.predictions[found[k]]);
  }
  return kept;
}

}  // namespace carom
