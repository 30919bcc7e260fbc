#include "engine/impact/cell_grid.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "engine/random_world.h"

namespace carom {
namespace {

constexpr double kLowX = -1.0, kLowY = -0.5, kCell = 0.25;
constexpr int kColumns = 7, kRows = 4, kItems = 60;

// The grid's cells by their columns and rows, and the items in a plain list of them.
struct Place {
  int column = -1, row = -1;
};

Place placeAt(double x, double y) {
  return {std::clamp(static_cast<int>(std::floor((x - kLowX) / kCell)), 0, kColumns - 1),
          std::clamp(static_cast<int>(std::floor((y - kLowY) / kCell)), 0, kRows - 1)};
}

template <class Wanted>
std::vector<int> itemsWhere(const std::vector<Place>& places, Wanted wanted) {
  std::vector<int> items;
  for (int item = 0; item < kItems; ++item) {
    const Place& place = places[static_cast<std::size_t>(item)];
    if (place.column >= 0 && wanted(place)) items.push_back(item);
  }
  return items;
}

std::vector<int> sorted(std::vector<int> found, int count) {
  found.resize(static_cast<std::size_t>(count));
  std::sort(found.begin(), found.end());
  return found;
}

// The numbers of the items found, each of which has its own flight.
std::vector<int> sorted(const FoundFlights& found) {
  for (int k = 0; k < found.count; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const auto number = static_cast<float>(found.items[at]);
    EXPECT_EQ(found.x[at], number);
    EXPECT_EQ(found.y[at], number + 0.25f);
    EXPECT_EQ(found.vx[at], number + 0.5f);
    EXPECT_EQ(found.vy[at], number + 0.75f);
  }
  return sorted(found.items, found.count);
}

// Half of the items crowd into one corner, so that cells hold more than their first three; some are outside.
TEST(CellGrid, FindsWhatAListFinds) {
  test::Random random(1);
  CellGrid grid(kLowX, kLowY, kCell, kColumns, kRows, kItems);
  std::vector<Place> places(kItems);
  std::vector<int> found(kItems + CellGrid::kSpare);
  FoundFlights flights(kItems);
  for (int step = 0; step < 5000; ++step) {
    CASE(random, step);
    const int item = static_cast<int>(random.in(0.0, kItems));
    const double size = item % 2 == 0 ? 0.2 : 2.0;
    const double x = kLowX + random.in(-0.1, 1.0) * size, y = kLowY + random.in(-0.1, 1.0) * size;
    const Place here = places[static_cast<std::size_t>(item)] = placeAt(x, y);
    const int cell = grid.cellAt(x, y);
    const auto number = static_cast<float>(item);
    grid.move(item, cell, {number, -1.0f, -1.0f, -1.0f});
    grid.change(item, {number, number + 0.25f, number + 0.5f, number + 0.75f});
    ASSERT_EQ(grid.cellOf(item), cell);
    for (const int reach : {0, 1, 2}) {
      const auto near = itemsWhere(places, [&](const Place& place) {
        return std::abs(place.column - here.column) <= reach && std::abs(place.row - here.row) <= reach;
      });
      ASSERT_EQ(sorted(found, grid.findNear(cell, reach, found.data())).size(), near.size());
      ASSERT_EQ(sorted(found, grid.findNear(cell, reach, found.data())), near) << "step " << step;
      grid.findNear(cell, reach, flights);
      ASSERT_EQ(sorted(flights), near) << "step " << step;
    }
    for (const int way : {-1, 1}) {
      const auto besideX = itemsWhere(places, [&](const Place& place) {
        return place.column == here.column + way && std::abs(place.row - here.row) <= 1;
      });
      const auto besideY = itemsWhere(places, [&](const Place& place) {
        return place.row == here.row + way && std::abs(place.column - here.column) <= 1;
      });
      grid.findAhead(cell, 0, way, flights);
      ASSERT_EQ(sorted(flights), besideX) << "step " << step;
      grid.findAhead(cell, 1, way, flights);
      ASSERT_EQ(sorted(flights), besideY) << "step " << step;
    }
  }
}

// A point a little beyond an edge is in the cell beside it.
TEST(CellGrid, CellsAndTheirEdgesAgree) {
  const CellGrid grid(kLowX, kLowY, kCell, kColumns, kRows, kItems);
  EXPECT_EQ(grid.cellEdge(), kCell);
  for (int column = 0; column < kColumns; ++column) {
    for (int row = 0; row < kRows; ++row) {
      const double middle[2] = {kLowX + (column + 0.5) * kCell, kLowY + (row + 0.5) * kCell};
      const int cell = grid.cellAt(middle[0], middle[1]);
      int ways = 0;
      for (int axis = 0; axis < 2; ++axis) {
        for (const int way : {-1, 1}) {
          const double edge = grid.edge(cell, axis, way);
          EXPECT_EQ(edge, middle[axis] + way * 0.5 * kCell);
          if (!grid.canLeave(cell, axis, way)) continue;
          ++ways;
          double beyond[2] = {middle[0], middle[1]};
          beyond[axis] = edge + way * 1e-9;
          EXPECT_EQ(grid.beside(cell, axis, way), grid.cellAt(beyond[0], beyond[1]));
          EXPECT_NE(grid.beside(cell, axis, way), cell);
        }
      }
      EXPECT_EQ(grid.isAtRim(cell), ways < 4);
    }
  }
  EXPECT_EQ(grid.cellAt(-1e300, -1e300), grid.cellAt(kLowX, kLowY))
      << "the outermost cells reach to infinity";
  EXPECT_EQ(grid.cellAt(1e300, 0.0), grid.cellAt(0.7, 0.0));
}

}  // namespace
}  // namespace carom
