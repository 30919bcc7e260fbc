#pragma once
// Judges whether a task is done: from the game's events and world lines and from when their light arrives at
// the one who plays, never from a picture.

#include <array>
#include <optional>
#include <span>

#include "app/play/carom_score.h"
#include "app/scenario/scenario.h"
#include "engine/game/game_event.h"
#include "engine/spacetime/observer.h"

namespace carom {

/// Returns the effects with which a world is drawn; colour and beaming stay as in `before`.
Switches switchesOf(TaskWorld world, const Switches& before);

class TaskJudge {
 public:
  static constexpr double kAtOnce_s = 0.1;     ///< of the viewer's own time, between two hits
  static constexpr double kSameTime_s = 0.05;  ///< between two clocks

  /// `task` must outlive this object.
  TaskJudge(const Task& task, double lightSpeed_m_s) : task_(&task), c_m_s_(lightSpeed_m_s) {}

  /// Begins a try: this puck was struck by hand, and the stroke arrives at this board time.
  void struck(std::size_t puck, double arrives_s);

  /// Looks at the game as the viewer sees it in a frame. `pucks` are their world lines in the scenario's
  /// order. Returns whether the task is done with this frame; never before the first stroke.
  bool look(std::span<const GameEvent> events, std::span<const WorldLine> pucks, const ObserverView& observer,
            const Lorentz& boardFromRoom);

 private:
  /// A frame as the viewer has it: the event between the eyes, and the own time there.
  struct Moment {
    Event eye;
    double own_s = 0.0;
  };
  double late_s(const Event& event, const Event& eye) const;
  bool hits(std::span<const GameEvent> events, const Event& eye) const;
  bool hitsBoth(std::span<const GameEvent> events, const Moment& now);

  const Task* task_;
  double c_m_s_;
  std::optional<std::size_t> struck_;
  double arrives_s_ = 0.0;  ///< of the first stroke of the try
  CaromScore carom_;
  std::optional<Moment> before_;                  ///< the frame before
  std::array<std::optional<double>, 2> hitAt_s_;  ///< when the viewer saw the last hit of each, own time
};

}  // namespace carom
