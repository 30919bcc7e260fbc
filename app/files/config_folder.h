#pragma once
// Where the shipped rigs, scenarios and traces are, and their short names.

#include <filesystem>
#include <string_view>

namespace carom {

/// The folder that holds rigs/, scenarios/ and traces/: share/carom beside the bin/ of the running program,
/// as it is when installed; else that of the sources.
const std::filesystem::path& configFolder();

/// The shipped file that a bare name stands for: "three-pucks" among "scenarios" is
/// …/scenarios/three-pucks.toml. What has a folder or an ending, names a file that is there, or is no
/// shipped name is returned as it is.
std::filesystem::path shippedFile(const std::filesystem::path& given, std::string_view kind);

/// The same file, however it is named.
bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace carom
