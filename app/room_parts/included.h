#pragma once
// Files that a room file names to be read with it.

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "app/room_checks/room.h"
#include "app/room_parts/part.h"

namespace carom {

/// Reads the XML files that a room file includes, those that they include, and so on. A file beside the room
/// file is read; one that is elsewhere or missing is named and left out.
class Included {
 public:
  Included(const std::filesystem::path& file, std::string_view element, Room& room)
      : file_(file), element_(element), room_(room) {}

  /// Replaces each including element by the parts of its file, which get the place of that element. Throws
  /// InputErrors if a file includes itself, also through others, or cannot be read.
  void expand(Part& root) { expand(root, {file_}); }

 private:
  void expand(Part& root, const std::set<std::filesystem::path>& open);

  std::filesystem::path file_;
  std::string_view element_;
  Room& room_;
  std::size_t files_ = 0;
};

}  // namespace carom
