#pragma once
// `carom check`: examines a scenario or a rig and says in words what is in it.

#include <filesystem>

namespace carom {

/// Returns the exit status. Throws InputErrors where the file has faults.
int runCheck(const std::filesystem::path& file);

}  // namespace carom
