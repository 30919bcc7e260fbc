#pragma once
// The lesson of a scenario file.

#include <string>

#include "app/files/scenario.h"
#include "app/files/toml_file.h"

namespace carom {

/// `title`: the scenario's.
Lesson readLesson(const TomlTable& table, const std::string& title);

}  // namespace carom
