#pragma once
// `carom check`: examines a scenario, a rig or another program's room file, and reports its contents and what
// is unusual about it.

#include <filesystem>
#include <functional>
#include <optional>

#include "app/files/scenario.h"

namespace CLI {
class App;
}

namespace carom {

/// Returns the exit status: 1 if a room of another program has errors. Throws InputErrors if the file has
/// faults. `openMeshes` opens a scenario's meshes and throws their faults; it is empty in a program built
/// without VTK.
int runCheck(const std::filesystem::path& file, const std::function<void(const Scenario&)>& openMeshes = {});

/// Shows the test patterns of a rig, or writes them as images to the folder `capture`. Returns the exit
/// status.
using ShowPattern =
    std::function<int(const std::filesystem::path& rig, const std::optional<std::filesystem::path>& capture)>;

/// Adds the command to `app`. When it runs, it stores its exit status in `status`. `openMeshes` is as in
/// runCheck. Without `showPattern` there is no option for it.
void addCheck(CLI::App& app, int& status, const std::function<void(const Scenario&)>& openMeshes,
              const ShowPattern& showPattern);

}  // namespace carom
