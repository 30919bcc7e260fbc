#pragma once
// `carom import`: turns another program's room file into a rig.

#include <filesystem>
#include <vector>

#include "app/room_checks/room.h"

namespace CLI {
class App;
}

namespace carom {

/// The files that `check` and `import` read beside Carom's own, for their help.
inline constexpr const char* kForeignFiles =
    "ParaView's .pvx; SGCT's .json or .xml; .xml of OpenCOVER, BlenderCAVE or BlenderVR; nDisplay's "
    ".ndisplay or "
    ".cfg; VR Juggler's .jconf; Equalizer's .eqc; HEVS's .json; .mpcdi and .mpcdi.xml";
inline constexpr const char* kRoomHelp =
    "Which of several rooms in the file: a platform of HEVS, a cluster's master of OpenCOVER, a "
    "configuration of "
    "BlenderVR";

/// Returns the findings of the reader and of the geometry checks.
std::vector<Finding> findingsOf(const Room& room);

/// Writes findings to standard error, as toldOf tells them: "warning: FILE:L:C: …". Returns whether any is an
/// error.
bool printFindings(const std::filesystem::path& file, const std::vector<Finding>& findings);

struct ImportOptions {
  std::filesystem::path file;
  std::filesystem::path rig;  ///< output file; must not exist
  std::string room{};         ///< which of several rooms in the file
};

/// Writes the rig completely or not at all, with the files that it needs beside it. Assumptions are written
/// to standard error and into the rig's comments. Returns the exit status. Throws InputErrors if the file
/// cannot be read or the room cannot be a rig, and std::runtime_error if the rig cannot be written.
int runImport(const ImportOptions& options);

/// Adds the command to `app`. When it runs, it stores its exit status in `status`.
void addImport(CLI::App& app, int& status);

}  // namespace carom
