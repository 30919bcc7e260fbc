#pragma once
// `carom import`: turns another program's room file into a rig.

#include <filesystem>
#include <vector>

#include "app/room_import/room.h"

namespace CLI {
class App;
}

namespace carom {

/// By its ending: .pvx of ParaView or .json of SGCT.
bool isForeignRoom(const std::filesystem::path& file);

/// Reads a file that isForeignRoom. Throws InputErrors where it cannot be read.
Room readForeignRoom(const std::filesystem::path& file);

/// What the reader found and what the geometry says, in the order of the file's lines.
std::vector<Finding> findingsOf(const Room& room);

/// Writes findings to standard error, as "warning: FILE:L:C: …". Returns whether one is an error.
bool printFindings(const std::filesystem::path& file, const std::vector<Finding>& findings);

struct ImportOptions {
  std::filesystem::path file;
  std::filesystem::path rig;  ///< to be written; must not exist
};

/// Writes the rig whole or not at all; what it assumed goes to standard error and into the rig's comments.
/// Returns the exit status. Throws InputErrors where the file cannot be read or the room is no rig, and
/// std::runtime_error where the rig cannot be written.
int runImport(const ImportOptions& options);

/// Adds the command to `app`; when it is called, its exit status is left in `status`.
void addImport(CLI::App& app, int& status);

}  // namespace carom
