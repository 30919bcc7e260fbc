#pragma once
// Reads the captions of a scenario file: sentences that appear in the room at given times.

#include <vector>

#include "app/files/scenario.h"
#include "app/files/toml_file.h"

namespace carom {

/// Reads the tables [[caption]] of the file. A caption without `from_s` follows the previous one.
std::vector<Caption> readCaptions(const TomlTable& root);

}  // namespace carom
