#include "cave/screen/screen_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cave/screen/curved_screen.h"

namespace carom {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr int kMostFiner = 16;
constexpr std::size_t kMostCells = 100'000;

bool isThere(const glm::dvec3& place) { return !std::isnan(place.x); }

/// Returns the value of the Catmull–Rom curve through four points between the second and the third, at the
/// share t of the way:
/// P(t) = P1 + t/2 (P2 − P0) + t² (P0 − 5/2 P1 + 2 P2 − P3/2) + t³ (3/2 (P1 − P2) + (P3 − P0)/2).
glm::dvec3 between(const std::array<glm::dvec3, 4>& p, double t) {
  return p[1] + 0.5 * t * (p[2] - p[0]) + t * t * (p[0] - 2.5 * p[1] + 2.0 * p[2] - 0.5 * p[3]) +
         t * t * t * (1.5 * (p[1] - p[2]) + 0.5 * (p[3] - p[0]));
}

/// Returns the point `share` of a cell beyond the last point, `a`, before which are `b` and `c`: Lagrange's
/// parabola through them, or the line through two. None (NaN) where there are not so many.
glm::dvec3 beyond(const glm::dvec3& a, const glm::dvec3& b, glm::dvec3 c, double share) {
  if (!isThere(a) || !isThere(b)) return glm::dvec3(kNaN);
  if (!isThere(c)) c = 2.0 * b - a;
  return 0.5 * (share + 1.0) * (share + 2.0) * a - share * (share + 2.0) * b +
         0.5 * share * (share + 1.0) * c;
}

/// The points of one line of a grid, as a curve.
class GridLine {
 public:
  explicit GridLine(std::vector<glm::dvec3> points) : points_(std::move(points)) {}

  /// Returns a place: `at` counts points, and reaches half a cell beyond the ends. None (NaN) where a
  /// neighbour is none.
  glm::dvec3 operator()(double at) const {
    const int last = static_cast<int>(points_.size()) - 1;
    const int low = std::clamp(static_cast<int>(std::floor(at)), 0, last - 1);
    const double share = at - low;
    if (share < 0.0 || share > 1.0)
      return beyondEnd(share < 0.0 ? 0 : last, share < 0.0 ? 1 : -1, share < 0.0 ? -share : share - 1.0);
    if (share == 0.0) return points_[static_cast<std::size_t>(low)];
    if (share == 1.0) return points_[static_cast<std::size_t>(low) + 1];
    const glm::dvec3 from = point(low), to = point(low + 1);
    if (!isThere(from) || !isThere(to)) return glm::dvec3(kNaN);
    glm::dvec3 before = point(low - 1), after = point(low + 2);
    if (!isThere(before)) before = continued(from, to, after);
    if (!isThere(after)) after = continued(to, from, before);
    return between({before, from, to, after}, share);
  }

 private:
  glm::dvec3 point(int index) const {
    return index < 0 || index >= static_cast<int>(points_.size()) ? glm::dvec3(kNaN)
                                                                  : points_[static_cast<std::size_t>(index)];
  }
  /// Returns the point that follows `c`, `b` and `a` on a parabola, or on a line if there is no `c`.
  static glm::dvec3 continued(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return isThere(c) ? 3.0 * a - 3.0 * b + c : 2.0 * a - b;
  }
  /// Returns the point `share` of a cell beyond an end.
  glm::dvec3 beyondEnd(int end, int inwards, double share) const {
    return beyond(point(end), point(end + inwards), point(end + 2 * inwards), share);
  }

  std::vector<glm::dvec3> points_;
};

/// Points of a screen on lines across and up the window.
struct Net {
  std::vector<double> across, up;  ///< places of the lines in the window
  std::vector<glm::vec3> places;   ///< row by row from below; NaN: none

