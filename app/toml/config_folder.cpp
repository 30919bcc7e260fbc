#include "app/toml/config_folder.h"

#include <algorithm>
#include <system_error>

namespace carom {

const std::filesystem::path& configFolder() {
  static const std::filesystem::path folder = [] {
    std::error_code failed;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", failed);
    const std::filesystem::path installed = program.parent_path().parent_path() / "share/carom";
    return !failed && std::filesystem::is_directory(installed, failed)
               ? installed
               : std::filesystem::path(CAROM_CONFIG_DIR);
  }();
  return folder;
}

std::filesystem::path shippedFile(const std::filesystem::path& given, std::string_view kind) {
  std::error_code failed;
  if (given.has_parent_path() || given.has_extension() || std::filesystem::is_regular_file(given, failed))
    return given;
  for (const auto& entry : std::filesystem::directory_iterator(configFolder() / kind, failed)) {
    if (entry.path().stem() == given) return entry.path();
  }
  return given;
}

std::vector<std::string> shippedNames(std::string_view kind) {
  std::vector<std::string> names;
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator(configFolder() / kind, failed))
    names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code failed;
  return a == b || std::filesystem::equivalent(a, b, failed);
}

}  // namespace carom
