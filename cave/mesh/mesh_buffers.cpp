#include "cave/mesh/mesh_buffers.h"

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>

namespace carom {
namespace {

/// Returns the JSON of a glTF; in a .glb it is the first chunk (glTF 2.0, section 4.4: after a header of 12
/// bytes come its length, its type and its content).
std::string_view jsonOf(std::string_view content) {
  constexpr std::size_t kLengthAt = 12, kJsonAt = 20;
  if (!content.starts_with("glTF")) return content;
  if (content.size() < kJsonAt) return {};
  std::uint32_t length = 0;
  std::memcpy(&length, content.data() + kLengthAt, sizeof length);
  return content.substr(kJsonAt, length);
}

}  // namespace

std::vector<std::filesystem::path> meshBuffers(const std::filesystem::path& mesh, std::string_view content) {
  if (mesh.extension() != ".gltf" && mesh.extension() != ".glb") return {};
  const nlohmann::json gltf = nlohmann::json::parse(jsonOf(content), nullptr, false);
  std::vector<std::filesystem::path> files;
  if (!gltf.is_object() || !gltf.contains("buffers") || !gltf["buffers"].is_array()) return files;
  for (const nlohmann::json& buffer : gltf["buffers"]) {
    if (!buffer.is_object() || !buffer.contains("uri") || !buffer["uri"].is_string()) continue;
    const auto uri = buffer["uri"].get<std::string>();
    if (!uri.starts_with("data:")) files.push_back(mesh.parent_path() / uri);
  }
  return files;
}

}  // namespace carom
