#pragma once
// `carom check`: examines a scenario, a rig or another program's room file and says in words what is in it
// and what is odd about it.

#include <filesystem>
#include <functional>

#include "app/files/scenario.h"

namespace carom {

/// Returns the exit status: 1 where a room of another program has errors. Throws InputErrors where the file
/// has faults. `openMeshes` opens a scenario's meshes
/// and throws what is wrong with them; a program built without VTK has none.
int runCheck(const std::filesystem::path& file, const std::function<void(const Scenario&)>& openMeshes = {});

}  // namespace carom
