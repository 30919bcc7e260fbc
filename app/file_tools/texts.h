#pragma once
// `carom texts`: templates for translators, and new English brought into translations.

#include <filesystem>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace carom {

/// Writes the templates carom.pot (the catalogue) and scenarios.pot (the shipped games) to a folder, which is
/// made if it is not there, or that of one scenario mine.toml, mine.pot. The same texts give the same bytes.
/// Throws NotWritten if that fails, InputErrors if the scenario cannot be read.
void writeTemplates(const std::filesystem::path& folder,
                    const std::optional<std::filesystem::path>& scenario = {});

/// Brings the English of today into the PO files of a shipped language, and prints the counts of changes.
/// Throws std::runtime_error if there is no such language, InputErrors if a file is no PO file, NotWritten if
/// it cannot be written.
void updateLanguage(const std::string& code);

/// Adds the command to `app`. When it runs, it stores its exit status in `status`.
void addTexts(CLI::App& app, int& status);

}  // namespace carom
