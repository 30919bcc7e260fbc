#pragma once
// The further files that a mesh file refers to.

#include <filesystem>
#include <string_view>
#include <vector>

namespace carom {

/// Returns the paths of the buffers that a .gltf or .glb with this `content` names (glTF 2.0, section 5.10):
/// beside the mesh, in its order. Returns none for other meshes and for files that are not glTF.
std::vector<std::filesystem::path> meshBuffers(const std::filesystem::path& mesh, std::string_view content);

}  // namespace carom
