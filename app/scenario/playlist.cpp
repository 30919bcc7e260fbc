#include "app/scenario/playlist.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "app/file_keys/playlist_keys.h"
#include "app/scenario/scenario.h"
#include "app/toml/config_folder.h"
#include "app/toml/toml_file.h"
#include "app/toml/toml_values.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

/// Returns the scenario that a playlist names: a shipped one by its bare name, or a file, beside the playlist
/// if it is there.
fs::path scenarioOf(const fs::path& playlist, const std::string& name) {
  std::error_code failed;
  const fs::path beside = playlist.parent_path() / name;
  return fs::exists(beside, failed) ? beside : shippedFile(name, "scenarios");
}

/// Returns why a scenario that is there cannot be one of a playlist's; empty if it can.
std::string refusalOfGame(const fs::path& playlist, const fs::path& scenario) {
  const fs::path folder = playlist.parent_path();
  if (liesBelow(scenario, folder) || liesBelow(scenario, configFolder()))
    return refusalOf(scenario, InputKind::toml);
  return fmt::format("this is {}, expected a game below this folder or one that carom list tells",
                     outsideWords(scenario, folder));
}

std::string missing(const std::string& name) {
  const std::vector<std::string> known = shippedNames("scenarios");
  const auto near = nearestWord(name, known);
  return fmt::format("there is no game '{}', expected a file or a name that carom list tells{}",
                     printable(name), near ? fmt::format(", such as '{}'?", *near) : "");
}

PlaylistGame readGame(const fs::path& playlist, const TomlTable& table) {
  PlaylistGame game;
  const std::string name = table.text("scenario");
  game.scenario = scenarioOf(playlist, name);
  game.attracts = table.flag("attract");
  if (table.has("for_s")) game.for_s = table.number("for_s");
  game.note = table.text("note", "");
  if (const std::size_t most = table.declared("note").letters; game.note.size() > most)
    table.fault("note", fmt::format("{} bytes, expected at most {}", game.note.size(), most));
  std::error_code failed;
  if (!fs::exists(game.scenario, failed)) {
    if (!name.empty()) table.fault("scenario", missing(name));
    return game;
  }
  if (const std::string refusal = refusalOfGame(playlist, game.scenario); !refusal.empty()) {
    table.fault("scenario", fmt::format("'{}': {}", name, refusal));
    return game;
  }
  try {
    const Scenario scenario = readScenario(game.scenario);
    game.title = scenario.title;
    game.isLesson = scenario.lesson.has_value();
  } catch (const InputErrors& errors) {
    table.fault("scenario",
                fmt::format("this game cannot be played: {}", printable(errors.faults().front().what())));
  }
  return game;
}

}  // namespace

Playlist readPlaylist(const fs::path& path) {
  const TomlFile file(path, playlistKeys());
  const TomlTable& root = file.root();
  Playlist playlist;
  playlist.title = root.text("title", path.stem().string());
  playlist.languages = readLanguages(root, path.parent_path());
  const std::vector<TomlTable> tables = root.tables("game");
  if (tables.empty()) root.fault("game", "there is no game here, expected one [[game]] at least");
  for (const TomlTable& table : tables) {
    PlaylistGame game = readGame(path, table);
    if (numberOf(playlist, game.scenario) < playlist.games.size())
      table.fault("scenario", "this game stands here twice, expected it once");
    playlist.games.push_back(std::move(game));
  }
  file.throwFaults();
  return playlist;
}

std::size_t numberOf(const Playlist& playlist, const fs::path& scenario) {
  const auto found =
      std::find_if(playlist.games.begin(), playlist.games.end(),
                   [&](const PlaylistGame& game) { return isSameFile(game.scenario, scenario); });
  return static_cast<std::size_t>(found - playlist.games.begin());
}

}  // namespace carom
