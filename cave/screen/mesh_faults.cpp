#include "cave/screen/mesh_faults.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace carom {
namespace {

constexpr double kLargest_m = 1.0;
constexpr int kMask = 512;  // squares of the window each way

/// Which squares of the window show screen, by their middles.
class WindowMask {
 public:
  explicit WindowMask(const ScreenMesh& mesh) : squares_(std::size_t{kMask} * kMask, 0) {
    for (const ScreenTriangle& triangle : mesh) add(triangle);
  }

  bool isScreen(const glm::dvec2& inWindow) const {
    const glm::ivec2 square(glm::floor(inWindow * static_cast<double>(kMask)));
    return square.x >= 0 && square.y >= 0 && square.x < kMask && square.y < kMask &&
           squares_[indexOf(square)];
  }
  /// Returns a point of the first triangle that shows a place that another one shows.
  const std::optional<ScreenPoint>& twice() const { return twice_; }

 private:
  static std::size_t indexOf(const glm::ivec2& square) {
    return static_cast<std::size_t>(square.y) * kMask + static_cast<std::size_t>(square.x);
  }
  void add(const ScreenTriangle& t) {
    constexpr double kInside = 1e-6;
    const glm::dvec2 low = glm::min(glm::min(t[0].inWindow, t[1].inWindow), t[2].inWindow),
                     high = glm::max(glm::max(t[0].inWindow, t[1].inWindow), t[2].inWindow);
    const glm::ivec2 from =
                         glm::clamp(glm::ivec2(glm::floor(low * static_cast<double>(kMask))), 0, kMask - 1),
                     to = glm::clamp(glm::ivec2(glm::floor(high * static_cast<double>(kMask))), 0, kMask - 1);
    const double area = windowArea(t);
    const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
    for (int y = from.y; y <= to.y; ++y) {
      for (int x = from.x; x <= to.x; ++x) {
        const glm::dvec2 at = (glm::dvec2(x, y) + 0.5) / static_cast<double>(kMask) - t[0].inWindow;
        const double b = cross(at, t[2].inWindow - t[0].inWindow) / area,
                     c = cross(t[1].inWindow - t[0].inWindow, at) / area;
        if (!(b > kInside && c > kInside && b + c < 1.0 - kInside)) continue;
        char& square = squares_[indexOf({x, y})];
        if (square && !twice_) twice_ = t[0];
        square = 1;
      }
    }
  }

  std::vector<char> squares_;
  std::optional<ScreenPoint> twice_;
};

/// An edge of a triangle: its ends in one order, and which triangle it is of.
struct Edge {
  std::array<std::array<std::int64_t, 5>, 2> ends;
  std::size_t triangle = 0, corner = 0;

  bool operator<(const Edge& other) const { return ends < other.ends; }
};

/// A point to a hundred-thousandth of a millimetre and of the window's ten-millionth.
std::array<std::int64_t, 5> keyOf(const ScreenPoint& point) {
  constexpr double kSameInWindow = 1e-7, kSame_m = 1e-6;
  return {std::llround(point.inWindow.x / kSameInWindow), std::llround(point.inWindow.y / kSameInWindow),
          std::llround(point.inRoom_m.x / kSame_m), std::llround(point.inRoom_m.y / kSame_m),
          std::llround(point.inRoom_m.z / kSame_m)};
}

/// Returns the edges of all triangles; those of one place follow each other.
std::vector<Edge> edgesOf(const ScreenMesh& mesh) {
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.size());
  for (std::size_t triangle = 0; triangle < mesh.size(); ++triangle) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      auto from = keyOf(mesh[triangle][corner]), to = keyOf(mesh[triangle][(corner + 1) % 3]);
      if (to < from) std::swap(from, to);
      edges.push_back({{from, to}, triangle, corner});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

bool isSame(const Edge& a, const Edge& b) { return a.ends == b.ends; }

/// Returns the normal of a triangle, to the side from which the window is not mirrored.
glm::dvec3 normalOf(const ScreenTriangle& t) {
  const double side = windowArea(t) < 0.0 ? -1.0 : 1.0;
  return side * glm::cross(t[1].inRoom_m - t[0].inRoom_m, t[2].inRoom_m - t[0].inRoom_m);
}

/// Returns whether two triangles with a common edge lie on the same side of it in the window.
bool foldsInWindow(const ScreenMesh& mesh, const Edge& a, const Edge& b) {
  const glm::dvec2 from = mesh[a.triangle][a.corner].inWindow,
                   along = mesh[a.triangle][(a.corner + 1) % 3].inWindow - from;
  const auto side = [&](const Edge& edge) {
    const glm::dvec2 at = mesh[edge.triangle][(edge.corner + 2) % 3].inWindow - from;
    return along.x * at.y - along.y * at.x;
  };
  return side(a) * side(b) > 0.0;
}

std::string largeWords(double edge_m, const ScreenPoint& at) {
  return fmt::format("a cell of the mesh has an edge of {:.3f} m at {}, expected at most {:g} m", edge_m,
                     wordsFor(at), kLargest_m);
}

}  // namespace

