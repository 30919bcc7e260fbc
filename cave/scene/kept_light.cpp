#include "cave/scene/kept_light.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "cave/scene/baked_light.h"
#include "engine/base/xxh3.h"
#include "engine/text/whole_file.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostKept = 16;

constexpr std::size_t kDigits = 16;  // of a digest in hexadecimal digits

/// Digests values one after the other.
class LightDigest {
 public:
  LightDigest() : state_(XXH3_createState(), XXH3_freeState) { XXH3_64bits_reset(state_.get()); }

  template <typename T>
  requires std::is_trivially_copyable_v<T>
  void add(const T& value) { XXH3_64bits_update(state_.get(), &value, sizeof value); }
  void add(std::string_view bytes) { XXH3_64bits_update(state_.get(), bytes.data(), bytes.size()); }
  void add(vtkDataArray* array) {
    const auto bytes = static_cast<std::size_t>(array->GetNumberOfValues() * array->GetDataTypeSize());
    add(bytes);
    add(std::string_view(static_cast<const char*>(array->GetVoidPointer(0)), bytes));
  }
  std::string digits() const { return fmt::format("{:016x}", XXH3_64bits_digest(state_.get())); }

 private:
  std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state_;
};

/// Returns a digest of all that a scene's light depends on: lit surfaces, occluders, lamps.
std::string digestOf(const Scene& scene) {
  LightDigest digest;
  for (const glm::dvec3& lamp_m : scene.lamps_m) digest.add(lamp_m);
  for (const ScenePart& part : scene.casters) {
    digest.add(part.paint);
    digest.add(part.mesh->GetPoints()->GetData());
    digest.add(part.mesh->GetPolys()->GetConnectivityArray());
  }
  for (const ScenePart& part : scene.parts) {
    if (!isLit(part)) continue;
    digest.add(part.mesh->GetPoints()->GetData());
    digest.add(part.mesh->GetPointData()->GetNormals());
  }
  return digest.digits();
}

std::string digestOf(std::string_view bytes) {
  LightDigest digest;
  digest.add(bytes);
  return digest.digits();
}

/// Returns the file that keeps what this program has baked for a scene.
fs::path fileOf(const Scene& scene, const fs::path& folder) {
  const fs::path program = "/proc/self/exe";
  LightDigest digest;
  digest.add(fs::file_size(program));
  digest.add(fs::last_write_time(program).time_since_epoch().count());
  return folder / (digestOf(scene) + digest.digits());
}

/// Returns what a file keeps, which follows its own digest. Empty if the file is not whole.
std::string contentOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string all{std::istreambuf_iterator<char>(in), {}};
  const std::string content = all.size() > kDigits ? all.substr(kDigits) : "";
  return all.starts_with(digestOf(content)) ? content : "";
}

/// Removes all files of the folder but those that were used last.
void forgetOldest(const fs::path& folder) {
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    files.emplace_back(entry.last_write_time(), entry.path());
  std::sort(files.rbegin(), files.rend());
  for (std::size_t i = kMostKept; i < files.size(); ++i) fs::remove(files[i].second);
}

}  // namespace

std::string lightOf(const Scene& scene) {
  std::string light = digestOf(scene);
  for (const ScenePart& part : scene.parts) {
    if (!isLit(part)) continue;
    vtkDataArray* const lit = part.mesh->GetPointData()->GetArray("lit");
    light.append(static_cast<const char*>(lit->GetVoidPointer(0)),
                 static_cast<std::size_t>(lit->GetNumberOfValues()));
  }
  return light;
}

bool setLight(Scene& scene, std::string_view light) {
  std::size_t points = 0;
  for (const ScenePart& part : scene.parts) {
    if (isLit(part)) points += static_cast<std::size_t>(part.mesh->GetNumberOfPoints());
  }
  if (light.size() != kDigits + 4 * points || !light.starts_with(digestOf(scene))) return false;
  light.remove_prefix(kDigits);
  for (const ScenePart& part : scene.parts) {
    if (!isLit(part)) continue;
    const std::span<std::uint8_t> lit = addLit(*part.mesh);
    std::memcpy(lit.data(), light.data(), lit.size());
    light.remove_prefix(lit.size());
  }
  return true;
}

void lightScene(Scene& scene, const fs::path& folder) {
  if (folder.empty()) return bakeLight(scene);
  const fs::path file = fileOf(scene, folder);
  std::error_code failed;
  if (setLight(scene, contentOf(file))) {
    fs::last_write_time(file, fs::file_time_type::clock::now(), failed);
    return;
  }
  bakeLight(scene);
  try {
    fs::create_directories(folder);
    const std::string light = lightOf(scene);
    WholeFile(file).commit(digestOf(light) + light);
    forgetOldest(folder);
  } catch (const std::runtime_error&) {  // nothing is kept
  }
}

fs::path folderOfLight() {
  const char *const cache = std::getenv("XDG_CACHE_HOME"), *const home = std::getenv("HOME");
  if (cache && *cache == '/') return fs::path(cache) / "carom" / "light";
  return home && *home == '/' ? fs::path(home) / ".cache" / "carom" / "light" : fs::path();
}

}  // namespace carom
