#pragma once
// What a participant did in a lesson, computed from the rows of its frames.

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "engine/spacetime/event.h"

namespace carom {

struct LessonBehaviour {
  double ask_s = 0.0, show_s = 0.0, explain_s = 0.0;
  bool hasExplained = false;
  int repeats = 0;
  std::vector<int> velocities;  ///< numbers from 1
  int viewsSwitched = 0, strokes = 0;
  double path_m = 0.0, betaMean = 0.0, betaMost = 0.0;
  double towardsTable = 0.0;
  std::optional<double> towardsPanel;
  double blank_s = 0.0, lost_s = 0.0;
};

/// The head in the room of a session.
struct HeadInRoom {
  glm::dmat3 axesOfSensor{1.0};       ///< from the head's axes to those of its sensor
  Vec3 forward{0.0, 0.0, -1.0};       ///< in the head's axes
  std::optional<Vec3> panelMiddle_m;  ///< of what carries the words
};

/// Returns the behaviour in the frames from `first` on, before `end`, of a session file.
LessonBehaviour behaviourIn(SQLite::Database& session, std::int64_t first, std::int64_t end,
                            const HeadInRoom& head);

/// Returns the length of a path of positions that were taken at these times: sampled at 60 Hz and low-passed
/// at 2 Hz by a Butterworth filter of second order, forwards and backwards, so that jitter does not count.
double pathLength_m(std::span<const double> times_s, std::span<const Vec3> positions_m);

}  // namespace carom
