// The light of what rests: against closed forms below a slab, and where a person would look in a hall.
#include "cave/scene/baked_light.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

#include <vtkPointData.h>
#include <glm/geometric.hpp>

#include "cave/mesh/mesh_builder.h"
#include "cave/scene/lit_plates.h"
#include "cave/scene/scene_builder.h"

namespace carom {
namespace {

using test::bytesOf;
using test::plateOver;
using test::slabOver;

constexpr double kReach_m = 3.0, kBounced = 0.25;  // as baked_light.cpp has them

struct Lit {
  std::array<double, 3> lamps{};
  double hall = 0.0;
};

Lit litAt(vtkPolyData& mesh, vtkIdType i) {
  vtkDataArray* const lit = mesh.GetPointData()->GetArray("lit");
  if (!lit) throw std::runtime_error("the mesh is not lit");
  return {{lit->GetComponent(i, 0) / 255.0, lit->GetComponent(i, 1) / 255.0, lit->GetComponent(i, 2) / 255.0},
          lit->GetComponent(i, 3) / 255.0};
}

// A ray at the cosine μ meets a slab at height h after h/μ. Rays are spread by the cosine, their reaches
// evenly up to R: the share that is hidden is ∫ 2μ (1 − h/(R μ)) dμ from h/R to 1, which is (1 − h/R)².
TEST(BakedLight, BelowASlabTheHallIsHiddenAsTheIntegralSays) {
  for (const double height_m : {0.1, 0.75, 1.5, 2.9, 3.5}) {
    Scene scene = slabOver(height_m);
    bakeLight(scene);
    const double near = std::max(0.0, 1.0 - height_m / kReach_m);
    vtkPolyData& mesh = *scene.parts[0].mesh;
    for (vtkIdType i = 0; i < mesh.GetNumberOfPoints(); ++i) {
      const Lit lit = litAt(mesh, i);
      EXPECT_NEAR(lit.hall, kBounced + (1.0 - kBounced) * (1.0 - near * near), 0.03) << height_m;
      EXPECT_EQ(lit.lamps[0], 0.0) << "above the slab";
      EXPECT_EQ(lit.lamps[1], 0.0) << "below the floor";
      EXPECT_EQ(lit.lamps[2], 1.0) << "below the slab";
    }
  }
}

/// The mean light of the points of a paint that a place is in.
Lit meanWhere(const Scene& scene, Paint paint, const std::function<bool(const glm::dvec3&)>& isIn) {
  Lit mean;
  int count = 0;
  for (const ScenePart& part : scene.parts) {
    if (part.body != kRestingBody || part.paint != paint) continue;
    for (vtkIdType i = 0; i < part.mesh->GetNumberOfPoints(); ++i) {
      glm::dvec3 place_m(0.0);
      part.mesh->GetPoint(i, &place_m.x);
      if (!isIn(place_m)) continue;
      const Lit lit = litAt(*part.mesh, i);
      for (std::size_t k = 0; k < 3; ++k) mean.lamps[k] += lit.lamps[k];
      mean.hall += lit.hall;
      ++count;
    }
  }
  EXPECT_GT(count, 0);
  for (double& lamp : mean.lamps) lamp /= count;
  mean.hall /= count;
  return mean;
}

TEST(BakedLight, AHallIsDarkUnderItsTableAndInItsCornersAndTheClothIsLit) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = 1.42;
  setup.board = Board{2.84, 1.42};
  Scene scene = buildScene(setup, {});
  bakeLight(scene);
  const auto near = [](const glm::dvec2& middle, double radius_m) {
    return [=](const glm::dvec3& place_m) { return glm::distance(glm::dvec2(place_m), middle) < radius_m; };
  };
  const Lit under = meanWhere(scene, Paint::floor, near({0.0, 0.0}, 0.4));
  const Lit open = meanWhere(scene, Paint::floor, near({0.0, 2.6}, 0.3));
  const Lit cloth = meanWhere(scene, Paint::cloth, near({0.0, 0.0}, 0.3));
  for (const double lamp : under.lamps) EXPECT_LT(lamp, 0.05) << "the table hides the lamps";
  for (const double lamp : open.lamps) EXPECT_GT(lamp, 0.5);
  for (const double lamp : cloth.lamps) EXPECT_EQ(lamp, 1.0);
  // The cushions' feet touch the cloth, which hides the lower half of the hall and no lamp.
  const Lit feet = meanWhere(scene, Paint::plain, [](const glm::dvec3& place_m) {
    return std::abs(place_m.z) < 1e-6 && std::abs(place_m.x) < 1.421 && std::abs(place_m.y) < 0.711;
  });
  for (const double lamp : feet.lamps) EXPECT_GT(lamp, 0.95);
  EXPECT_NEAR(feet.hall, 0.6, 0.1);
  EXPECT_LT(under.hall, 0.65 * open.hall);
  EXPECT_GT(cloth.hall, 0.9);
  const double floor_m = Hall{}.floor_m;
  const Lit legs = meanWhere(scene, Paint::wood, [=](const glm::dvec3& place_m) {
    return place_m.z < floor_m + 0.2 && place_m.y > 0.5 * setup.board->width_m - 0.05;
  });
  EXPECT_GT(legs.hall, 0.6) << "outer sides of legs see the hall";
  const auto wall = [&](double low_m, double high_m) {
    return meanWhere(scene, Paint::panels, [=](const glm::dvec3& place_m) {
      return place_m.z >= floor_m + low_m && place_m.z <= floor_m + high_m;
    });
  };
  EXPECT_LT(wall(0.0, 0.01).hall, 0.8 * wall(1.5, 2.5).hall) << "along the floor";
}

TEST(BakedLight, IsTheSameEachTime) {
  Scene first = slabOver(0.6), second = slabOver(0.6);
  bakeLight(first);
  bakeLight(second);
  for (vtkIdType i = 0; i < first.parts[0].mesh->GetNumberOfPoints(); ++i) {
    EXPECT_EQ(litAt(*first.parts[0].mesh, i).hall, litAt(*second.parts[0].mesh, i).hall);
    EXPECT_EQ(litAt(*first.parts[0].mesh, i).lamps, litAt(*second.parts[0].mesh, i).lamps);
  }
}

/// FNV-1a, 64 bits.
std::uint64_t digestOf(const std::string& bytes) {
  std::uint64_t digest = 0xcbf29ce484222325U;
  for (const char byte : bytes) digest = (digest ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  return digest;
}

// Nodes of one room may have different processors and Debians, and their walls meet: the light must be the
// same to the byte, with Embree 3 as with Embree 4.
TEST(BakedLight, IsTheSameOnEveryMachine) {
  Scene scene = plateOver(0.75);
  bakeLight(scene);
  EXPECT_EQ(digestOf(bytesOf(*scene.parts[0].mesh)), 12245130188924298777U);
}

}  // namespace
}  // namespace carom
