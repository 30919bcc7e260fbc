#include "cave/scene/shadow_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "cave/mesh/mesh_builder.h"
#include "engine/polygons/outline.h"

namespace carom {
namespace {

using Vec2 = glm::dvec2;

constexpr double kHall = kShadowOfHall;

double cross2(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

/// Returns corners of a simple polygon that runs anticlockwise, three for each of its triangles: its ears are
/// cut off one after the other.
std::vector<std::size_t> trianglesOf(const std::vector<Vec2>& polygon) {
  std::vector<std::size_t> left, triangles;
  for (std::size_t k = 0; k < polygon.size(); ++k) left.push_back(k);
  const auto isEar = [&](std::size_t a, std::size_t b, std::size_t c) {
    const Vec2 &p = polygon[a], &q = polygon[b], &r = polygon[c];
    if (!(cross2(q - p, r - q) > 0.0)) return false;
    return std::none_of(left.begin(), left.end(), [&](std::size_t other) {
      const Vec2& x = polygon[other];
      return other != a && other != b && other != c && cross2(q - p, x - p) >= 0.0 &&
             cross2(r - q, x - q) >= 0.0 && cross2(p - r, x - r) >= 0.0;
    });
  };
  for (std::size_t k = 0, without = 0; left.size() > 2 && without < left.size();
       k = (k + 1) % left.size(), ++without) {
    const std::size_t a = left[(k + left.size() - 1) % left.size()], c = left[(k + 1) % left.size()];
    if (!isEar(a, left[k], c)) continue;
    triangles.insert(triangles.end(), {a, left[k], c});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
    k = (k + left.size() - 1) % left.size();
    without = 0;
  }
  return triangles;
}

/// A side of the outline in the shadow: from its begin to its end where all light is hidden, and where none
/// is.
struct ShadowSide {
  Vec2 normal{0.0}, dark[2], lit[2];
};

/// Where both sides of a corner are a metre farther out.
Vec2 mitreOf(const Vec2& before, const Vec2& after) {
  return (before + after) / std::max(1.0 + glm::dot(before, after), 0.05);
}

/// The sides of a shadow that begins `in_m` inside of the outline and ends `out_m` outside.
std::vector<ShadowSide> sidesOf(const Outline& outline, double in_m, double out_m) {
  const auto sides = outline.sides();
  const std::size_t count = sides.size();
  std::vector<Vec2> dark;
  for (;; in_m *= 0.5) {  // as far inside as there is room
    if (in_m < 1e-3 * outline.radius()) in_m = 0.0;
    dark.clear();
    for (std::size_t k = 0; k < count; ++k)
      dark.push_back(sides[k].from - in_m * mitreOf(sides[(k + count - 1) % count].normal, sides[k].normal));
    bool sameWay = true;
    for (std::size_t k = 0; k < count; ++k)
      sameWay = sameWay && glm::dot(dark[(k + 1) % count] - dark[k], sides[k].along) > 0.0;
    if (in_m == 0.0 || (sameWay && !faultOf(dark))) break;
  }
  std::vector<ShadowSide> result(count);
  for (std::size_t k = 0; k < count; ++k) {
    result[k].normal = sides[k].normal;
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
      const Outline::Side &before = sides[(k + end + count - 1) % count], &after = sides[(k + end) % count];
      const bool isDent = cross2(before.along, after.along) < 0.0;
      result[k].dark[end] = dark[(k + end) % count];
      result[k].lit[end] =
          after.from + out_m * (isDent ? mitreOf(before.normal, after.normal) : sides[k].normal);
    }
  }
  return result;
}

Vec2 between(const Vec2& from, const Vec2& to, double share) { return from + share * (to - from); }

/// The shadow of one light on its way into a mesh.
class ShadowOfOne {
 public:
  ShadowOfOne(MeshBuilder& mesh, const std::vector<ShadowSide>& sides, double light, double height_m,
              double cell_m)
      : mesh_(mesh), sides_(sides), light_(light), height_m_(height_m), cell_m_(cell_m) {}

  void add() {
    for (std::size_t k = 0; k < sides_.size(); ++k) {
      const ShadowSide &side = sides_[k], &next = sides_[(k + 1) % sides_.size()];
      mesh_.addPatch(cellsOf(side), 2, [&](double u, double v) {
        return point(between(between(side.lit[0], side.lit[1], u), darkAt(side, u), v), 1.0 - v, side.normal);
      });
      mesh_.addPatch(1, 2, [&](double u, double v) {  // the corner
        return point(between(u < 0.5 ? side.lit[1] : next.lit[0], side.dark[1], v), 1.0 - v,
                     u < 0.5 ? side.normal : next.normal);
      });
    }
    const bool seesAll = std::all_of(sides_.begin(), sides_.end(), [](const ShadowSide& side) {
      return cross2(side.dark[0], side.dark[1]) > 0.0;
    });
    seesAll ? addFromCentre() : addInTriangles();
  }

 private:
  static Vec2 darkAt(const ShadowSide& side, double share) {
    return between(side.dark[0], side.dark[1], share);
  }
  int cellsOf(const ShadowSide& side) const {
    return cellsFor(glm::length(side.dark[1] - side.dark[0]), cell_m_);
  }
  PatchPoint point(const Vec2& at, double fade, const Vec2& normal) const {
    return {{at, kShadowAboveCloth_m - 0.5 * height_m_}, {fade, light_, height_m_}, {normal, 0.0}};
  }

