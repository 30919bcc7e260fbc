// The light of what rests: against closed forms below a slab, and where a person would look in a hall.
#include "cave/scene/baked_light.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include <vtkPointData.h>
#include <glm/geometric.hpp>

#include "cave/mesh/mesh_builder.h"
#include "cave/scene/kept_light.h"
#include "cave/scene/scene_builder.h"

namespace carom {
namespace {

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

/// A floor with a wide slab above it, and lamps above that, but the last one below it.
Scene slabOver(double height_m) {
  MeshBuilder floor, slab;
  floor.addFlat({-1.0, -1.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, 0.5);
  slab.addFlat({-100.0, -100.0, height_m}, {200.0, 0.0, 0.0}, {0.0, 200.0, 0.0}, 100.0);
  Scene scene;
  scene.parts = {{kRestingBody, floor.build(), Paint::floor}};
  scene.casters = {{kRestingBody, slab.build(), Paint::plain}};
  scene.lamps_m = {glm::dvec3(0.0, 0.0, 2.0 * height_m), glm::dvec3(0.0, 0.0, -1.0),
                   glm::dvec3(0.0, 0.0, 0.5 * height_m)};
  return scene;
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

std::string bytesOf(vtkPolyData& mesh) {
  vtkDataArray* const lit = mesh.GetPointData()->GetArray("lit");
  if (!lit) return "the mesh is not lit";
  return {static_cast<const char*>(lit->GetVoidPointer(0)),
          static_cast<std::size_t>(lit->GetNumberOfValues())};
}

/// A floor in the shadow of a square plate that hides a part of the hall and of each lamp from it.
Scene plateOver(double height_m) {
  Scene scene = slabOver(height_m);
  MeshBuilder floor, plate;
  floor.addFlat({-1.0, -1.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, 0.03);
  plate.addFlat({-0.5, -0.4, height_m}, {1.0, 0.0, 0.0}, {0.0, 0.8, 0.0}, 1.0);
  scene.parts = {{kRestingBody, floor.build(), Paint::floor}};
  scene.casters = {{kRestingBody, plate.build(), Paint::plain}};
  scene.lamps_m = {glm::dvec3(0.0, 0.0, 1.9), glm::dvec3(0.4, 0.1, 1.7), glm::dvec3(-0.7, 0.3, 2.1)};
  return scene;
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

/// A folder for kept light, gone with the test.
struct LightFolder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("carom-light-test-" + std::to_string(getpid()));
  ~LightFolder() { std::filesystem::remove_all(path); }

  std::vector<std::filesystem::path> files() const {
    std::vector<std::filesystem::path> all;
    for (const auto& entry : std::filesystem::directory_iterator(path)) all.push_back(entry.path());
    return all;
  }
};

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

ino_t numberOf(const std::filesystem::path& file) {
  struct stat state {};
  stat(file.c_str(), &state);
  return state.st_ino;
}

TEST(KeptLight, IsThatWhichWasBakedAndIsBakedOnce) {
  const LightFolder folder;
  Scene baked = plateOver(0.75), first = plateOver(0.75), again = plateOver(0.75), other = plateOver(0.76);
  bakeLight(baked);
  lightScene(first, folder.path);
  ASSERT_EQ(folder.files().size(), 1U);
  const std::filesystem::path file = folder.files().front();
  const ino_t number = numberOf(file);
  lightScene(again, folder.path);
  EXPECT_EQ(numberOf(file), number) << "it was baked and written again";
  EXPECT_EQ(bytesOf(*first.parts[0].mesh), bytesOf(*baked.parts[0].mesh));
  EXPECT_EQ(bytesOf(*again.parts[0].mesh), bytesOf(*baked.parts[0].mesh));
  lightScene(other, folder.path);
  EXPECT_EQ(folder.files().size(), 2U) << "another scene has other light";
  EXPECT_NE(bytesOf(*other.parts[0].mesh), bytesOf(*baked.parts[0].mesh));
}

TEST(KeptLight, IsHandedToTheSameSceneOnly) {
  Scene first = plateOver(0.75), same = plateOver(0.75), other = plateOver(0.76), coarser = slabOver(0.75);
  bakeLight(first);
  const std::string light = lightOf(first);
  EXPECT_TRUE(setLight(same, light));
  EXPECT_EQ(bytesOf(*same.parts[0].mesh), bytesOf(*first.parts[0].mesh));
  EXPECT_FALSE(setLight(other, light));
  EXPECT_FALSE(setLight(coarser, light));
  for (const std::string& wrong : {std::string(), std::string("x"), light + "x", light.substr(1)})
    EXPECT_FALSE(setLight(same, wrong)) << wrong.size() << " bytes";
}

TEST(KeptLight, ThatIsNotWholeIsBakedAnew) {
  const LightFolder folder;
  Scene baked = plateOver(0.75);
  lightScene(baked, folder.path);
  const std::filesystem::path file = folder.files().front();
  const std::string whole = contentOf(file);
  std::string changed = whole;
  changed.back() ^= 1;
  for (const std::string& bytes : {std::string(), std::string("junk"), whole.substr(0, 16),
                                   whole.substr(0, 1000), whole + "x", changed}) {
    std::ofstream(file, std::ios::binary) << bytes;
    Scene scene = plateOver(0.75);
    lightScene(scene, folder.path);
    EXPECT_EQ(bytesOf(*scene.parts[0].mesh), bytesOf(*baked.parts[0].mesh)) << bytes.size() << " bytes";
    EXPECT_EQ(contentOf(file), whole) << bytes.size() << " bytes";
  }
}

TEST(KeptLight, IsOfSixteenScenesAndNeedsNoFolder) {
  const LightFolder folder;
  for (int i = 0; i < 18; ++i) {
    Scene scene = slabOver(0.5 + 0.01 * i);
    lightScene(scene, folder.path);
  }
  EXPECT_EQ(folder.files().size(), 16U);
  for (const char* nowhere : {"", "/proc/carom-light"}) {
    Scene scene = plateOver(0.75);
    lightScene(scene, nowhere);
    EXPECT_EQ(bytesOf(*scene.parts[0].mesh).size(),
              4U * static_cast<std::size_t>(scene.parts[0].mesh->GetNumberOfPoints()));
  }
}

}  // namespace
}  // namespace carom
