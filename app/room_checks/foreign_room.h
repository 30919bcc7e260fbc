#pragma once
// Shared by the readers of other programs' room files.

#include <span>
#include <string>
#include <string_view>

#include "app/room_checks/room.h"

namespace carom {

/// Returns an empty room with the axes of another program: y up, −z forward, metres, and the assumptions that
/// follow.
Room foreignRoom(const std::filesystem::path& file, std::string format);

void addError(Room& room, FilePlace at, std::string text);
void addWarning(Room& room, FilePlace at, std::string text);

/// Warns of a key that the other program does not know either, with the nearest known one.
void addUnknownKey(Room& room, FilePlace at, std::string_view key, std::span<const std::string_view> known);

/// Returns a name with only such characters as a rig's names may have: others become -.
std::string plainName(std::string_view given);

/// Returns a valid, unique rig name: the plain name, with a number if it is taken.
std::string rigName(const Room& room, std::string_view given);

}  // namespace carom