  /// Adds the dark part, around a centre from which each side is seen: it bends as a puck in a bounce does.
  void addFromCentre() {
    constexpr int kRings = 4;
    for (std::size_t k = 0; k < sides_.size(); ++k) {
      const ShadowSide &side = sides_[k], &next = sides_[(k + 1) % sides_.size()];
      mesh_.addPatch(cellsOf(side), kRings, [&](double u, double v) {
        return point((1.0 - v) * darkAt(side, u), 0.0, side.normal);
      });
      mesh_.addPatch(1, kRings, [&](double u, double v) {
        return point((1.0 - v) * side.dark[1], 0.0, u < 0.5 ? side.normal : next.normal);
      });
    }
  }

  /// Adds the dark part of any outline.
  void addInTriangles() {
    std::vector<Vec2> dark;
    std::vector<std::size_t> sideOf;
    for (std::size_t k = 0; k < sides_.size(); ++k) {
      const int cells = cellsOf(sides_[k]);
      for (int cell = 0; cell < cells; ++cell) {
        dark.push_back(darkAt(sides_[k], static_cast<double>(cell) / cells));
        sideOf.push_back(k);
      }
    }
    const auto addTriangle = [&](const PatchPoint& a, const PatchPoint& b, const PatchPoint& c) {
      mesh_.addPatch(1, 1, [&](double u, double v) { return v > 0.5 ? c : u > 0.5 ? b : a; });
    };
    const auto corner = [&](std::size_t k) { return point(dark[k], 0.0, sides_[sideOf[k]].normal); };
    const std::vector<std::size_t> triangles = trianglesOf(dark);
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
      addTriangle(corner(triangles[i]), corner(triangles[i + 1]), corner(triangles[i + 2]));
    // A corner with one side farther out than the other: from the last point of the one along it to both.
    for (std::size_t k = 0; k < dark.size(); ++k) {
      const std::size_t next = (k + 1) % dark.size();
      if (sideOf[k] != sideOf[next])
        addTriangle(corner(k), point(dark[next], 0.0, sides_[sideOf[k]].normal), corner(next));
    }
  }

  MeshBuilder& mesh_;
  const std::vector<ShadowSide>& sides_;
  double light_, height_m_, cell_m_;
};

/// Returns the shadow of a disc, of one light after the other, with `leastSectors` or more sectors.
vtkSmartPointer<vtkPolyData> discMesh(double radius_m, double height_m, int leastSectors, double cell_m) {
  const double z = kShadowAboveCloth_m - 0.5 * height_m;
  MeshBuilder shadow;
  const auto addDisc = [&](double light, double outer_m, double inner_m, double outerFade) {
    const int sectors = std::max(leastSectors, cellsFor(2.0 * std::numbers::pi * outer_m, cell_m));
    shadow.addPatch(sectors, std::max(2, cellsFor(outer_m - inner_m, cell_m)), [&](double u, double v) {
      const double angle_rad = 2.0 * std::numbers::pi * u;
      const Vec2 outwards(std::cos(angle_rad), std::sin(angle_rad));
      return PatchPoint{{(outer_m + v * (inner_m - outer_m)) * outwards, z},
                        {(1.0 - v) * outerFade, light, height_m},
                        {outwards, 0.0}};
    });
  };
  addDisc(kHall, radius_m + hallShadowReachOf_m(height_m), 0.95 * radius_m, 1.0);
  addDisc(kHall, 0.95 * radius_m, 0.0, 0.0);
  const double soft_m = shadowSoftOf_m(height_m);
  for (const double lamp : {0.0, 1.0, 2.0}) {
    addDisc(lamp, radius_m + soft_m, radius_m - soft_m, 1.0);
    addDisc(lamp, radius_m - soft_m, 0.0, 0.0);
  }
  return shadow.build();
}

}  // namespace

ScenePart discShadow(double radius_m, double height_m, std::size_t body, double cell_m) {
  constexpr int kSectors = 36, kFewest = 12, kCoarser = 3;
  ScenePart part{.body = body,
                 .mesh = discMesh(radius_m, height_m, kSectors, cell_m),
                 .paint = Paint::shadow,
                 .isRound = true};
  const int finest = std::max(kSectors, cellsFor(2.0 * std::numbers::pi * radius_m, cell_m));
  for (int halvings = 1; halvings <= kCoarser && finest >> halvings >= kFewest; ++halvings) {
    const int sectors = finest >> halvings;
    part.coarser.push_back({discMesh(radius_m, height_m, sectors, kAnyCell_m), 0.0,
                            radius_m * (1.0 - std::cos(std::numbers::pi / sectors))});
  }
  return part;
}

ScenePart outlineShadow(std::span<const Vec2> corners_m, double height_m, std::size_t body, double cell_m) {
  const Outline outline(corners_m);
  MeshBuilder shadow;
  const auto hall = sidesOf(outline, 0.05 * outline.radius(), hallShadowReachOf_m(height_m));
  ShadowOfOne(shadow, hall, kHall, height_m, cell_m).add();
  const double soft_m = shadowSoftOf_m(height_m);
  const std::vector<ShadowSide> sides = sidesOf(outline, soft_m, soft_m);
  for (const double lamp : {0.0, 1.0, 2.0}) ShadowOfOne(shadow, sides, lamp, height_m, cell_m).add();
  return {.body = body, .mesh = shadow.build(), .paint = Paint::shadow};
}

}  // namespace carom
