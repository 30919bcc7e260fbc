#pragma once
// `carom replay`: shows a recorded session again, as it was seen or as another viewer sees it.

#include <filesystem>
#include <optional>
#include <string>

#include "app/stage/desk_windows.h"
#include "app/stage/recording.h"
#include "app/stage/sky_rig.h"
#include "engine/spacetime/event.h"

namespace CLI {
class App;
}

namespace carom {

struct ReplayOptions {
  std::filesystem::path session;
  std::optional<std::size_t> game;                ///< of the session, from 1; by default the newest
  std::optional<std::filesystem::path> observer;  ///< trace of another viewer's head (room axes)
  std::string as;  ///< of several viewers, the one whose walls alone are shown; empty: all
  std::optional<std::filesystem::path> rig;  ///< the room of another viewer; empty: the recorded one
  bool walk = false;                         ///< another viewer, whose head the rig's tracker follows
  std::optional<Vec3> beta;                  ///< v/c of the other viewer's room on the board
  std::optional<Vec3> from_m;                ///< initial position of that room's floor origin on the board
  std::optional<double> facing_rad;          ///< initial direction of its forward axis, anticlockwise from +x
  std::optional<double> at_s;                ///< session time at which to start; not with another viewer
  std::optional<SkyPicture> sky;             ///< shown in the place of the walls
  RecordingOptions recording;                ///< images and movie
  std::string language;                      ///< of the words; empty: as it was recorded
  bool noWindow = false;                     ///< without windows, frames go as fast as possible
  bool silent = false;                       ///< no sounds
  ExtraWindows extra;                        ///< what rank 0 also shows
};

/// Returns the exit status: 0, or 1 after a message on standard error.
int runReplay(const ReplayOptions& options);

/// Adds the command to `app`. When it runs, it stores its exit status in `status`.
void addReplay(CLI::App& app, int& status);

}  // namespace carom
