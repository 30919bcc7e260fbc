#include "cave/mesh_input/mesh_size.h"

#include <charconv>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

#include "cave/mesh_input/mesh_words.h"
#include "engine/text/outside_file.h"

namespace carom {
namespace {

constexpr std::size_t kStlHeader = 84, kBlock = 1U << 20U;

std::optional<std::uint64_t> facesOfPly(std::string_view header) {
  constexpr std::string_view kFaces = "\nelement face ";
  const std::size_t at = header.find(kFaces);
  if (at == std::string_view::npos || header.find("\nend_header") < at) return {};
  std::uint64_t faces = 0;
  const char* const begin = header.data() + at + kFaces.size();
  const auto [stop, failed] = std::from_chars(begin, header.data() + header.size(), faces);
  if (failed != std::errc()) return {};
  return faces;
}

/// Counts the lines whose first word is `keyword`, block by block.
std::uint64_t linesWith(std::string_view keyword, const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<char> block(kBlock);
  std::uint64_t count = 0;
  std::size_t matched = 0;  // letters of the keyword that this line has begun with
  bool isAtStart = true;
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(file.gcount()); ++i) {
      const char c = block[i];
      if (c == '\n') {
        isAtStart = true;
        matched = 0;
      } else if (isAtStart && matched < keyword.size() && c == keyword[matched]) {
        ++matched;
      } else if (isAtStart && (matched > 0 || (c != ' ' && c != '\t'))) {
        count += matched == keyword.size() && (c == ' ' || c == '\t' || c == '\r') ? 1 : 0;
        isAtStart = false;
      }
    }
  }
  return count;
}

}  // namespace

std::optional<std::uint64_t> facesIn(const std::string& path) {
  if (!refusalOf(path, InputKind::mesh).empty()) return {};
  const std::string beginning = beginningOf(path, InputKind::mesh, kBlock);
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".ply") return facesOfPly(beginning);
  if (ending == ".obj") return linesWith("f", path);
  if (ending != ".stl" || beginning.size() < kStlHeader) return {};
  const std::uint64_t faces = numberAt<std::uint32_t>(beginning, kStlHeader - sizeof(std::uint32_t));
  std::error_code failed;
  constexpr std::uint64_t kTriangle = 50;
  if (std::filesystem::file_size(path, failed) == kStlHeader + kTriangle * faces) return faces;
  return linesWith("facet", path);
}

}  // namespace carom
