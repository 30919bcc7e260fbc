#pragma once
// Tells the room files of other programs apart, by their content, and reads each with its reader.

#include <filesystem>
#include <string>

#include "app/room_checks/room.h"

namespace carom {

/// The programs and their files, for messages and help.
inline constexpr const char* kForeignRooms =
    "a room of ParaView (.pvx), SGCT (.json, .xml), OpenCOVER (.xml), BlenderCAVE or BlenderVR (.xml), "
    "nDisplay "
    "(.ndisplay, .cfg), VR Juggler (.jconf), Equalizer (.eqc), HEVS (.json) or MPCDI (.mpcdi, .mpcdi.xml)";

/// Returns whether a file is to be read as a room of another program: by its ending, or, where it has none of
/// theirs, by how its content begins. A .toml never is.
bool isForeignRoom(const std::filesystem::path& file);

/// Reads the file. `room` names one of several rooms in it; empty: there is one. Throws InputErrors if the
/// file cannot be read, is of none of these kinds, or has several rooms and none is named.
Room readForeignRoom(const std::filesystem::path& file, const std::string& room = "");

}  // namespace carom
