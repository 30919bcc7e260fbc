#pragma once
// Command line values that several commands share, and their validation.

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/toml/input_file.h"
#include "engine/spacetime/event.h"

namespace carom {

/// Returns a validator that accepts one number within the range.
CLI::Validator numberIn(const Range& range, const std::string& expected);

/// Returns a transformation that replaces a bare name by the path of the shipped file, and refuses one that
/// is neither shipped nor a file here. `kinds` are the folders of such files.
CLI::Validator shipped(const std::vector<std::string>& kinds);

/// Returns a transformation that replaces one of these names by its number, and refuses others.
CLI::Validator numberOf(const std::vector<std::pair<std::string, int>>& names);

/// Returns whether what a command reads is a scenario, by its ending; else it is a session.
inline bool isScenario(const std::filesystem::path& source) { return source.extension() == ".toml"; }

inline Vec3 toVec3(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }

/// Adds the option --language. `language` is then as app/file_keys/language_name.h, or empty.
CLI::Option* addLanguage(CLI::App& command, std::string& language);

/// Adds the option --json.
void addJson(CLI::App& command, std::optional<std::filesystem::path>& json);

}  // namespace carom
