#pragma once
// What several commands take on their command lines, and how it is checked.

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/files/input_file.h"
#include "engine/spacetime/event.h"

namespace carom {

/// The whole text is one number that this program can calculate with, within the range.
CLI::Validator numberIn(const Range& range, const std::string& expected);

/// Puts the shipped file in the place of its bare name. `kind`: the folder of such files.
CLI::Validator shipped(const std::string& kind);

inline Vec3 toVec3(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }

/// Adds the option --json.
void addJson(CLI::App& command, std::optional<std::filesystem::path>& json);

}  // namespace carom
