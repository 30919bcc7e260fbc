// Meshes of soft bodies: their shapes, their gradients, and places in them.
#include "engine/soft/soft_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "engine/random_world.h"

namespace carom {
namespace {

TEST(SoftMesh, HasTheNodesTrianglesAndMassOfItsShape) {
  for (const int cells : {4, 7, 12}) {
    const SoftMesh mesh = softDisc(1.0, cells);
    EXPECT_EQ(mesh.places().size(), 3u * cells * (cells + 1) + 1);
    EXPECT_EQ(mesh.triangles().size(), 6u * cells * cells);
    EXPECT_EQ(mesh.hull().size(), 6u * cells);
  }
  const SoftMesh mesh = softRectangle({0.04, 0.02}, 8);
  EXPECT_EQ(mesh.triangles().size(), 2u * 16 * 8);
  double mass = 0.0;
  glm::dvec2 centre(0.0);
  for (std::size_t i = 0; i < mesh.places().size(); ++i) {
    mass += mesh.nodeShare(i);
    centre += mesh.nodeShare(i) * mesh.places()[i];
  }
  EXPECT_NEAR(mass, 1.0, 1e-14);
  EXPECT_NEAR(glm::length(centre), 0.0, 1e-16);
}

// Each triangle runs anticlockwise, and its gradients are those of its corners' shares: they sum to nothing,
// and Σ x ⊗ gradient is the identity. Together the triangles cover the shape.
TEST(SoftMesh, GradientsAreThoseOfShares) {
  struct Shape {
    SoftMesh mesh;
    double area;
  };
  const double sector = std::numbers::pi / 42.0;  // half the angle of a side of 7 rings
  for (const Shape& shape : {Shape{softDisc(2.0, 7), 42.0 * 4.0 * std::sin(sector) * std::cos(sector)},
                             Shape{softRectangle({0.3, 0.05}, 12), 0.06}}) {
    double area = 0.0;
    std::vector<int> corners(shape.mesh.places().size());
    for (const SoftMesh::Triangle& triangle : shape.mesh.triangles()) {
      glm::dvec2 sum(0.0), alongX(0.0), alongY(0.0);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto node = static_cast<std::size_t>(triangle.nodes[k]);
        const glm::dvec2 place = shape.mesh.places()[node];
        sum += triangle.gradients[k];
        alongX += place.x * triangle.gradients[k];
        alongY += place.y * triangle.gradients[k];
        ++corners[node];
      }
      const glm::dvec2 &one = triangle.gradients[0], &two = triangle.gradients[1];
      const double own = 0.5 / (one.x * two.y - one.y * two.x);
      EXPECT_GT(own, 0.0);
      EXPECT_NEAR(triangle.share, own / shape.area, 1e-12);
      EXPECT_NEAR(glm::length(sum), 0.0, 1e-11);
      EXPECT_NEAR(glm::distance(alongX, glm::dvec2(1.0, 0.0)), 0.0, 1e-12);
      EXPECT_NEAR(glm::distance(alongY, glm::dvec2(0.0, 1.0)), 0.0, 1e-12);
      area += own;
    }
    EXPECT_NEAR(area, shape.area, 1e-12);
    for (std::size_t node = 0; node < corners.size(); ++node) {
      EXPECT_EQ(shape.mesh.cornersOf(node).size(), static_cast<std::size_t>(corners[node]));
      for (const SoftMesh::Corner& corner : shape.mesh.cornersOf(node))
        EXPECT_EQ(shape.mesh.triangles()[static_cast<std::size_t>(corner.triangle)]
                      .nodes[static_cast<std::size_t>(corner.corner)],
                  static_cast<int>(node));
    }
  }
}

TEST(SoftMesh, HullsRunAnticlockwiseAroundAllNodes) {
  for (const SoftMesh& mesh : {softDisc(1.0, 5), softRectangle({0.3, 0.05}, 12)}) {
    const auto place = [&](std::size_t k) {
      return mesh.places()[static_cast<std::size_t>(mesh.hull()[k % mesh.hull().size()])];
    };
    for (std::size_t k = 0; k < mesh.hull().size(); ++k) {
      const glm::dvec2 side = place(k + 1) - place(k);
      for (const glm::dvec2& node : mesh.places()) {
        const glm::dvec2 to = node - place(k);
        EXPECT_GT(side.x * to.y - side.y * to.x, -1e-12) << k;
      }
    }
  }
}

// A place is the mean of three nodes, within the body by shares of at least 0.
TEST(SoftMesh, APlaceIsTheMeanOfItsNodes) {
  test::Random random(42);
  const SoftMesh mesh = softDisc(1.0, 6);
  for (int i = 0; i < 500; ++i) {
    CASE(random, i);
    const double angle = random.in(0.0, 2.0 * std::numbers::pi), radius = std::sqrt(random.in(0.0, 1.0));
    const glm::dvec2 place = radius * glm::dvec2(std::cos(angle), std::sin(angle));
    const SoftMesh::Inside inside = mesh.locate(place);
    glm::dvec2 mean(0.0);
    double sum = 0.0, least = 1.0;
    for (std::size_t k = 0; k < 3; ++k) {
      mean += inside.shares[k] * mesh.places()[inside.nodes[k]];
      sum += inside.shares[k];
      least = std::min(least, inside.shares[k]);
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_NEAR(glm::distance(mean, place), 0.0, 1e-12);
    // The inner radius of a hull of 36 sides.
    const bool isInside = radius < std::cos(std::numbers::pi / 36.0);
    EXPECT_GT(least, isInside ? -1e-12 : -0.05);
  }
}

}  // namespace
}  // namespace carom
