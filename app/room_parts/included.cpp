#include "app/room_parts/included.h"

#include <fmt/format.h>

#include <utility>

#include "app/room_checks/foreign_room.h"
#include "engine/text/outside_file.h"

namespace carom {
namespace {

constexpr std::size_t kMostFiles = 32;

/// Gives a part and all below one place, that of the element in the file that the person has named.
void putAt(Part& part, FilePlace at) {
  part.at = part.textAt = at;
  for (Part& child : part.parts) putAt(child, at);
}

}  // namespace

void Included::expand(Part& root, const std::set<std::filesystem::path>& open) {
  std::vector<Part> parts;
  for (Part& part : root.parts) {
    if (!alike(part.name, element_)) {
      parts.push_back(std::move(part));
      continue;
    }
    const std::filesystem::path named = part.text.empty() ? part.textOf("file") : part.text;
    const std::filesystem::path folder = file_.has_parent_path() ? file_.parent_path() : ".";
    const std::filesystem::path path = folder / named;
    const std::string shown = printable(named.string());
    if (named.empty() || named.is_absolute() || !std::filesystem::is_regular_file(path) ||
        !liesBelow(path, folder)) {
      addWarning(room_, part.at,
                 fmt::format("the included file '{}' is not beside this one: it is left out", shown));
      continue;
    }
    std::set<std::filesystem::path> within;
    bool isOpen = false;
    for (const std::filesystem::path& other : open) {
      isOpen = isOpen || std::filesystem::equivalent(other, path);
      within.insert(other);
    }
    if (isOpen || ++files_ > kMostFiles) {
      throw InputErrors(
          {InputError(file_.string(), part.at.line, part.at.column,
                      isOpen ? fmt::format("the file '{}' includes itself, expected another", shown)
                             : fmt::format("there are more than {} included files", kMostFiles))});
    }
    within.insert(path);
    Part included = partOf(readXml(path, Doctype::outside).root);
    room_.assumptions.push_back(
        fmt::format("the included file '{}' is read with it, line {}", shown, part.at.line));
    putAt(included, part.at);
    expand(included, within);
    for (Part& child : included.parts) parts.push_back(std::move(child));
  }
  root.parts = std::move(parts);
}

}  // namespace carom
