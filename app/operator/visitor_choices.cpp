#include "app/operator/visitor_choices.h"

#include <algorithm>
#include <optional>

#include "app/toml/config_folder.h"
#include "cave/texts/texts.h"

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

std::string lessonAfter(const std::string& file, bool canWalk) {
  std::size_t next = numberOfLesson(file) + 1;
  if (next < kLessons.size() && kLessons[next] == kLessonOfWalkers && !canWalk) ++next;
  return fileOfGame(next < kLessons.size() ? kLessons[next] : kLessons.front());
}

namespace {

/// Returns the lesson of the playlist after the one that was seen last, or none if it has no lesson.
std::optional<std::string> lessonIn(const Playlist& playlist, const std::string& last) {
  const std::size_t games = playlist.games.size(), seen = numberOf(playlist, last);
  for (std::size_t step = 1; step <= games; ++step) {
    const PlaylistGame& game = playlist.games[seen < games ? (seen + step) % games : step - 1];
    if (game.isLesson) return game.scenario.string();
  }
  return {};
}

}  // namespace

Command commandOf(Choice choice, const OperatorSettings& settings) {
  const Playlist* const playlist = settings.playlist.get();
  const auto afresh = [](const std::string& file) { return PlayScenario{file, true}; };
  switch (choice) {
    case Choice::play:
      return afresh(playlist ? playlist->games.front().scenario.string() : fileOfGame(kWelcome));
    case Choice::lessons: {
      if (!playlist) return afresh(lessonAfter(settings.lastLesson, settings.canWalk));
      const auto lesson = lessonIn(*playlist, settings.lastLesson);
      if (lesson) return afresh(*lesson);
      return TellPerson{texts::message::kNoLesson};
    }
    case Choice::showMe:
      break;
  }
  const std::string show = fileOfGame(kShowMe);
  if (playlist && numberOf(*playlist, show) == playlist->games.size())
    return TellPerson{texts::message::kNoShow};
  return afresh(show);
}

Command beginTasks(const OperatorSettings& settings) {
  const std::string tasks = fileOfGame(kTasks);
  const Playlist* const playlist = settings.playlist.get();
  if (playlist && numberOf(*playlist, tasks) == playlist->games.size())
    return TellPerson{texts::message::kNoTasks};
  return PlayScenario{tasks, true};
}

Command nextLanguage(const OperatorSettings& settings, std::size_t viewer) {
  const std::size_t count = settings.languages ? settings.languages->all.size() : 1;
  if (count < 2) return TellPerson{texts::message::kOneLanguage};
  return SetLanguage{viewer, static_cast<std::uint8_t>((settings.languageOf.at(viewer) + 1U) % count)};
}

Command nextTask(const OperatorSettings& settings) {
  return PlayScenario{settings.playing, false, {}, settings.task + 1};
}

}  // namespace carom
