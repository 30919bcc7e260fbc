#pragma once
// The keys of a scenario's tasks.

#include "app/file_keys/file_key.h"

namespace carom {

/// Letters, at most, of a task's name and of its sentence, which stand in one line of a wall.
inline constexpr std::size_t kTaskNameLetters = 24, kTaskTextLetters = 80;
inline constexpr std::size_t kMostTasks = 20;

FileKey taskKeys();

}  // namespace carom
