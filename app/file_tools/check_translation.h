#pragma once
// `carom check` of a translation: its findings, and how much of it is translated.

#include <filesystem>

#include "app/languages/language_files.h"

namespace carom {

/// Returns what the fonts of this computer have.
LetterFonts fontsHere();

/// Prints the findings about a PO file and how much of it is translated; if it has no errors, also whether
/// its texts have room at their places on a rig (app/file_tools/text_places.h), or on all that are examined
/// if `rig` is empty. Returns whether it has errors. Throws InputErrors if it is no PO file.
bool tellTranslation(const std::filesystem::path& file, const std::filesystem::path& rig = {});

}  // namespace carom
