#pragma once
// `carom track`: monitors the trackers of a rig, records the head, and lists the connected devices.

#include <filesystem>
#include <optional>

namespace CLI {
class App;
}

namespace carom {

struct TrackOptions {
  std::filesystem::path rig;
  std::optional<std::filesystem::path> record;  ///< trace of the head's sensor, in its tracker's axes
  std::optional<double> seconds;                ///< if empty, until interrupted
};

/// Monitors the trackers in real time, also recorded and simulated ones, until SIGINT, SIGTERM or the given
/// time. The recording is then written completely or not at all. Returns the exit status: 1 if there was
/// nothing to record. Throws InputError for an invalid rig or trace, std::runtime_error if the recording
/// cannot be written.
int runTrack(const TrackOptions& options);

/// Prints the connected devices, and the force devices behind servers of a rig if one is given.
int runTrackList(const std::optional<std::filesystem::path>& rig);

/// Adds the command to `app`. When it runs, it stores its exit status in `status`.
void addTrack(CLI::App& app, int& status);

}  // namespace carom
