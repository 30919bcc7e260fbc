#include "app/record_tools/compare.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <memory>

#include "app/journal/linked_game_file.h"
#include "app/journal/session_file.h"
#include "engine/linked/promise.h"
#include "engine/text/log.h"

namespace carom {
namespace {

using Rows = LinkedGameRows;

/// A game as both files have it.
struct Pair {
  std::array<const Rows*, 2> of;
  std::array<std::string, 2> files;
  double until_s = 0.0;  ///< board time up to which both know all
};

std::string strokesDiffer(const Pair& pair, std::size_t& count) {
  for (std::size_t side : {0U, 1U}) {
    const Rows &here = *pair.of[side], &there = *pair.of[1 - side];
    for (const auto& [key, stroke] : here.strokes) {
      if (!(stroke.second[0] < pair.until_s)) continue;
      const auto found = there.strokes.find(key);
      const std::string which = fmt::format("stroke {} of room {} at {:.17g} s on {}", key.second, key.first,
                                            stroke.second[0], stroke.first);
      if (found == there.strokes.end()) return fmt::format("{} is in {} alone", which, pair.files[side]);
      if (found->second != stroke) return fmt::format("{} is another one in {}", which, pair.files[1 - side]);
      count += side == 0 ? 1 : 0;
    }
  }
  return {};
}

std::string turnsDiffer(const Pair& pair, std::size_t& count) {
  std::string first;
  double first_s = pair.until_s;
  for (std::size_t side : {0U, 1U}) {
    for (const auto& [puck, turns] : pair.of[side]->turns) {
      const auto found = pair.of[1 - side]->turns.find(puck);
      for (std::size_t i = 0; i < turns.size() && turns[i][0] < first_s; ++i) {
        const bool isSame = found != pair.of[1 - side]->turns.end() && i < found->second.size() &&
                            found->second[i] == turns[i];
        count += side == 0 && isSame ? 1 : 0;
        if (isSame) continue;
        first_s = turns[i][0];
        first = fmt::format("turn {} of {} at {:.17g} s (second {:.0f}) in {} is not in {}", i + 1, puck,
                            first_s, std::floor(first_s), pair.files[side], pair.files[1 - side]);
      }
    }
  }
  return first;
}

/// What `here` was told of the people of `there` must be what they have lived.
std::string toldDiffers(const Rows& here, const Rows& there, const std::string& file, std::size_t& count) {
  for (const auto& [viewer, head] : here.told) {
    const auto found = there.heads.find(viewer);
    // The file of a session that was killed may lack its last moments.
    if (found != there.heads.end() && head[0] > found->second.rbegin()->first[0]) continue;
    if (found == there.heads.end() || !found->second.contains(head))
      return fmt::format(
          "{} was told that the head of {} was at ({:.17g}, {:.17g}, {:.17g}) m at {:.17g} s, where it "
          "never was",
          file, viewer, head[1], head[2], head[3], head[0]);
    ++count;
  }
  return {};
}

/// No eye may be in the future of the promise that held.
std::string eyesInside(const std::filesystem::path& file, const Rows& game, std::size_t& count) {
  constexpr bool kQuiet = true;
  SessionFile session(file, game.game, kQuiet);
  const double c_m_s = session.facts().lightSpeed_m_s;
  session.goTo(static_cast<std::uint64_t>(game.firstFrame));
  FrameState state;
  while (session.next(state)) {
    const auto held = game.promises.find(static_cast<std::int64_t>(state.record.number));
    if (held == game.promises.end()) continue;
    for (const ViewerState& viewer : state.record.present()) {
      for (const EyeView& eye : viewer.observer.all()) {
        for (const Event& promise : held->second) {
          ++count;
          if (isInFutureOf(promise, eye.observation, c_m_s))
            return fmt::format("{}: in frame {} an eye received light from inside a promise", file.string(),
                               state.record.number);
        }
      }
    }
  }
  return {};
}

void compareGame(Pair pair, const std::array<std::filesystem::path, 2>& files, Compared& outcome) {
  const Rows &first = *pair.of[0], &second = *pair.of[1];
  pair.until_s = std::min(first.knownUntil_s, second.knownUntil_s);
  std::size_t strokes = 0, turns = 0, told = 0, eyes = 0;
  const auto note = [&](const std::string& difference) {
    if (outcome.difference.empty()) outcome.difference = difference;
  };
  note(strokesDiffer(pair, strokes));
  note(turnsDiffer(pair, turns));
  note(toldDiffers(first, second, pair.files[0], told));
  note(toldDiffers(second, first, pair.files[1], told));
  for (std::size_t side : {0U, 1U}) note(eyesInside(files[side], *pair.of[side], eyes));
  outcome.lines.push_back(fmt::format(
      "game {}: both know it up to {:.3f} s: {} strokes, {} turns, {} heads that were told and {} eyes "
      "beside promises",
      first.number, pair.until_s, strokes, turns, told, eyes));
}

}  // namespace

Compared compared(const std::filesystem::path& first, const std::filesystem::path& second) {
  const std::array files{first, second};
  const std::array games{linkedGamesOf(first), linkedGamesOf(second)};
  Compared outcome;
  for (const Rows& game : games[0]) {
    const auto found = std::ranges::find(games[1], game.number, &Rows::number);
    if (found == games[1].end()) continue;
    compareGame({{&game, &*found}, {first.string(), second.string()}}, files, outcome);
  }
  if (outcome.lines.empty()) outcome.difference = "the files have no linked game in common";
  return outcome;
}

void addCompare(CLI::App& app, int& status) {
  struct Files {
    std::filesystem::path first, second;
  };
  auto files = std::make_shared<Files>();
  CLI::App* command = app.add_subcommand(
      "compare", "Say whether two linked rooms have played one game, by their session files");
  command->add_option("A", files->first, "Session file of one room")->required()->type_name("A.db");
  command->add_option("B", files->second, "Session file of the other")->required()->type_name("B.db");
  command->footer("Example:\n  carom compare grenoble.db lyon.db");
  command->callback([files, &status] {
    const Compared outcome = compared(files->first, files->second);
    for (const std::string& line : outcome.lines) fmt::print("{}\n", line);
    if (outcome.difference.empty()) {
      fmt::print("the same game\n");
    } else {
      fmt::print("first difference: {}\n", outcome.difference);
      status = 1;
    }
  });
}

}  // namespace carom
