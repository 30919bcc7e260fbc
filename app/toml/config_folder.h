#pragma once
// The folder of the shipped rigs, scenarios and traces, and their short names.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace carom {

/// Returns the folder that holds rigs/, scenarios/ and traces/: share/carom beside the bin/ of the running
/// program if it is installed, otherwise that of the sources.
const std::filesystem::path& configFolder();

/// Returns the shipped file of a bare name: "three-pucks" of kind "scenarios" is
/// …/scenarios/three-pucks.toml. A name with a folder or an extension, of an existing file, or without a
/// shipped file is returned unchanged.
std::filesystem::path shippedFile(const std::filesystem::path& given, std::string_view kind);

/// Returns the bare names of the shipped files of a kind, in alphabetical order.
std::vector<std::string> shippedNames(std::string_view kind);

/// Returns whether both paths name the same file.
bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace carom
