#pragma once
// A grid of square cells over the board. Each cell holds the numbers and coarse flights of the pucks whose
// centres lie in it, so that neighbours are found without looking at every puck. The outermost cells reach to
// infinity; around them lies a margin of cells that stay empty, so that every cell has eight around it.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <vector>

#include "engine/base/large_pages.h"
#include "engine/base/prefetch.h"
#include "engine/collision/disc_cull.h"

namespace carom {

/// Items and their flights as they are found, column by column. The columns have room for some more than are
/// found, so that they are written and read several at a time.
struct FoundFlights {
  std::vector<float> x, y, vx, vy;
  std::vector<int> items;
  int count = 0;

  static constexpr int kRoom = 16;
  explicit FoundFlights(std::size_t most = 0)
      : x(most + kRoom), y(most + kRoom), vx(most + kRoom), vy(most + kRoom), items(most + kRoom) {}
};

class CellGrid {
 public:
  CellGrid() = default;
  /// Makes `columns` × `rows` cells of edge length `cell`, which begin at (lowX, lowY), for `items` items
  /// that are in no cell yet.
  CellGrid(double lowX, double lowY, double cell, int columns, int rows, int items)
      : lowX_(lowX),
        lowY_(lowY),
        cell_(cell),
        perCell_(1.0 / cell),
        columns_(columns),
        rows_(rows),
        rowShift_(std::countr_zero(std::bit_ceil(static_cast<unsigned>(columns) + 1))),
        blocks_(static_cast<std::size_t>(rows + 2) << rowShift_),
        cellOf_(items, kNone) {}

  double cellEdge() const { return cell_; }
  int cellOf(int item) const { return cellOf_[item]; }
  int cellAt(double x, double y) const {
    const auto indexIn = [](double index, int count) {
      return static_cast<int>(std::clamp(index, 0.0, static_cast<double>(count - 1)));
    };
    return cellIn(indexIn(std::floor((x - lowX_) * perCell_), columns_),
                  indexIn(std::floor((y - lowY_) * perCell_), rows_));
  }

  void move(int item, int cell, const CoarseFlight& flight) {
    if (cellOf_[item] != kNone) takeOut(item, cellOf_[item]);
    cellOf_[item] = cell;
    int block = cell;
    while (blocks_[block].items.back() != kNone) block = blockAfter(block);
    blocks_[block].put(blocks_[block].count(), item, flight);
  }
  /// Changes the flight of an item that is in a cell.
  void change(int item, const CoarseFlight& flight) {
    const auto [block, place] = find(item, cellOf_[item]);
    blocks_[block].put(place, item, flight);
  }

  /// Whether a step along an axis leads out of `cell` into another.
  bool canLeave(int cell, int axis, int step) const {
    const int index = indexOf(cell, axis) + step;
    return index >= 0 && index < (axis == 0 ? columns_ : rows_);
  }
  /// Returns the cell one step along an axis beside `cell`; requires `canLeave`.
  int beside(int cell, int axis, int step) const { return cell + step * stepAlong(axis); }
  /// Returns the coordinate of the edge between `cell` and the one beside it.
  double edge(int cell, int axis, int step) const {
    return (axis == 0 ? lowX_ : lowY_) + (indexOf(cell, axis) + (step > 0 ? 1 : 0)) * cell_;
  }
  /// Whether `cell` is one of the outermost cells.
  bool isAtRim(int cell) const {
    const int column = indexOf(cell, 0), row = indexOf(cell, 1);
    return column == 0 || row == 0 || column == columns_ - 1 || row == rows_ - 1;
  }

  /// Writes the items of the cells within `reach` cells of `cell` to `found`, which has room for all items of
  /// the grid and kSpare more; returns how many.
  int findNear(int cell, int reach, int* found) const {
    const int column = indexOf(cell, 0), row = indexOf(cell, 1);
    return findIn(column - reach, column + reach, row - reach, row + reach, found);
  }
  /// Does the same with the items' flights, for which `found` has room.
  void findNear(int cell, int reach, FoundFlights& found) const {
    if (reach == 1) return findAround(cell, found);
    const int column = indexOf(cell, 0), row = indexOf(cell, 1);
    findIn(column - reach, column + reach, row - reach, row + reach, found);
  }
  /// Does the same for the three cells that come into reach after a step along an axis into `cell`.
  void findAhead(int cell, int axis, int step, FoundFlights& found) const {
    const int across = stepAlong(1 - axis), middle = beside(cell, axis, step);
    int end = 0;
    for (int k = -1; k <= 1; ++k) end = findInCell(middle + k * across, found, end);
    found.count = end;
  }
  static constexpr int kSpare = 3;
  // Prefetch from memory: in which cell an item is; `cell` with those around it; `cell` and what `findAhead`
  // reads.
  void fetchCellOf(int item) const { prefetch(&cellOf_[item]); }
  void fetch(int cell) const { prefetch(&blocks_[cell]); }
  void fetchNear(int cell) const {
    for (int row = -1; row <= 1; ++row) {
      for (int column = -1; column <= 1; ++column) fetch(cell + row * stepAlong(1) + column);
    }
  }
  void fetchAhead(int cell, int axis, int step) const {
    fetch(cell);
    for (int k = -1; k <= 1; ++k) fetch(beside(cell, axis, step) + k * stepAlong(1 - axis));
  }

 private:
  static constexpr int kNone = -1;
  // The first items of a cell: a cache line. Further items are in further blocks, which follow those of the
  // cells.
  struct alignas(64) Block {
    std::array<int, kSpare> items{kNone, kNone, kNone};  // filled from the front, all but the last block full
    std::array<float, kSpare> x{}, y{}, vx{}, vy{};
    int more = kNone;

