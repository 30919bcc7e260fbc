#pragma once
// `carom calibrate`: where the tracker is in the room, where the tip of a tool and the eyes are on their
// sensors, as lines for the rig.

#include <filesystem>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace carom {

struct CalibrateOptions {
  std::filesystem::path rig;
  std::optional<std::string> tool;     ///< "hand" or "head": whose sensor touches; else the hand's, if any
  std::optional<std::string> corners;  ///< names with commas; else all corners of the rig
  std::optional<std::string> targets;  ///< of the sightings; else the corners of the first wall
  bool pivot = false;
  bool sight = false;
  std::optional<std::filesystem::path> from;    ///< folder of recordings; else live
  std::optional<std::filesystem::path> record;  ///< folder for them
};

/// Takes or reads the points, judges them, prints the results on standard output and faults on standard
/// error. Returns the exit status: 1 if there is a fault; then no lines are printed for what it concerns.
/// Throws InputError for an invalid rig or recording.
int runCalibrate(const CalibrateOptions& options);

/// Adds the command to `app`. When it runs, it stores its exit status in `status`.
void addCalibrate(CLI::App& app, int& status);

}  // namespace carom
