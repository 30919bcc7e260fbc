#pragma once
// Where the windows lay when the user last closed them: windows.toml in the user's own configuration folder.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace carom {

/// Where a window lay.
struct RememberedWindow {
  std::string name;               ///< "console"; of a wall also how its rig places it
  std::string monitor;            ///< "DP-1"
  std::array<int, 2> position{};  ///< pixels from the monitor's upper left
  std::array<int, 2> size{};

  bool operator==(const RememberedWindow&) const = default;
};

/// Returns the folder of the user's own settings: carom in $XDG_CONFIG_HOME or, without that, in ~/.config.
/// Empty if the user has no home.
std::filesystem::path userFolder();

/// Returns what the file holds: nothing if it is not there, or if it is wrong, which is logged.
std::vector<RememberedWindow> readWindowMemory(const std::filesystem::path& file);

/// Writes the file. The windows of other sessions that it held stay, as long as there are few. Logs why if it
/// cannot be written: no session ends for that.
void writeWindowMemory(const std::filesystem::path& file, const std::vector<RememberedWindow>& windows);

}  // namespace carom
