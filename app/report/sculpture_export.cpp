// Part of the library that is loaded when a sculpture is written: meshes by assimp.
#include "app/report/sculpture_export.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <assimp/Exporter.hpp>
#include <memory>
#include <string>

#include <glm/geometric.hpp>

namespace carom {
namespace {

aiMaterial* materialOf(const SculpturePart& part, const SculptureLook& look) {
  auto material = std::make_unique<aiMaterial>();
  const aiString name(part.name);
  material->AddProperty(&name, AI_MATKEY_NAME);
  const aiColor4D colour(look.colour.r, look.colour.g, look.colour.b, look.opacity);
  material->AddProperty(&colour, 1, AI_MATKEY_BASE_COLOR);
  material->AddProperty(&colour, 1, AI_MATKEY_COLOR_DIFFUSE);
  const float metallic = 0.0F;
  material->AddProperty(&metallic, 1, AI_MATKEY_METALLIC_FACTOR);
  material->AddProperty(&look.roughness, 1, AI_MATKEY_ROUGHNESS_FACTOR);
  const bool isGlass = look.opacity < 1.0F;
  const aiString alpha(isGlass ? "BLEND" : "OPAQUE");
  material->AddProperty(&alpha, AI_MATKEY_GLTF_ALPHAMODE);
  const int twoSided = isGlass ? 1 : 0;
  material->AddProperty(&twoSided, 1, AI_MATKEY_TWOSIDED);
  return material.release();
}

aiVector3D vectorOf(const Vec3& v) {
  const glm::vec3 rounded(v);
  return {rounded.x, rounded.y, rounded.z};
}

/// Returns the mesh of a part. With `facets`, each triangle has its own corners, with its normal: what STL
/// holds.
aiMesh* meshOf(const SolidMesh& solid, const std::string& name, unsigned material, double scale,
               bool facets) {
  auto mesh = std::make_unique<aiMesh>();
  mesh->mName = name;
  mesh->mMaterialIndex = material;
  mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  mesh->mNumFaces = static_cast<unsigned>(solid.triangles.size());
  mesh->mFaces = new aiFace[mesh->mNumFaces];
  mesh->mNumVertices = facets ? 3 * mesh->mNumFaces : static_cast<unsigned>(solid.points.size());
  mesh->mVertices = new aiVector3D[mesh->mNumVertices];
  if (facets) mesh->mNormals = new aiVector3D[mesh->mNumVertices];
  for (unsigned i = 0; !facets && i < mesh->mNumVertices; ++i)
    mesh->mVertices[i] = vectorOf(solid.points[i] * scale);
  for (unsigned i = 0; i < mesh->mNumFaces; ++i) {
    const auto& [a, b, c] = solid.triangles[i];
    mesh->mFaces[i].mNumIndices = 3;
    mesh->mFaces[i].mIndices =
        facets ? new unsigned[3]{3 * i, 3 * i + 1, 3 * i + 2} : new unsigned[3]{a, b, c};
    if (!facets) continue;
    const Vec3 from = solid.points[a];
    const Vec3 normal = glm::normalize(glm::cross(solid.points[b] - from, solid.points[c] - from));
    for (unsigned corner = 0; corner < 3; ++corner) {
      mesh->mVertices[3 * i + corner] = vectorOf(solid.points[solid.triangles[i][corner]] * scale);
      mesh->mNormals[3 * i + corner] = vectorOf(normal);
    }
  }
  return mesh.release();
}

/// Returns a scene with one node, mesh and material for each part, under a root that turns z upwards into the
/// format's axes.
std::unique_ptr<aiScene> sceneOf(const GameSculpture& sculpture, std::span<const SculptureLook> looks,
                                 const SculptureFormat& format) {
  auto scene = std::make_unique<aiScene>();
  const auto count = static_cast<unsigned>(sculpture.parts.size());
  const double scale = sculpture.scale * (format.forPrinters ? 1000.0 : 1.0);
  scene->mNumMeshes = scene->mNumMaterials = count;
  scene->mMeshes = new aiMesh*[count];
  scene->mMaterials = new aiMaterial*[count];
  scene->mRootNode = new aiNode("spacetime");
  if (!format.forPrinters)
    scene->mRootNode->mTransformation = aiMatrix4x4(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1);
  std::unique_ptr<aiNode*[]> nodes(new aiNode*[count]);
  for (unsigned i = 0; i < count; ++i) {
    scene->mMaterials[i] = materialOf(sculpture.parts[i], looks[i]);
    scene->mMeshes[i] = meshOf(sculpture.parts[i].solid, sculpture.parts[i].name, i, scale, format.facets);
    nodes[i] = new aiNode(sculpture.parts[i].name);
    nodes[i]->mNumMeshes = 1;
    nodes[i]->mMeshes = new unsigned[1]{i};
  }
  scene->mRootNode->addChildren(count, nodes.get());
  return scene;
}

}  // namespace

bool exportSculpture(const GameSculpture& sculpture, std::span<const SculptureLook> looks,
                     const SculptureFormat& format, const std::string& file) {
  const std::unique_ptr<aiScene> scene = sceneOf(sculpture, looks, format);
  return Assimp::Exporter().Export(scene.get(), format.id, file) == aiReturn_SUCCESS;
}

}  // namespace carom
