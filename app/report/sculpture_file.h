#pragma once
// Writes a game's sculpture (engine/sculpture/game_sculpture.h) as a file of meshes.

#include <filesystem>

#include "engine/sculpture/game_sculpture.h"

namespace carom {

/// Returns whether a name ends as one of the formats: .glb, with colours, names and sheets of glass, in
/// metres, y upwards; .stl and .3mf, for printers, in millimetres, z upwards.
bool isSculptureFile(const std::filesystem::path& file);

/// Returns whether the format is for printers.
bool isForPrinters(const std::filesystem::path& file);

/// Writes the file completely or not at all. Throws std::runtime_error that names the file and the error.
void writeSculpture(const GameSculpture& sculpture, const std::filesystem::path& file);

}  // namespace carom
