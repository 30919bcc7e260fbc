#pragma once
// The texts of games and lessons that visitors read: titles, captions, questions, tasks, names of pucks.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/languages/source_text.h"

namespace carom {

/// Returns the texts of one scenario file in its order, each with the file's name before its own:
/// "angles.toml title", "angles.toml lesson answer 1", "angles.toml name slow". Names of pucks, bodies,
/// flashes and pulses are there once, without their numbers; names without two letters in a row are not.
/// Throws InputErrors if it is no TOML file; what else is wrong with it is not looked for.
std::vector<SourceText> scenarioTexts(const std::filesystem::path& file);

/// Returns the texts of all shipped scenarios, in the order of their names.
std::vector<SourceText> shippedScenarioTexts();

}  // namespace carom
