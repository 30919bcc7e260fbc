#pragma once
// What the readers of other programs' room files share.

#include <span>
#include <string>
#include <string_view>

#include "app/room_import/room.h"

namespace carom {

/// A room of another program: y up, -z ahead, metres, with the assumptions that follow.
Room foreignRoom(const std::filesystem::path& file, std::string format);

void addError(Room& room, FilePlace at, std::string text);
void addWarning(Room& room, FilePlace at, std::string text);

/// Warns of a key that the other program does not know either; names the nearest that it does.
void addUnknownKey(Room& room, FilePlace at, std::string_view key, std::span<const std::string_view> known);

/// A name that a rig takes: other letters become -, and a number is added where it is taken.
std::string rigName(const Room& room, std::string_view given);

}  // namespace carom