  glm::dvec3 at(std::size_t column, std::size_t row) const {
    return glm::dvec3(places[row * across.size() + column]);
  }
};

/// Returns the lines of a net, `finer` to each cell, counted in points of the grid: from half a cell before
/// the first one to half a cell behind the last one.
std::vector<double> linesOf(int count, int finer) {
  std::vector<double> lines{-0.5};
  for (int i = 0; i + 1 < count; ++i) {
    for (int part = 0; part < finer; ++part) lines.push_back(i + static_cast<double>(part) / finer);
  }
  lines.push_back(count - 1.0);
  lines.push_back(count - 0.5);
  return lines;
}

Net netOf(const ScreenGrid& grid, int finer) {
  const std::vector<double> columns = linesOf(grid.columns, finer), rows = linesOf(grid.rows, finer);
  Net net;
  for (const double column : columns) net.across.push_back((column + 0.5) / grid.columns);
  for (const double row : rows) net.up.push_back((row + 0.5) / grid.rows);
  std::vector<std::vector<glm::dvec3>> alongRows;
  for (int row = 0; row < grid.rows; ++row) {
    std::vector<glm::dvec3> points;
    for (int column = 0; column < grid.columns; ++column) points.emplace_back(grid.at(column, row));
    const GridLine line(std::move(points));
    std::vector<glm::dvec3>& along = alongRows.emplace_back();
    for (const double column : columns) along.push_back(line(column));
  }
  net.places.resize(columns.size() * rows.size());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    std::vector<glm::dvec3> points;
    for (const auto& along : alongRows) points.push_back(along[i]);
    const GridLine line(std::move(points));
    for (std::size_t j = 0; j < rows.size(); ++j)
      net.places[j * columns.size() + i] = glm::vec3(line(rows[j]));
  }
  return net;
}

/// Returns the net of a grid's own points and of the window's rim.
Net netOf(const ScreenGrid& grid) {
  Net net;
  for (const double column : linesOf(grid.columns, 1)) net.across.push_back((column + 0.5) / grid.columns);
  for (const double row : linesOf(grid.rows, 1)) net.up.push_back((row + 0.5) / grid.rows);
  const std::size_t width = net.across.size(), height = net.up.size();
  net.places.assign(width * height, glm::vec3(static_cast<float>(kNaN)));
  const auto continued = [&](std::size_t from, std::size_t step, std::size_t count) {
    const glm::dvec3 c = count > 2 ? glm::dvec3(net.places[from + 2 * step]) : glm::dvec3(kNaN);
    constexpr double kHalfCell = 0.5;
    return glm::vec3(beyond(glm::dvec3(net.places[from]), glm::dvec3(net.places[from + step]), c, kHalfCell));
  };
  const auto columns = static_cast<std::size_t>(grid.columns), rows = static_cast<std::size_t>(grid.rows);
  const std::size_t back = static_cast<std::size_t>(0) - 1, down = static_cast<std::size_t>(0) - width;
  for (std::size_t row = 1; row <= rows; ++row) {
    const std::size_t first = row * width + 1, last = row * width + columns;
    std::copy_n(grid.places.begin() + static_cast<std::ptrdiff_t>((row - 1) * columns), columns,
                net.places.begin() + static_cast<std::ptrdiff_t>(first));
    net.places[first - 1] = continued(first, 1, columns);
    net.places[last + 1] = continued(last, back, columns);
  }
  for (std::size_t column = 0; column < width; ++column) {
    net.places[column] = continued(width + column, width, rows);
    net.places[(rows + 1) * width + column] = continued(rows * width + column, down, rows);
  }
  return net;
}

/// A rectangle of a net's cells, its last lines included.
struct Block {
  std::size_t left, bottom, right, top;
};

/// Makes triangles of a net: one cell each, or large flat parts as a whole.
class NetMesh {
 public:
  /// `flat_px`: how far the points of a part may be off its triangles; below 0: none is made.
  NetMesh(const Net& net, const glm::ivec2& window_px, double flat_px)
      : net_(net), window_px_(window_px), flat_px_(flat_px) {
    add({0, 0, net.across.size() - 1, net.up.size() - 1});
  }

  /// Returns the triangles; none if they are too many.
  ScreenMesh take() {
    if (mesh_.size() > kMostTriangles) mesh_.clear();
    return std::move(mesh_);
  }

 private:
  static constexpr std::size_t kMostTriangles = 4 * kMostCells;

