#pragma once
// The syntax of Equalizer's configuration files: sections in braces, values, lists in brackets, comments
// from # to the end of the line.

#include <filesystem>

#include "app/room_parts/part.h"

namespace carom {

/// Returns the file's content; a list has an element without name for each of its words. Throws InputErrors
/// if the file cannot be read, a bracket is missing, or it is nested over 32 levels deep or has over 100 000
/// values.
Part readEqcParts(const std::filesystem::path& file);

}  // namespace carom
