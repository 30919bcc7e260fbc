#pragma once
// A grid of square cells over the board that holds each puck's number in the cell of its centre, so that
// neighbours are found without looking at every puck. The outermost cells reach to infinity.

#include <algorithm>
#include <cmath>
#include <vector>

namespace carom {

class CellGrid {
 public:
  CellGrid() = default;
  /// Cells of edge `cell` from (lowX, lowY) on, for `items` items that are nowhere yet.
  CellGrid(double lowX, double lowY, double cell, int columns, int rows, int items)
      : lowX_(lowX),
        lowY_(lowY),
        cell_(cell),
        perCell_(1.0 / cell),
        columns_(columns),
        rows_(rows),
        first_(static_cast<std::size_t>(columns) * rows, kNone),
        next_(items, kNone),
        previous_(items, kNone),
        cellOf_(items, kNone) {}

  double cellEdge() const { return cell_; }
  int cellOf(int item) const { return cellOf_[item]; }
  int cellAt(double x, double y) const {
    return columnIn(std::floor((x - lowX_) * perCell_), columns_) +
           columns_ * columnIn(std::floor((y - lowY_) * perCell_), rows_);
  }

  void move(int item, int cell) {
    if (cellOf_[item] != kNone) unlink(item);
    cellOf_[item] = cell;
    next_[item] = first_[cell];
    previous_[item] = kNone;
    if (first_[cell] != kNone) previous_[first_[cell]] = item;
    first_[cell] = item;
  }

  /// The cell beside `cell`, one step along an axis; `cell` itself at the rim.
  int beside(int cell, int axis, int step) const {
    const int column = cell % columns_, row = cell / columns_;
    return axis == 0 ? std::clamp(column + step, 0, columns_ - 1) + columns_ * row
                     : column + columns_ * std::clamp(row + step, 0, rows_ - 1);
  }
  /// Whether a step along an axis leads out of `cell` into another.
  bool canLeave(int cell, int axis, int step) const { return beside(cell, axis, step) != cell; }
  /// The coordinate of the edge between `cell` and the one beside it.
  double edge(int cell, int axis, int step) const {
    const int index = axis == 0 ? cell % columns_ : cell / columns_;
    return (axis == 0 ? lowX_ : lowY_) + (index + (step > 0 ? 1 : 0)) * cell_;
  }

  /// Calls f(item) for every item of the cells within `reach` cells of `cell`.
  template <class Function>
  void forEachNear(int cell, int reach, Function f) const {
    const int column = cell % columns_, row = cell / columns_;
    forEachIn(column - reach, column + reach, row - reach, row + reach, f);
  }
  /// Calls f(item) for every item of the three cells that came near by a step along an axis into `cell`.
  template <class Function>
  void forEachAhead(int cell, int axis, int step, Function f) const {
    const int column = cell % columns_, row = cell / columns_;
    if (axis == 0) {
      if (column + step >= 0 && column + step < columns_)
        forEachIn(column + step, column + step, row - 1, row + 1, f);
    } else {
      if (row + step >= 0 && row + step < rows_) forEachIn(column - 1, column + 1, row + step, row + step, f);
    }
  }

 private:
  static constexpr int kNone = -1;
  static int columnIn(double column, int columns) {
    return static_cast<int>(std::clamp(column, 0.0, static_cast<double>(columns - 1)));
  }
  template <class Function>
  void forEachIn(int columnLow, int columnHigh, int rowLow, int rowHigh, Function& f) const {
    const int c0 = std::max(0, columnLow), c1 = std::min(columns_ - 1, columnHigh);
    for (int row = std::max(0, rowLow); row <= std::min(rows_ - 1, rowHigh); ++row) {
      for (int column = c0; column <= c1; ++column) {
        for (int item = first_[row * columns_ + column]; item != kNone; item = next_[item]) f(item);
      }
    }
  }
  void unlink(int item) {
    if (previous_[item] != kNone) {
      next_[previous_[item]] = next_[item];
    } else {
      first_[cellOf_[item]] = next_[item];
    }
    if (next_[item] != kNone) previous_[next_[item]] = previous_[item];
  }

  double lowX_ = 0.0, lowY_ = 0.0, cell_ = 1.0, perCell_ = 1.0;
  int columns_ = 1, rows_ = 1;
  std::vector<int> first_;                     // by cell
  std::vector<int> next_, previous_, cellOf_;  // by item
};

}  // namespace carom
