#pragma once
// `carom check`: examines a scenario, a rig or another program's room file and says in words what is in it
// and what is odd about it.

#include <filesystem>
#include <functional>
#include <optional>

#include "app/files/scenario.h"

namespace CLI {
class App;
}

namespace carom {

/// Returns the exit status: 1 where a room of another program has errors. Throws InputErrors where the file
/// has faults. `openMeshes` opens a scenario's meshes
/// and throws what is wrong with them; a program built without VTK has none.
int runCheck(const std::filesystem::path& file, const std::function<void(const Scenario&)>& openMeshes = {});

/// Shows the test patterns of a rig, or writes them as pictures to the folder `capture`; returns the exit status.
using ShowPattern =
    std::function<int(const std::filesystem::path& rig, const std::optional<std::filesystem::path>& capture)>;

/// Adds the command to `app`; when it is called, its exit status is left in `status`. `openMeshes`: as of
/// runCheck. Without `showPattern` there is no option for it.
void addCheck(CLI::App& app, int& status, const std::function<void(const Scenario&)>& openMeshes,
              const ShowPattern& showPattern);

}  // namespace carom
