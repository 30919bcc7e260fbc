#pragma once
// Reads the lesson of a scenario file.

#include <string>

#include "app/files/scenario.h"
#include "app/files/scenario_lesson_plan.h"
#include "app/files/toml_file.h"

namespace carom {

/// Reads the lesson of a game. `title` is that of the scenario.
Lesson readLesson(const TomlTable& table, const std::string& title, const LessonGame& game);

}  // namespace carom
