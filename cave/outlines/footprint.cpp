#include "cave/outlines/footprint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <boost/polygon/polygon.hpp>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "engine/polygons/outline.h"
#include "engine/polygons/outline_around.h"

namespace carom {
namespace {

using Vec2 = glm::dvec2;
using GridPoint = boost::polygon::point_data<int>;
using Triangle = boost::polygon::polygon_data<int>;

/// The corners of triangles on a grid, on which areas are put together without rounding.
class Grid {
 public:
  explicit Grid(std::span<const Vec2> corners) {
    Vec2 least = corners.empty() ? Vec2(0.0) : corners[0], most = least;
    for (const Vec2& corner : corners) {
      least = glm::min(least, corner);
      most = glm::max(most, corner);
    }
    constexpr double kAcross = 1 << 29;
    const double extent = std::max(most.x - least.x, most.y - least.y);
    middle_ = 0.5 * (least + most);
    step_ = extent > 0.0 ? extent / kAcross : 1.0;
  }

  GridPoint pointOf(const Vec2& place) {
    const Vec2 steps = (place - middle_) / step_;
    const GridPoint point(static_cast<int>(std::floor(steps.x + 0.5)),
                          static_cast<int>(std::floor(steps.y + 0.5)));
    exact_.try_emplace({point.x(), point.y()}, place);
    return point;
  }

  /// Returns the first corner at a point of the grid, or else the point itself.
  Vec2 placeOf(const GridPoint& point) const {
    const auto found = exact_.find({point.x(), point.y()});
    if (found != exact_.end()) return found->second;
    return middle_ + step_ * Vec2(static_cast<double>(point.x()), static_cast<double>(point.y()));
  }

 private:
  Vec2 middle_{0.0};
  double step_ = 1.0;
  std::map<std::pair<int, int>, Vec2> exact_;
};

/// The triangles that cover anything: on the grid, and their corners.
struct Cover {
  std::vector<Triangle> onGrid;
  std::vector<Vec2> corners;
};

Cover coverOf(std::span<const Vec2> triangles, Grid& grid) {
  Cover cover;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const std::span<const Vec2> corners = triangles.subspan(i, 3);
    const std::array<GridPoint, 3> points{grid.pointOf(corners[0]), grid.pointOf(corners[1]),
                                          grid.pointOf(corners[2])};
    const Triangle triangle(points.begin(), points.end());
    if (boost::polygon::area(triangle) == 0.0) continue;
    cover.onGrid.push_back(triangle);
    cover.corners.insert(cover.corners.end(), corners.begin(), corners.end());
  }
  return cover;
}

double cross2(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

/// How far to the right a way turns that came along `from` and goes on along `to`: from −2, back, by way of
/// 0, straight on, to 2.
double rightTurn(const Vec2& from, const Vec2& to) {
  const double sine = cross2(to, from) / (glm::length(from) * glm::length(to));
  const double cosine = glm::dot(to, from) / (glm::length(from) * glm::length(to));
  return sine > 0.0 ? 1.0 - cosine : cosine - 1.0;
}

/// Returns the outer edge of the area that triangles cover together, anticlockwise; of several pieces that of
/// the one farthest to the left.
std::vector<Vec2> edgeAround(const Cover& cover, const Grid& grid) {
  boost::polygon::polygon_set_data<int> covered;
  for (const Triangle& triangle : cover.onGrid) covered.insert(triangle);
  covered.clean();  // the edges between covered and uncovered remain
  std::multimap<GridPoint, GridPoint> ways;
  for (const auto& [ends, winding] : covered) {
    ways.emplace(ends.first, ends.second);
    ways.emplace(ends.second, ends.first);
  }
  std::vector<Vec2> edge;
  if (ways.empty()) return edge;
  // From the point farthest to the left, always as far to the right as there is a way: around the outside.
  const GridPoint first = ways.begin()->first;
  GridPoint at = first;
  Vec2 along(0.0, -1.0);
  while (edge.size() < ways.size()) {
    edge.push_back(grid.placeOf(at));
    const auto [begin, end] = ways.equal_range(at);
    const auto next = std::max_element(begin, end, [&](const auto& a, const auto& b) {
      const auto turn = [&](const GridPoint& to) {
        const Vec2 way = grid.placeOf(to) - grid.placeOf(at);
        return way == -along ? -3.0 : rightTurn(along, way);
      };
      return turn(a.second) < turn(b.second);
    });
    along = grid.placeOf(next->second) - grid.placeOf(at);
    at = next->second;
    if (at == first) break;
  }
  if (at != first || !(momentsOf(edge).area > 0.0)) edge.clear();
  return edge;
}

/// Is this an outline, and around these places?
bool isAround(const std::vector<Vec2>& corners, std::span<const Vec2> places) {
  if (faultOf(corners)) return false;
  const Outline outline(corners);
  constexpr double kRounding = 1e-7;  // of the extent
  const double beside = kRounding * glm::length(corners[0] - corners[corners.size() / 2]);
  return std::all_of(places.begin(), places.end(),
                     [&](const Vec2& place) { return outline.clearanceOf(place).outside <= beside; });
}

/// Returns the outline around an edge that runs anticlockwise.
std::vector<Vec2> cornersAround(const std::vector<Vec2>& edge) {
  constexpr double kMoved = 0.02;  // what the outline's centre may be beside the edge's, of the radius
  const Vec2 centre = momentsOf(edge).centre;
  double radius = 0.0;
  for (const Vec2& corner : edge) radius = std::max(radius, glm::length(corner - centre));
  return outlineAround(edge, kFootprintOutwards * (1.0 - kMoved) * radius, kEnoughCorners);
}

}  // namespace

Footprint footprintOf(std::span<const Vec2> triangles) {
  Grid grid(triangles);
  const Cover cover = coverOf(triangles, grid);
  if (cover.onGrid.empty()) throw std::runtime_error("its footprint is a line or a point, expected an area");
  Footprint footprint;
  if (const std::vector<Vec2> edge = edgeAround(cover, grid); !edge.empty())
    footprint.corners = cornersAround(edge);
  if (footprint.corners.size() > kMostCorners) {
    throw std::runtime_error(
        fmt::format("its footprint has {} corners when simplified by {} % of its radius, expected at most {}",
                    footprint.corners.size(), 100.0 * kFootprintOutwards, kMostCorners));
  }
  // An edge that touches itself is none of an outline.
  footprint.isInOnePiece = isAround(footprint.corners, cover.corners);
  if (!footprint.isInOnePiece) footprint.corners = cornersAround(hullOf(cover.corners));
  if (faultOf(footprint.corners)) throw std::runtime_error("its footprint is a line, expected an area");
  footprint.centre = momentsOf(footprint.corners).centre;
  for (Vec2& corner : footprint.corners) {
    corner -= footprint.centre;
    footprint.radius = std::max(footprint.radius, glm::length(corner));
  }
  return footprint;
}

}  // namespace carom
