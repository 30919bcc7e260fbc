#pragma once
// The files that a mesh file needs beside itself.

#include <filesystem>
#include <string_view>
#include <vector>

namespace carom {

/// Of a .gltf or .glb with this `content`: the buffers it names (glTF 2.0, section 5.10), beside it, in its
/// order; of other meshes, none. A file that is no glTF has none either.
std::vector<std::filesystem::path> meshBuffers(const std::filesystem::path& mesh, std::string_view content);

}  // namespace carom
