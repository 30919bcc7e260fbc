#pragma once
// The tasks of a game as they are played: which one it is, its tries, their energy and stars, and what comes
// next.

#include <cstddef>
#include <optional>

#include "app/live/announcements.h"
#include "app/live/decision.h"
#include "app/operator/operator_settings.h"
#include "app/play/task_judge.h"
#include "app/scenario/scenario.h"
#include "cave/record/frame_state.h"

namespace carom {

/// Returns the stars for the energy of a task's strokes: three, two or one.
int starsFor(const Task& task, double energy_j);

/// Returns the kinetic energy that a stroke gives a puck at rest: (γ − 1) m c².
double energyOf_j(const Stroke& stroke, const BilliardSetup& setup);

class TaskRun {
 public:
  static constexpr double kTry_s =
      12.0;  ///< of the viewer's own time after a stroke; then the try has failed
  static constexpr double kAfter_s = 6.0;  ///< after a task is done the next one follows

  /// `scenario` must outlive this object.
  explicit TaskRun(const Scenario& scenario) : scenario_(&scenario) {}

  /// Notes a stroke that was made by the hand of a viewer and arrives at this board time.
  void struck(std::size_t viewer, const Stroke& stroke, double arrives_s);

  /// Looks at a frame in which time passes; does nothing in a game without tasks.
  void look(const OperatorSettings& settings, const World& world, Announcements& announcements,
            Decision& decision);

 private:
  enum class State { begins, waits, tried, done, left };
  void begin(const OperatorSettings& settings, Announcements& announcements, Decision& decision);
  void judge(const World& world, Announcements& announcements, Decision& decision);
  void note(const char* event, int stars, Decision& decision) const;

  const Scenario* scenario_;
  std::size_t number_ = 0;
  State state_ = State::begins;
  std::optional<TaskJudge> judge_;
  std::size_t viewer_ = 0;            ///< whose hand struck last
  double energy_j_ = 0.0;             ///< of all strokes since the task began
  std::optional<double> struckAt_s_;  ///< own time of the viewer; empty: the frame of the stroke is not over
  double doneAt_s_ = 0.0;             ///< session clock
};

}  // namespace carom
