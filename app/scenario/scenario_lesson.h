#pragma once
// Reads the lesson and the tasks of a scenario file.

#include <string>
#include <string_view>

#include "app/scenario/scenario.h"
#include "app/scenario/scenario_lesson_plan.h"
#include "app/toml/toml_file.h"

namespace carom {

/// Reads a text; one with more letters than declared is a fault.
std::string readWords(const TomlTable& table, std::string_view key);

/// Reads a key with the names of time views. The others are off.
TimeViews readViews(const TomlTable& table, std::string_view key = "views");

/// Reads the tasks of a game with these pucks.
std::vector<Task> readTasks(const TomlTable& root, const std::vector<Puck>& pucks);

/// Reads the lesson of a game. `title` is that of the scenario.
Lesson readLesson(const TomlTable& table, const std::string& title, const LessonGame& game);

}  // namespace carom