    void put(int place, int item, const CoarseFlight& flight) {
      items[place] = item;
      x[place] = flight.x;
      y[place] = flight.y;
      vx[place] = flight.vx;
      vy[place] = flight.vy;
    }
    void take(int place, const Block& from, int there) {
      put(place, from.items[there], {from.x[there], from.y[there], from.vx[there], from.vy[there]});
    }
    int count() const {
      return (items[0] != kNone ? 1 : 0) + (items[1] != kNone ? 1 : 0) + (items[2] != kNone ? 1 : 0);
    }
  };
  static_assert(sizeof(Block) == 64);
  struct Found {
    int block, place;
  };

  // The margin is the first row, the last, and what follows the columns of every row, which is the one before
  // those of the next row, too.
  int cellIn(int column, int row) const { return ((row + 1) << rowShift_) + column; }
  int indexOf(int cell, int axis) const {
    return axis == 0 ? cell & ((1 << rowShift_) - 1) : (cell >> rowShift_) - 1;
  }
  int stepAlong(int axis) const { return axis == 0 ? 1 : 1 << rowShift_; }
  template <class Visit>
  void visitBlocks(int columnLow, int columnHigh, int rowLow, int rowHigh, Visit visit) const {
    columnLow = std::max(0, columnLow);
    columnHigh = std::min(columns_ - 1, columnHigh);
    rowLow = std::max(0, rowLow);
    rowHigh = std::min(rows_ - 1, rowHigh);
    for (int row = rowLow; row <= rowHigh; ++row) {
      for (int column = columnLow; column <= columnHigh; ++column) {
        for (int block = cellIn(column, row); block != kNone; block = blocks_[block].more)
          visit(blocks_[block]);
      }
    }
  }
  int findIn(int columnLow, int columnHigh, int rowLow, int rowHigh, int* found) const {
    int* end = found;
    visitBlocks(columnLow, columnHigh, rowLow, rowHigh, [&](const Block& block) {
      std::copy(block.items.begin(), block.items.end(), end);  // always all: no branch to mispredict
      end += block.count();
    });
    return static_cast<int>(end - found);
  }
  void findIn(int columnLow, int columnHigh, int rowLow, int rowHigh, FoundFlights& found) const {
    int end = 0;
    visitBlocks(columnLow, columnHigh, rowLow, rowHigh,
                [&](const Block& block) { end = findInBlock(block, found, end); });
    found.count = end;
  }
  void findAround(int cell, FoundFlights& found) const {
    int end = 0;
    for (int row = -1; row <= 1; ++row) {
      for (int column = -1; column <= 1; ++column)
        end = findInCell(cell + row * stepAlong(1) + column, found, end);
    }
    found.count = end;
  }
  // These write from place `end` on and return the new end.
  int findInCell(int cell, FoundFlights& found, int end) const {
    for (int block = cell; block != kNone; block = blocks_[block].more)
      end = findInBlock(blocks_[block], found, end);
    return end;
  }
  // Copies four at a time, as one instruction does; only those that are items count. What follows a column of
  // numbers in a block is no subnormal number, with which calculation takes a hundred times as long.
  static int findInBlock(const Block& block, FoundFlights& found, int end) {
    const char* const from = reinterpret_cast<const char*>(&block);
    constexpr std::size_t kColumn = kSpare * sizeof(float), kFour = 4 * sizeof(float);
    std::memcpy(&found.items[end], from, kFour);
    std::memcpy(&found.x[end], from + kColumn, kFour);
    std::memcpy(&found.y[end], from + 2 * kColumn, kFour);
    std::memcpy(&found.vx[end], from + 3 * kColumn, kFour);
    std::memcpy(&found.vy[end], from + 4 * kColumn, kFour);
    return end + block.count();
  }
  Found find(int item, int cell) const {
    for (int block = cell;; block = blocks_[block].more) {
      for (int place = 0; place < kSpare; ++place) {
        if (blocks_[block].items[place] == item) return {block, place};
      }
    }
  }
  int blockAfter(int block) {
    if (blocks_[block].more != kNone) return blocks_[block].more;
    int fresh = free_;
    if (fresh != kNone) {
      free_ = blocks_[fresh].more;
      blocks_[fresh].more = kNone;
    } else {
      fresh = static_cast<int>(blocks_.size());
      blocks_.emplace_back();
    }
    return blocks_[block].more = fresh;
  }
  // Removes `item` from `cell`; the last item of the cell takes its place.
  void takeOut(int item, int cell) {
    const auto [block, place] = find(item, cell);
    int last = block, beforeLast = cell;
    if (block != cell) {
      while (blocks_[beforeLast].more != block) beforeLast = blocks_[beforeLast].more;
    }
    for (; blocks_[last].more != kNone; last = blocks_[last].more) beforeLast = last;
    const int lastPlace = blocks_[last].count() - 1;
    blocks_[block].take(place, blocks_[last], lastPlace);
    blocks_[last].items[lastPlace] = kNone;
    if (last != cell && lastPlace == 0) {
      blocks_[beforeLast].more = kNone;
      blocks_[last].more = free_;
      free_ = last;
    }
  }

  double lowX_ = 0.0, lowY_ = 0.0, cell_ = 1.0, perCell_ = 1.0;
  int columns_ = 1, rows_ = 1;
  int rowShift_ = 0;          // a row of cells has room for 2^rowShift_
  LargeArray<Block> blocks_;  // by cell, then those for more items
  LargeArray<int> cellOf_;    // by item
  int free_ = kNone;          // the first of the blocks for more items that hold none
};

}  // namespace carom
