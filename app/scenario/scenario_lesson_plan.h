#pragma once
// Reads what a lesson shows, measures and draws (cave/frame/lesson_plan.h).

#include <span>
#include <string>
#include <vector>

#include "app/toml/toml_file.h"
#include "cave/frame/lesson_plan.h"
#include "engine/game/billiard_setup.h"

namespace carom {

/// The things of a scenario that its lesson can name.
struct LessonGame {
  const BilliardSetup& billiard;
  std::vector<std::string> bodies;  ///< names of the pucks, then of the scripted bodies
};

/// Reads the plan from the table `[lesson]`. Reports a moment outside the interval, a name that is not in the
/// game, and a flash that the interval does not reach.
LessonPlan readLessonPlan(const TomlTable& lesson, const LessonGame& game);

}  // namespace carom
