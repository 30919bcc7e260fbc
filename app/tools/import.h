#pragma once
// `carom import`: turns another program's room file into a rig.

#include <filesystem>
#include <vector>

#include "app/room_import/room.h"

namespace CLI {
class App;
}

namespace carom {

/// Returns whether the extension is that of another program's room: .pvx of ParaView or .json of SGCT.
bool isForeignRoom(const std::filesystem::path& file);

/// Reads a file for which isForeignRoom is true. Throws InputErrors if it cannot be read.
Room readForeignRoom(const std::filesystem::path& file);

/// Returns the findings of the reader and of the geometry checks.
std::vector<Finding> findingsOf(const Room& room);

/// Writes findings to standard error, as toldOf tells them: "warning: FILE:L:C: …". Returns whether any is an
/// error.
bool printFindings(const std::filesystem::path& file, const std::vector<Finding>& findings);

struct ImportOptions {
  std::filesystem::path file;
  std::filesystem::path rig;  ///< output file; must not exist
};

/// Writes the rig completely or not at all. Assumptions are written to standard error and into the rig's
/// comments. Returns the exit status. Throws InputErrors if the file cannot be read or the room cannot be a
/// rig, and std::runtime_error if the rig cannot be written.
int runImport(const ImportOptions& options);

/// Adds the command to `app`. When it runs, it stores its exit status in `status`.
void addImport(CLI::App& app, int& status);

}  // namespace carom
