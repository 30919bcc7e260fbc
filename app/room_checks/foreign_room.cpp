#include "app/room_checks/foreign_room.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

namespace carom {

Room foreignRoom(const std::filesystem::path& file, std::string format) {
  Room room;
  room.file = file;
  room.title = printable(file.stem().string());
  room.format = std::move(format);
  room.assumptions.push_back("lengths are metres: the file states no unit");
  room.assumptions.push_back(
      "axes are x right, y up, z back, as that program has them: the file states none");
  return room;
}

void addError(Room& room, FilePlace at, std::string text) {
  room.findings.add({Finding::Kind::error, at, std::move(text)});
}

void addWarning(Room& room, FilePlace at, std::string text) {
  room.findings.add({Finding::Kind::warning, at, std::move(text)});
}

void addUnknownKey(Room& room, FilePlace at, std::string_view key, std::span<const std::string_view> known) {
  const std::vector<std::string> words(known.begin(), known.end());
  const auto nearest = room.findings.isLong() ? std::nullopt : nearestWord(key, words);
  addWarning(room, at,
             nearest
                 ? fmt::format("unknown key '{}' is passed over, expected '{}'?", printable(key), *nearest)
                 : fmt::format("unknown key '{}' is passed over, expected one of {}", printable(key),
                               fmt::join(words, ", ")));
}

std::string plainName(std::string_view given) {
  std::string plain(given);
  std::replace_if(
      plain.begin(), plain.end(),
      [](char c) {
        const bool ascii = static_cast<unsigned char>(c) < 0x80;
        return !(ascii && (std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_'));
      },
      '-');
  return plain.empty() ? "wall" : plain;
}

std::string rigName(const Room& room, std::string_view given) {
  const std::string plain = plainName(given);
  std::string name = plain;
  const auto taken = [&] {
    return std::any_of(room.walls.begin(), room.walls.end(),
                       [&](const RoomWall& wall) { return wall.wall.name == name; });
  };
  for (int number = 2; taken(); ++number) name = fmt::format("{}-{}", plain, number);
  return name;
}

}  // namespace carom