std::string wordsFor(const ScreenPoint& point) {
  return fmt::format("{:.3f}, {:.3f} of the window ({:.3f}, {:.3f}, {:.3f} m of the room)", point.inWindow.x,
                     point.inWindow.y, point.inRoom_m.x, point.inRoom_m.y, point.inRoom_m.z);
}

std::string largeCellIn(const ScreenMesh& mesh) {
  for (const ScreenTriangle& t : mesh) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double edge_m = glm::distance(t[i].inRoom_m, t[(i + 1) % 3].inRoom_m);
      if (edge_m > kLargest_m) return largeWords(edge_m, t[i]);
    }
  }
  return {};
}

std::string largeCellIn(const ScreenGrid& grid) {
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const glm::dvec3 here(grid.at(column, row));
      for (const glm::ivec2& to : {glm::ivec2(column + 1, row), glm::ivec2(column, row + 1)}) {
        if (to.x >= grid.columns || to.y >= grid.rows) continue;
        const double edge_m = glm::distance(here, glm::dvec3(grid.at(to.x, to.y)));
        if (edge_m > kLargest_m)  // NaN is not
          return largeWords(edge_m, {{(column + 0.5) / grid.columns, (row + 0.5) / grid.rows}, here});
      }
    }
  }
  return {};
}

std::string foldIn(const ScreenMesh& mesh) {
  const std::vector<Edge> edges = edgesOf(mesh);
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const Edge &a = edges[i], &b = edges[i + 1];
    if (!isSame(a, b)) continue;
    const ScreenPoint& at = mesh[a.triangle][a.corner];
    if (foldsInWindow(mesh, a, b))
      return fmt::format("the mesh folds over itself in the window at {}, expected each place once",
                         wordsFor(at));
    if (glm::dot(normalOf(mesh[a.triangle]), normalOf(mesh[b.triangle])) < 0.0)
      return fmt::format(
          "the mesh folds over itself in the room at {}, expected a screen that turns by less than "
          "90° from cell to cell",
          wordsFor(at));
  }
  const WindowMask mask(mesh);
  if (const std::optional<ScreenPoint>& twice = mask.twice())
    return fmt::format(
        "two parts of the mesh are at the same place of the window, at {}, expected each place once",
        wordsFor(*twice));
  return {};
}

std::vector<std::array<ScreenPoint, 2>> rimOf(const ScreenMesh& mesh) {
  // Where a large cell ends at small ones its edge is of no other triangle, and yet the screen goes on.
  constexpr double kBeyond = 1.5 / kMask;
  const WindowMask mask(mesh);
  const std::vector<Edge> edges = edgesOf(mesh);
  std::vector<std::array<ScreenPoint, 2>> rim;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if ((i > 0 && isSame(edges[i - 1], edges[i])) || (i + 1 < edges.size() && isSame(edges[i], edges[i + 1])))
      continue;
    const ScreenTriangle& t = mesh[edges[i].triangle];
    const ScreenPoint &from = t[edges[i].corner], &to = t[(edges[i].corner + 1) % 3],
                      &inside = t[(edges[i].corner + 2) % 3];
    const glm::dvec2 middle = 0.5 * (from.inWindow + to.inWindow), along = to.inWindow - from.inWindow;
    glm::dvec2 out = glm::normalize(glm::dvec2(along.y, -along.x));
    if (glm::dot(out, inside.inWindow - middle) > 0.0) out = -out;
    if (!mask.isScreen(middle + kBeyond * out)) rim.push_back({from, to});
  }
  return rim;
}

}  // namespace carom
