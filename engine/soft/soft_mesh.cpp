#include "engine/soft/soft_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

#include "engine/base/portable_math.h"

namespace carom {
namespace {

/// The gradients of the three corners' shares: the side opposite to a corner, turned inwards, over twice the
/// area.
SoftMesh::Triangle triangleOf(const std::array<int, 3>& nodes, std::span<const glm::dvec2> places) {
  SoftMesh::Triangle triangle;
  triangle.nodes = nodes;
  const auto place = [&](std::size_t k) { return places[static_cast<std::size_t>(nodes[k % 3])]; };
  const glm::dvec2 first = place(1) - place(0), second = place(2) - place(0);
  const double twiceArea = first.x * second.y - first.y * second.x;
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec2 side = place(k + 2) - place(k + 1);
    triangle.gradients[k] = glm::dvec2(-side.y, side.x) / twiceArea;
    longest = std::max(longest, glm::length(side));
  }
  triangle.share = 0.5 * twiceArea;
  triangle.altitude = twiceArea / longest;
  return triangle;
}

}  // namespace

SoftMesh::SoftMesh(std::vector<glm::dvec2> places, const std::vector<std::array<int, 3>>& triangles,
                   std::vector<int> hull)
    : places_(std::move(places)), hull_(std::move(hull)), nodeShares_(places_.size()) {
  double area = 0.0;
  for (const std::array<int, 3>& nodes : triangles) {
    triangles_.push_back(triangleOf(nodes, places_));
    area += triangles_.back().share;
  }
  std::vector<std::vector<Corner>> corners(places_.size());
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    triangles_[t].share /= area;
    for (int k = 0; k < 3; ++k) {
      const auto node = static_cast<std::size_t>(triangles_[t].nodes[static_cast<std::size_t>(k)]);
      corners[node].push_back({static_cast<int>(t), k});
      nodeShares_[node] += triangles_[t].share / 3.0;
    }
  }
  firstCorner_.push_back(0);
  for (const std::vector<Corner>& ofNode : corners) {
    corners_.insert(corners_.end(), ofNode.begin(), ofNode.end());
    firstCorner_.push_back(corners_.size());
  }
  for (const glm::dvec2& place : places_) reach_m_ = std::max(reach_m_, glm::length(place));
}

SoftMesh::Inside SoftMesh::locate(const glm::dvec2& place) const {
  Inside best;
  double deepest = -std::numeric_limits<double>::infinity();
  for (const Triangle& triangle : triangles_) {
    Inside inside;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      // The share of a corner is 1 there and falls along its gradient.
      inside.nodes[k] = static_cast<std::size_t>(triangle.nodes[k]);
      inside.shares[k] = 1.0 + glm::dot(triangle.gradients[k], place - places_[inside.nodes[k]]);
      least = std::min(least, inside.shares[k]);
    }
    if (least > deepest) deepest = least, best = inside;
  }
  return best;
}

SoftMesh softDisc(double radius_m, int cells) {
  std::vector<glm::dvec2> places{{0.0, 0.0}};
  const auto firstOf = [](int ring) { return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1); };
  for (int ring = 1; ring <= cells; ++ring) {
    for (int j = 0; j < 6 * ring; ++j) {
      const double angle = 2.0 * std::numbers::pi * j / (6 * ring);
      const SinCos turned = portableSinCos(angle);
      places.push_back(radius_m * ring / cells * glm::dvec2(turned.cos, turned.sin));
    }
  }
  std::vector<std::array<int, 3>> triangles;
  for (int ring = 1; ring <= cells; ++ring) {
    const int outer = firstOf(ring), inner = firstOf(ring - 1), count = 6 * ring;
    for (int sixth = 0; sixth < 6; ++sixth) {
      for (int j = 0; j < ring; ++j) {
        const int out = sixth * ring + j, in = sixth * (ring - 1) + j;
        const auto onInner = [&](int k) { return ring == 1 ? 0 : inner + k % (count - 6); };
        triangles.push_back({outer + out, outer + (out + 1) % count, onInner(in)});
        if (j + 1 < ring) triangles.push_back({onInner(in), outer + out + 1, onInner(in + 1)});
      }
    }
  }
  std::vector<int> hull;
  for (int j = 0; j < 6 * cells; ++j) hull.push_back(firstOf(cells) + j);
  return SoftMesh(std::move(places), triangles, std::move(hull));
}

SoftMesh softRectangle(const glm::dvec2& halfExtents_m, int cells) {
  const double edge_m = std::max(halfExtents_m.x, halfExtents_m.y) / cells;
  const auto along = [&](double half_m) {
    return std::max(1, static_cast<int>(std::lround(2.0 * half_m / edge_m)));
  };
  const int columns = along(halfExtents_m.x), rows = along(halfExtents_m.y);
  std::vector<glm::dvec2> places;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column)
      places.push_back(halfExtents_m * glm::dvec2(2.0 * column / columns - 1.0, 2.0 * row / rows - 1.0));
  }
  const auto node = [columns](int column, int row) { return row * (columns + 1) + column; };
  std::vector<std::array<int, 3>> triangles;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      triangles.push_back({node(column, row), node(column + 1, row), node(column + 1, row + 1)});
      triangles.push_back({node(column, row), node(column + 1, row + 1), node(column, row + 1)});
    }
  }
  std::vector<int> hull;
  for (int column = 0; column < columns; ++column) hull.push_back(node(column, 0));
  for (int row = 0; row < rows; ++row) hull.push_back(node(columns, row));
  for (int column = columns; column > 0; --column) hull.push_back(node(column, rows));
  for (int row = rows; row > 0; --row) hull.push_back(node(0, row));
  return SoftMesh(std::move(places), triangles, std::move(hull));
}

}  // namespace carom
