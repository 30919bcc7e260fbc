#pragma once
// The keys of scenarios.

#include "app/file_keys/file_key.h"

namespace carom {

/// Letters of a caption, at most: it is one line on a wall.
inline constexpr std::size_t kCaptionLetters = 110;

const FileKey& scenarioKeys();

}  // namespace carom
