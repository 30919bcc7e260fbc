#pragma once
// The linked games of a session file (app/journal/journal.h), to be compared with those of the other room's.

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "app/journal_rows/journal_news.h"
#include "engine/spacetime/event.h"

namespace carom {

/// One linked game, from joining until the other room was gone or the file ends.
struct LinkedGameRows {
  using Numbers = std::vector<double>;  ///< of a row, in the order of its columns

  std::string number;    ///< that both rooms have for this game
  std::size_t game = 1;  ///< of the session, counted from 1
  std::uint32_t otherRoom = 1;
  std::int64_t firstFrame = 0, lastFrame = 0;
  /// By room and number: puck and numbers.
  std::map<std::pair<std::int64_t, std::int64_t>, std::pair<std::string, Numbers>> strokes;
  /// The turns of each puck in the order of their times.
  std::map<std::string, std::vector<Numbers>> turns;
  /// The heads of the other room as they were told: viewer and numbers.
  std::vector<std::pair<std::string, Numbers>> told;
  /// The heads here, by viewer: number of the same as in `told`, each once.
  std::map<std::string, std::map<Numbers, std::int64_t>> heads;
  /// The promises that held, by frame.
  std::map<std::int64_t, std::vector<Event>> promises;
  double knownUntil_s = 0.0;  ///< board time of the other's last promise
};

/// Reads the strokes of the newest game of a session file, for a room that hosts it again; `viewer` counts
/// the people of each stroke's room. Throws std::runtime_error with the file's name if that cannot be done:
/// it has no linked game, or that of another host.
std::vector<HandStroke> hostedStrokesOf(const std::filesystem::path& file, std::span<const Puck> pucks);

/// Reads the linked games of a session file. Throws std::runtime_error with the file's name if it cannot be
/// read or has none.
std::vector<LinkedGameRows> linkedGamesOf(const std::filesystem::path& file);

}  // namespace carom
