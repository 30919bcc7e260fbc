// `carom export --spacetime`: the files as other readers see them, and what the person is told.
#include <gtest/gtest.h>

#include <assimp/scene.h>

#include <array>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "app/program.h"
#include "app/temporary_folder.h"

namespace carom {
namespace {

using test::contentOf;
using test::runCarom;
using test::TemporaryFolder;

using Point = std::array<float, 3>;

/// The triangles of a binary STL: 80 bytes, their number, and for each its normal, three corners and two
/// bytes.
struct Stl {
  explicit Stl(const std::string& bytes) {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, 4);
    EXPECT_EQ(bytes.size(), 84 + 50 * std::size_t{count});
    for (std::uint32_t i = 0; i < count; ++i) {
      std::array<Point, 4> facet;
      std::memcpy(facet.data(), bytes.data() + 84 + 50 * std::size_t{i}, sizeof facet);
      facets.push_back(facet);
    }
  }
  std::vector<std::array<Point, 4>> facets;  // normal, corners
};

glm::dvec3 vectorOf(const Point& p) { return {p[0], p[1], p[2]}; }

// What a slicer asks for: every edge is there once in each direction, and normals point to the side from
// which the corners go round anticlockwise.
TEST(ExportSpacetime, StlIsClosedAndOriented) {
  const TemporaryFolder folder;
  for (const std::string scenario : {"two-cushions", "bar-meets-bar", "english"}) {
    SCOPED_TRACE(scenario);
    const auto file = folder / (scenario + ".stl");
    const auto result = runCarom(folder, {"export", scenario, "--spacetime", file, "--until", "5"});
    ASSERT_EQ(result.status, 0) << result.err;
    const Stl stl(contentOf(file));
    std::map<std::pair<Point, Point>, int> edges;
    glm::dvec3 low(1e9), high(-1e9);
    double volume_mm3 = 0.0;
    for (const auto& facet : stl.facets) {
      const glm::dvec3 a = vectorOf(facet[1]), b = vectorOf(facet[2]), c = vectorOf(facet[3]);
      const glm::dvec3 normal = glm::cross(b - a, c - a);
      // A sliver's normal is lost in the rounding of its corners.
      if (glm::length(normal) > 1e-2) {
        ASSERT_GT(glm::dot(normal, vectorOf(facet[0])), 0.9 * glm::length(normal));
      }
      volume_mm3 += glm::dot(a, glm::cross(b, c)) / 6.0;
      for (int k = 0; k < 3; ++k) ++edges[{facet[1 + k], facet[1 + (k + 1) % 3]}];
      low = glm::min(low, glm::min(a, glm::min(b, c)));
      high = glm::max(high, glm::max(a, glm::max(b, c)));
    }
    for (const auto& [edge, times] : edges) ASSERT_EQ(times, (edges[{edge.second, edge.first}]));
    const glm::dvec3 size_mm = high - low;
    EXPECT_NEAR(std::max({size_mm.x, size_mm.y, size_mm.z}), 150.0, 4.0) << "beads may stand out";
    EXPECT_NE(result.err.find(fmt::format("have {:.1f} cm³", volume_mm3 / 1000.0)), std::string::npos)
        << result.err;
  }
}

// The same parts in each format, in its units and axes: time goes up, z in 3MF and y in glTF.
TEST(ExportSpacetime, OtherFormatsHoldTheSameParts) {
  const TemporaryFolder folder;
  std::map<std::string, std::size_t> triangles;
  for (const std::string ending : {".3mf", ".glb"}) {
    const auto file = folder / ("game" + ending);
    const auto result =
        runCarom(folder, {"export", "three-pucks", "--spacetime", file, "--until", "4", "--size", "0.2"});
    ASSERT_EQ(result.status, 0) << result.err;
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(file.string(), 0);
    ASSERT_NE(scene, nullptr) << importer.GetErrorString();
    float least = 1e9F, most = -1e9F;
    std::size_t count = 0;
    std::set<std::string> names;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
      const aiMesh& mesh = *scene->mMeshes[i];
      names.insert(scene->mMaterials[mesh.mMaterialIndex]->GetName().C_Str());
      if (names.contains("cushion")) continue;
      count += mesh.mNumFaces;
    }
    const bool isGlb = ending == ".glb";
    if (isGlb) {
      for (const char* name : {"white", "yellow", "red", "board", "cushion"})
        EXPECT_TRUE(names.contains(name)) << name;
      // The root turns z into y.
      EXPECT_EQ(scene->mRootNode->mTransformation.b3, 1.0F);
    }
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
      for (unsigned k = 0; k < scene->mMeshes[i]->mNumVertices; ++k) {
        least = std::min(least, scene->mMeshes[i]->mVertices[k].z);
        most = std::max(most, scene->mMeshes[i]->mVertices[k].z);
      }
    }
    EXPECT_NEAR(most - least, isGlb ? 0.2F : 200.0F, isGlb ? 0.005F : 5.0F);
    triangles[ending] = count;
  }
  EXPECT_GT(triangles[".3mf"], 1000u);
}

TEST(ExportSpacetime, WhatCannotBeMadeIsSaid) {
  const TemporaryFolder folder;
  const auto says = [&](std::vector<std::string> more, const std::string& words,
                        const std::string& file = "x.glb") {
    std::vector<std::string> arguments{"export", "two-cushions", "--spacetime", folder / file};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto result = runCarom(folder, arguments);
    EXPECT_NE(result.status, 0);
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder / file));
  };
  says({"--velocity", "1", "0", "0"}, "not below the speed of light");
  says({"--from", "0", "--until", "86400"}, "86400 s are too long for a model, expected at most 600 s");
  says({"--from", "5", "--until", "3"}, "nothing lies between");
  says({"--size", "0"}, "a length from 0.01 to 10 m");
  says({}, "no kind of model, expected .glb, .stl or .3mf", "x.obj");
  says({}, "cannot be written", "nowhere/x.glb");
  const auto soft =
      runCarom(folder, {"export", "jellies", "--spacetime", folder / "soft.glb", "--until", "0.5"});
  EXPECT_NE(soft.err.find("soft pucks have no tubes"), std::string::npos) << soft.err;
  const auto many = runCarom(folder, {"export", "gas", "--spacetime", folder / "gas.glb", "--until", "1"});
  EXPECT_NE(many.err.find("Of 200 pucks, the 100 nearest"), std::string::npos) << many.err;
}

}  // namespace
}  // namespace carom
