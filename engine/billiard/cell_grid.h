#pragma once
// A grid of square cells over the board. Each cell holds the numbers of the pucks whose centres lie in it, so
// that neighbours are found without looking at every puck. The outermost cells reach to infinity.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <vector>

namespace carom {

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
        rowShift_(std::countr_zero(std::bit_ceil(static_cast<unsigned>(columns)))),
        blocks_(static_cast<std::size_t>(rows) << rowShift_),
        cellOf_(items, kNone) {}

  double cellEdge() const { return cell_; }
  int cellOf(int item) const { return cellOf_[item]; }
  int cellAt(double x, double y) const {
    return cellIn(indexIn(std::floor((x - lowX_) * perCell_), columns_),
                  indexIn(std::floor((y - lowY_) * perCell_), rows_));
  }

  void move(int item, int cell) {
    if (cellOf_[item] != kNone) takeOut(item, cellOf_[item]);
    cellOf_[item] = cell;
    int block = cell;
    while (blocks_[block].items.back() != kNone) block = blockAfter(block);
    *std::find(blocks_[block].items.begin(), blocks_[block].items.end(), kNone) = item;
  }

  /// Whether a step along an axis leads out of `cell` into another.
  bool canLeave(int cell, int axis, int step) const {
    const int index = indexOf(cell, axis) + step;
    return index >= 0 && index < (axis == 0 ? columns_ : rows_);
  }
  /// Returns the cell one step along an axis beside `cell`; requires `canLeave`.
  int beside(int cell, int axis, int step) const {
    return cell + (axis == 0 ? step : step * (1 << rowShift_));
  }
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
  /// Does the same for the three cells that come into reach after a step along an axis into `cell`.
  int findAhead(int cell, int axis, int step, int* found) const {
    if (!canLeave(cell, axis, step)) return 0;
    const int column = indexOf(cell, 0), row = indexOf(cell, 1);
    return axis == 0 ? findIn(column + step, column + step, row - 1, row + 1, found)
                     : findIn(column - 1, column + 1, row + step, row + step, found);
  }
  static constexpr int kSpare = 3;
  // Prefetch from memory: in which cell an item is, and `cell` with those around it.
  void fetchCellOf(int item) const { __builtin_prefetch(&cellOf_[item]); }
  void fetchNear(int cell) const {
    const int column = indexOf(cell, 0), row = indexOf(cell, 1);
    for (int beside = std::max(0, row - 1); beside <= std::min(rows_ - 1, row + 1); ++beside) {
      __builtin_prefetch(&blocks_[cellIn(std::max(0, column - 1), beside)]);
      __builtin_prefetch(&blocks_[cellIn(std::min(columns_ - 1, column + 1), beside)]);
    }
  }

 private:
  static constexpr int kNone = -1;
  // The first items of a cell. Further items are in further blocks, which follow those of the cells.
  struct Block {
    std::array<int, kSpare> items{kNone, kNone, kNone};  // filled from the front, all but the last block full
    int more = kNone;
  };

  static int indexIn(double index, int count) {
    return static_cast<int>(std::clamp(index, 0.0, static_cast<double>(count - 1)));
  }
  int cellIn(int column, int row) const { return (row << rowShift_) + column; }
  int indexOf(int cell, int axis) const {
    return axis == 0 ? cell & ((1 << rowShift_) - 1) : cell >> rowShift_;
  }
  int findIn(int columnLow, int columnHigh, int rowLow, int rowHigh, int* found) const {
    columnLow = std::max(0, columnLow), columnHigh = std::min(columns_ - 1, columnHigh);
    rowLow = std::max(0, rowLow), rowHigh = std::min(rows_ - 1, rowHigh);
    int* end = found;
    for (int row = rowLow; row <= rowHigh; ++row) {
      for (int column = columnLow; column <= columnHigh; ++column) {
        for (int block = cellIn(column, row); block != kNone; block = blocks_[block].more) {
          for (const int item : blocks_[block].items) {  // always all of them: no branch to mispredict
            *end = item;
            end += item != kNone ? 1 : 0;
          }
        }
      }
    }
    return static_cast<int>(end - found);
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
    int block = cell;
    auto place = blocks_[block].items.end();
    while ((place = std::find(blocks_[block].items.begin(), blocks_[block].items.end(), item)) ==
           blocks_[block].items.end()) {
      block = blocks_[block].more;
    }
    int last = block, beforeLast = cell;
    if (block != cell) {
      while (blocks_[beforeLast].more != block) beforeLast = blocks_[beforeLast].more;
    }
    for (; blocks_[last].more != kNone; last = blocks_[last].more) beforeLast = last;
    auto& items = blocks_[last].items;
    const auto lastItem = std::find(items.begin(), items.end(), kNone) - 1;
    *place = *lastItem;
    *lastItem = kNone;
    if (last != cell && items.front() == kNone) {
      blocks_[beforeLast].more = kNone;
      blocks_[last].more = free_;
      free_ = last;
    }
  }

  double lowX_ = 0.0, lowY_ = 0.0, cell_ = 1.0, perCell_ = 1.0;
  int columns_ = 1, rows_ = 1;
  int rowShift_ = 0;           // a row of cells has room for 2^rowShift_
  std::vector<Block> blocks_;  // by cell, then those for more items
  std::vector<int> cellOf_;    // by item
  int free_ = kNone;           // the first of the blocks for more items that hold none
};

}  // namespace carom
