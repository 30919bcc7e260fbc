// Models of soft pucks and of told bodies: closed surfaces of the right volume, and their shadows.
#include "cave/scene/soft_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "cave/scene/shadow_model.h"

namespace carom {
namespace {

using Place = std::array<float, 3>;

Place placeOf(const SoftModel& model, std::uint32_t vertex) {
  const glm::vec3& place_m = model.painted.at(vertex).place_m;
  return {place_m.x, place_m.y, place_m.z};
}

/// Expects that each edge of the surface is run along once each way.
void expectClosed(const SoftModel& model) {
  std::map<std::pair<Place, Place>, int> edges;
  for (std::size_t k = 0; k < model.surface.size(); ++k) {
    const std::size_t next = k % 3 == 2 ? k - 2 : k + 1;
    ++edges[{placeOf(model, model.surface[k]), placeOf(model, model.surface[next])}];
  }
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1);
    ASSERT_EQ(edges.count({edge.second, edge.first}), 1U);
  }
}

double volume_m3(const SoftModel& model) {
  double sixfold = 0.0;
  for (std::size_t k = 0; k < model.surface.size(); k += 3) {
    const auto corner = [&](std::size_t i) {
      return glm::dvec3(model.painted[model.surface[k + i]].place_m);
    };
    sixfold += glm::dot(corner(0), glm::cross(corner(1), corner(2)));
  }
  return sixfold / 6.0;
}

TEST(SoftModel, IsThePrismOverItsMesh) {
  constexpr double kHeight_m = 0.02, kRadius_m = 0.03;
  for (const int cells : {4, 7}) {
    const SoftMesh mesh = softDisc(kRadius_m, cells);
    const SoftModel model = softModel(mesh, true, kHeight_m, 3, {1.0F, 0.5F, 0.0F});
    EXPECT_EQ(model.body, 3U);
    EXPECT_FALSE(model.told);
    expectClosed(model);
    const double half = std::numbers::pi / (6.0 * cells),
                 area_m2 = 6.0 * cells * kRadius_m * kRadius_m * std::sin(half) * std::cos(half);
    EXPECT_NEAR(volume_m3(model), area_m2 * kHeight_m, 1e-5 * area_m2 * kHeight_m);
    EXPECT_NEAR(model.reach_m(), std::hypot(kRadius_m, 0.5 * kHeight_m), 1e-9);
  }
  const SoftModel bar = softModel(softRectangle({0.06, 0.01}, 12), false, kHeight_m, 1, {});
  expectClosed(bar);
  EXPECT_NEAR(volume_m3(bar), 0.12 * 0.02 * kHeight_m, 1e-9);
}

// Each light's shadow is a soft ring across the rim and the dark within, on the cloth.
TEST(SoftModel, ShadowsReachAsFarAsThoseOfRigidDiscs) {
  constexpr double kHeight_m = 0.02, kRadius_m = 0.03;
  const SoftModel model = softModel(softDisc(kRadius_m, 5), true, kHeight_m, 1, {});
  std::array<double, kShadowLights> most{};
  for (const std::uint32_t index : model.shadow) {
    const SoftModel::Vertex& vertex = model.vertices.at(index);
    const glm::vec3& surface = model.painted.at(index).surface;
    EXPECT_EQ(surface.x, vertex.reach > 1.0F ? 1.0F : 0.0F) << "no shadow beyond its border";
    EXPECT_EQ(surface.z, static_cast<float>(kHeight_m));
    double& reach = most.at(static_cast<std::size_t>(surface.y));
    reach = std::max(reach, static_cast<double>(vertex.reach));
    EXPECT_NEAR(model.points.at(vertex.point).z_m, kShadowAboveCloth_m - 0.5 * kHeight_m, 1e-8);
    EXPECT_EQ(model.points.at(vertex.middle).node, 0U) << "the middle of the disc";
  }
  for (int light = 0; light < kShadowLights; ++light) {
    const double out_m = light == kShadowOfHall ? hallShadowReachOf_m(kHeight_m) : shadowSoftOf_m(kHeight_m);
    EXPECT_NEAR(most[static_cast<std::size_t>(light)], 1.0 + out_m / kRadius_m, 1e-6) << light;
  }
}

TEST(SoftModel, ToldBodiesAreTheirTrianglesOrTheirPoints) {
  const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  std::vector<Vec3> rows = square;
  rows.insert(rows.end(), square.begin(), square.end());
  const SampledHistory history(1.0, {0.0, 1.0}, rows);
  const SoftModel mesh =
      toldModel(std::make_shared<ToldShape>(ToldShape{history, {{0, 1, 2}, {0, 2, 3}}}), {0.5F, 0.5F, 0.5F});
  EXPECT_EQ(mesh.vertices.size(), 4U);
  EXPECT_EQ(mesh.surface, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  const SoftModel points = toldModel(std::make_shared<ToldShape>(ToldShape{history}), {});
  ASSERT_EQ(points.points.size(), 4U);
  // Each is an octahedron around its point: 4/3 of the half diagonal's cube.
  double half_m = 0.0;
  for (const MeshVertex& vertex : points.painted)
    half_m = std::max(half_m, static_cast<double>(glm::length(vertex.place_m)));
  EXPECT_GT(half_m, 0.0);
  EXPECT_NEAR(volume_m3(points), 4.0 * 4.0 / 3.0 * half_m * half_m * half_m, 1e-9 * half_m);
  EXPECT_EQ(points.surface.size(), 4U * 8U * 3U);
}

}  // namespace
}  // namespace carom
