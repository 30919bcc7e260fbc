#include "app/file_keys/language_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

namespace carom {
namespace {

bool isCode(std::string_view name) {
  const auto isPlain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  };
  return !name.empty() && name.size() <= kMostCodeLetters && std::all_of(name.begin(), name.end(), isPlain);
}

}  // namespace

std::string languageNamed(const std::string& name, const std::filesystem::path& folder) {
  if (!isPoFile(name)) return name;
  return std::filesystem::absolute(folder / name).lexically_normal().string();
}

std::string refusalOfLanguage(const std::string& name) {
  if (isPoFile(name)) {
    std::error_code failed;
    if (std::filesystem::is_regular_file(name, failed)) return {};
    return fmt::format("there is no file '{}', expected a PO file with the texts of a language", name);
  }
  if (isCode(name)) return {};
  return fmt::format(
      "'{}' is no language, expected a code of at most {} letters, digits, - and _, such as fr, or a PO file",
      name, kMostCodeLetters);
}

}  // namespace carom
