#include "app/operator/playlist.h"

#include <algorithm>

#include "app/files/config_folder.h"

namespace carom {

std::string fileOfGame(std::string_view name) {
  return (configFolder() / "scenarios" / name).replace_extension(".toml").string();
}

std::string lessonAfter(const std::string& playing) {
  if (playing.empty()) return fileOfGame(kLessons.front());
  const auto* now = std::find_if(kLessons.begin(), kLessons.end(), [&](std::string_view lesson) {
    return isSameFile(fileOfGame(lesson), playing);
  });
  const bool isLast = now == kLessons.end() || now + 1 == kLessons.end();
  return fileOfGame(isLast ? kLessons.front() : *(now + 1));
}

}  // namespace carom
