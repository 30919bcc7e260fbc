#pragma once
// The triangles of a soft body at rest: a disc of rings, or a rectangle of squares. Metres, from the body's
// centre.
// Theory: app/doc/physics.md, Soft bodies.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace carom {

inline constexpr int kFewestSoftCells = 4;
inline constexpr int kMostSoftCells = 40;

/// A mesh of relaxed matter of even density. Triangles and their corners run anticlockwise.
class SoftMesh {
 public:
  /// The gradient of a corner's share in its triangle, constant there: F = Σ x_i ⊗ gradient_i.
  struct Triangle {
    std::array<int, 3> nodes{};
    std::array<glm::dvec2, 3> gradients{};
    double share = 0.0;     ///< of the body's mass
    double altitude = 0.0;  ///< the least of the three
  };
  /// A corner of a triangle, in the list of its node.
  struct Corner {
    int triangle = 0;
    int corner = 0;
  };

  /// Makes a mesh of these places and triangles, whose outermost nodes are `hull`, anticlockwise.
  SoftMesh(std::vector<glm::dvec2> places, const std::vector<std::array<int, 3>>& triangles,
           std::vector<int> hull);

  std::span<const glm::dvec2> places() const { return places_; }
  std::span<const Triangle> triangles() const { return triangles_; }
  std::span<const int> hull() const { return hull_; }
  /// The corners that meet at a node, in the order of the triangles.
  std::span<const Corner> cornersOf(std::size_t node) const {
    return std::span(corners_).subspan(firstCorner_[node], firstCorner_[node + 1] - firstCorner_[node]);
  }
  double nodeShare(std::size_t node) const { return nodeShares_[node]; }  ///< of the body's mass
  /// A place of the relaxed body as the mean of three nodes, by shares that sum to 1.
  struct Inside {
    std::array<std::size_t, 3> nodes{};
    std::array<double, 3> shares{};
  };
  /// Returns where a place is; one between the hull and the round rim belongs to the nearest triangle.
  Inside locate(const glm::dvec2& place) const;
  double reach_m() const { return reach_m_; }  ///< of the farthest node

 private:
  std::vector<glm::dvec2> places_;
  std::vector<Triangle> triangles_;
  std::vector<int> hull_;
  std::vector<std::size_t> firstCorner_;
  std::vector<Corner> corners_;
  std::vector<double> nodeShares_;
  double reach_m_ = 0.0;
};

/// Returns a disc: a centre and `cells` rings; ring k has 6 k nodes. In all 6 cells² triangles.
SoftMesh softDisc(double radius_m, int cells);

/// Returns a rectangle around the origin: squares with `cells` of them along the longer half extent, and all
/// diagonals the same way: alternating ones would give neighbours of mass ratio 2 under equal forces.
SoftMesh softRectangle(const glm::dvec2& halfExtents_m, int cells);

}  // namespace carom
