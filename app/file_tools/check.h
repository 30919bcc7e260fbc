#pragma once
// `carom check`: examines a scenario, a rig, a translation or another program's room file, and reports its
// contents and everything unusual about it.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "app/rig/rig.h"
#include "app/scenario/scenario.h"

namespace CLI {
class App;
}

namespace carom {

/// Open the files that only a program built with VTK can read, and throw their faults.
struct FileOpeners {
  std::function<void(const Scenario&)> meshes{};
  std::function<void(const std::filesystem::path&, const Rig&)> blends{};
};

/// `room` names one of several rooms in a file of another program; on `rig` the texts of a translation are
/// laid out (app/file_tools/check_translation.h). Returns the exit status: 1 if such a room or a translation
/// has errors. Throws InputErrors if the file has faults.
int runCheck(const std::filesystem::path& file, const FileOpeners& open = {}, const std::string& room = {},
             const std::filesystem::path& rig = {});

/// Shows the test patterns of a rig, or writes them as images to the folder `capture`; their words are in the
/// rig's language or in `language`. Returns the exit status.
using ShowPattern =
    std::function<int(const std::filesystem::path& rig, const std::optional<std::filesystem::path>& capture,
                      const std::string& language)>;

/// Adds the command to `app`. When it runs, it stores its exit status in `status` and has a budget
/// (cave/process/work_budget.h). Without `showPattern` there is no option for it.
void addCheck(CLI::App& app, int& status, const FileOpeners& open, const ShowPattern& showPattern);

}  // namespace carom