  void add(const Block& block) {
    if (mesh_.size() > kMostTriangles) return;
    const bool isCell = block.right == block.left + 1 && block.top == block.bottom + 1;
    if (isCell || (flat_px_ >= 0.0 && isFlat(block))) return addBlock(block);
    const std::size_t middle = (block.left + block.right) / 2, half = (block.bottom + block.top) / 2;
    const bool isWide = block.right - block.left >= block.top - block.bottom;
    if (isWide) {
      add({block.left, block.bottom, middle, block.top});
      add({middle, block.bottom, block.right, block.top});
    } else {
      add({block.left, block.bottom, block.right, half});
      add({block.left, half, block.right, block.top});
    }
  }
  ScreenPoint point(std::size_t column, std::size_t row) const {
    return {{net_.across[column], net_.up[row]}, net_.at(column, row)};
  }
  void addBlock(const Block& block) {
    const ScreenPoint a = point(block.left, block.bottom), b = point(block.right, block.bottom),
                      c = point(block.right, block.top), d = point(block.left, block.top);
    if (!isThere(a.inRoom_m) || !isThere(b.inRoom_m) || !isThere(c.inRoom_m) || !isThere(d.inRoom_m)) return;
    mesh_.push_back({a, b, c});
    mesh_.push_back({a, c, d});
  }
  /// Returns whether all points of the block are on the screen, and near its two triangles.
  bool isFlat(const Block& block) const {
    const ScreenPoint a = point(block.left, block.bottom), b = point(block.right, block.bottom),
                      c = point(block.right, block.top), d = point(block.left, block.top);
    const double diagonal_px = glm::length((c.inWindow - a.inWindow) * glm::dvec2(window_px_));
    const double most_m = flat_px_ * glm::distance(a.inRoom_m, c.inRoom_m) / diagonal_px;
    for (std::size_t row = block.bottom; row <= block.top; ++row) {
      for (std::size_t column = block.left; column <= block.right; ++column) {
        const double x = (net_.across[column] - a.inWindow.x) / (c.inWindow.x - a.inWindow.x),
                     y = (net_.up[row] - a.inWindow.y) / (c.inWindow.y - a.inWindow.y);
        const glm::dvec3 onPlane_m =
            x >= y ? a.inRoom_m + x * (b.inRoom_m - a.inRoom_m) + y * (c.inRoom_m - b.inRoom_m)
                   : a.inRoom_m + y * (d.inRoom_m - a.inRoom_m) + x * (c.inRoom_m - d.inRoom_m);
        if (!(glm::distance(net_.at(column, row), onPlane_m) <= most_m)) return false;  // nor NaN
      }
    }
    return true;
  }

  const Net& net_;
  glm::ivec2 window_px_;
  double flat_px_;
  ScreenMesh mesh_;
};

}  // namespace

bool hasCell(const ScreenGrid& grid) {
  for (int row = 0; row + 1 < grid.rows; ++row) {
    for (int column = 0; column + 1 < grid.columns; ++column) {
      if (isThere(grid.at(column, row)) && isThere(grid.at(column + 1, row)) &&
          isThere(grid.at(column, row + 1)) && isThere(grid.at(column + 1, row + 1)))
        return true;
    }
  }
  return false;
}

GridMesh meshOf(const ScreenGrid& grid, const glm::ivec2& window_px, std::span<const glm::dvec3> eyes_m) {
  constexpr double kMostSlide_px = 0.1, kFlat_px = 0.02;
  const auto cells = static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
  const Net coarse = netOf(grid);
  if (cells > kMostCells) {
    ScreenMesh mesh;
    for (double flat_px = kFlat_px; mesh.empty() && flat_px < 1.0; flat_px *= 2.0)
      mesh = NetMesh(coarse, window_px, flat_px).take();
    return {std::move(mesh), 1};
  }
  GridMesh made{NetMesh(coarse, window_px, -1.0).take(), 1};
  const double slide_px = slideOf_px(made.mesh, window_px, eyes_m);
  const int needed = static_cast<int>(std::ceil(std::sqrt(std::min(slide_px / kMostSlide_px, 1e4)))),
            most = static_cast<int>(std::sqrt(static_cast<double>(kMostCells) / static_cast<double>(cells)));
  made.finer = std::clamp(needed, 1, std::clamp(most, 1, kMostFiner));
  if (made.finer > 1) made.mesh = NetMesh(netOf(grid, made.finer), window_px, -1.0).take();
  return made;
}

}  // namespace carom
