#pragma once
// The further files that a mesh file refers to.

#include <filesystem>
#include <string_view>
#include <vector>

namespace carom {

/// Returns the paths of the buffers and pictures that a .gltf or .glb with this `content` names (glTF 2.0,
/// sections 5.10 and 5.20): beside the mesh, in its order. Returns none for other meshes and for files that
/// are not glTF.
std::vector<std::filesystem::path> meshParts(const std::filesystem::path& mesh, std::string_view content);

/// Checks that each of these files may be read: that it lies below the mesh's folder and that
/// InputKind::meshPart allows it, whether the mesh uses it or not; and that the content is not nested deeper
/// than any glTF is, since its reader recurses. Throws InputError.
void checkMeshParts(const std::filesystem::path& mesh, std::string_view content);

}  // namespace carom
