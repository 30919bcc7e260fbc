#pragma once
// The keys of walls that are not flat, and of the board that carries words where no flat wall does.

#include <vector>

#include "app/file_keys/file_key.h"

namespace carom {

/// Returns the keys of a wall that say what stands in the place of its corners.
std::vector<FileKey> screenKeys();

/// Returns the key of the board, a table.
FileKey panelKey();

}  // namespace carom
