#pragma once
// `carom track`: watches the trackers of a rig, records the head, says what is plugged in.

#include <filesystem>
#include <optional>

namespace CLI {
class App;
}

namespace carom {

struct TrackOptions {
  std::filesystem::path rig;
  std::optional<std::filesystem::path> record;  ///< trace of the head's sensor, in its tracker's axes
  std::optional<double> seconds;                ///< none: until interrupted
};

/// Watches in real time, recorded and simulated trackers too, until SIGINT or SIGTERM or the given time. The
/// recording then appears, whole. Returns the exit status: 1 where there was nothing to record. Throws
/// InputError for a bad rig or trace, std::runtime_error where the recording cannot be written.
int runTrack(const TrackOptions& options);

/// Prints the devices that are plugged in.
int runTrackList();

/// Adds the command to `app`; when it is called, its exit status is left in `status`.
void addTrack(CLI::App& app, int& status);

}  // namespace carom
