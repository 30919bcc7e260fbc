#include "app/operator/playlist.h"

#include <algorithm>

#include "app/files/config_folder.h"

namespace carom {

std::string fileOfGame(std::string_view name) {
  return (configFolder() / "scenarios" / name).replace_extension(".toml").string();
}

std::size_t numberOfLesson(const std::string& file) {
  if (file.empty()) return kLessons.size();
  const auto* found = std::find_if(kLessons.begin(), kLessons.end(), [&](std::string_view lesson) {
    return isSameFile(fileOfGame(lesson), file);
  });
  return static_cast<std::size_t>(found - kLessons.begin());
}

std::string lessonAfter(const std::string& file) {
  const std::size_t next = numberOfLesson(file) + 1;
  return fileOfGame(next < kLessons.size() ? kLessons[next] : kLessons.front());
}

Command commandOf(Choice choice, const OperatorSettings& settings) {
  switch (choice) {
    case Choice::play:
      return PlayScenario{fileOfGame(kWelcome)};
    case Choice::lessons:
      return PlayScenario{lessonAfter(settings.lastLesson)};
    case Choice::showMe:
      break;
  }
  return PlayScenario{fileOfGame(kShowMe)};
}

}  // namespace carom
