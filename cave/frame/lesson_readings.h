#pragma once
// What a lesson's stopwatches and lines of simultaneity read in a frame.

#include <cstddef>
#include <optional>

#include "cave/frame/lesson_plan.h"
#include "cave/record/frame_state.h"

namespace carom {

/// Returns the time between two events by synchronised clocks at rest in a frame that moves over the board
/// with `beta`: Δt' = γ (Δt − β·Δr/c), the Lorentz transform.
double elapsed_s(const Event& from, const Event& to, const Vec3& beta, double lightSpeed_m_s);

/// Returns the board time of the event at `place_m` that is simultaneous with `with` in a frame that moves
/// over the board with `beta`: t = t_with + β·Δr/c, from Δt' = 0.
double simultaneousAt_s(const Event& with, const Vec3& place_m, const Vec3& beta, double lightSpeed_m_s);

/// What a stopwatch reading depends on.
struct LessonSight {
  const ObserverView& observer;
  const Lorentz& boardFromRoom;
  LessonPhase phase;
  Switches switches = {};
};

/// Returns what the stopwatch reads. "Now" for a frame's clocks is the event of the observer's head. While
/// the lesson shows, a stopwatch with an end reads 0 before its start and stays when it has stopped. While it
/// explains, such a stopwatch has its last reading, which is negative if its end is before its start in its
/// frame.
double reading_s(const Stopwatch& stopwatch, const LessonSight& sight);

/// Returns the quantity of a body, whose seen motion is given on the board. It is seen to move with
/// β/(1 + n·β), where n is the direction from the eye to it, all in the room: its light needs longer to
/// arrive by n·β dt for every dt of the room's clocks. Points of it ℓ apart along β are seen s = ℓ/γ − s n·β
/// apart, so s = ℓ/(γ (1 + n·β)): the light of the farther one left earlier. Without light delay n·β counts
/// as 0, without contraction γ as 1, like the picture for a room at rest.
double gauged(GaugeQuantity quantity, const Motion& seen, const LessonSight& sight);

/// Returns the number of the plan's velocity with which the room moves, if it is one of them.
std::optional<std::size_t> observerOf(const LessonPlan& plan, const Lorentz& boardFromRoom);

}  // namespace carom
