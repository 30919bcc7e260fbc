#pragma once
// What a lesson shows besides its texts: the part of the game that matters, the velocities that it offers the
// observer, and the measurements and marks. Events and places are in the board frame.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/spacetime/event.h"

namespace carom {

/// The part of the game that a lesson shows, in board times of the observer's head.
struct LessonInterval {
  double from_s = 0.0;
  double until_s = 0.0;
  double moment_s = 0.0;  ///< held while the lesson explains
  bool keepsClocks =
      false;  ///< instead, the moment at which everybody is, so that their clocks stay as they are
  double slowness = 1.0;  ///< how many times slower than in the game the observer's time passes
};

/// A velocity that the lesson offers the observer. Observers of all velocities pass the scenario's position
/// at the lesson's moment.
struct LessonObserver {
  std::string name;
  Vec3 beta{0.0};
};

enum class StopwatchClock : std::uint8_t {
  frame,  ///< synchronised clocks at rest in an inertial frame
  room,   ///< synchronised clocks at rest in the observer's room
  mine,   ///< the observer's own: proper time since the interval began
  seen,   ///< the table's clock at a place, as the observer sees it
};

struct Stopwatch {
  std::string name;
  StopwatchClock clock = StopwatchClock::frame;
  Vec3 beta{0.0};                ///< of the frame
  Event starts;                  ///< `frame`, `room`: it starts here
  std::optional<Event> stops;    ///< `frame`, `room`: it stops here; without it, it runs on
  bool stopsWhenSeen = false;    ///< `frame`, `room`: it stops when the observer sees the start
  Vec3 seen_m{0.0};              ///< `seen`: the place of the clock
  std::optional<Vec3> stands_m;  ///< where a plate with its reading stands
};

/// A plate above a body that counts those of these events that the eye has seen.
struct TickCounter {
  std::size_t body = 0;  ///< of the scene
  std::vector<Event> ticks;
};

enum class GaugeQuantity : std::uint8_t {
  speed,          ///< v/c in the observer's room
  apparentSpeed,  ///< the speed with which the body is seen to move, over c
  gamma,          ///< the Lorentz factor in the observer's room
  seenLength,     ///< how long the body looks along its motion, over its length at rest
};

/// A plate above a body with its value at the event that is seen.
struct Gauge {
  std::size_t body = 0;  ///< of the scene
  GaugeQuantity quantity = GaugeQuantity::speed;
};

/// A plate with a short word that stands at a place of the board.
struct LessonLabel {
  std::string words;
  Vec3 at_m{0.0};
  bool explains = false;  ///< it stands there only while the lesson explains
};

/// An arrow from above to what the wall speaks of.
struct LessonArrow {
  std::optional<std::size_t> body;  ///< of the scene, as it is seen
  Vec3 at_m{0.0};                   ///< without a body, the place of the board
  bool explains = false;            ///< it stands there while the lesson explains, and not while it shows
};

/// A straight line on the cloth, at rest.
struct ClothLine {
  Vec3 from_m{0.0}, to_m{0.0};
};

/// The events along x, through `with`, that are simultaneous with it in a frame: a line on the cloth with the
/// readings of the table's clocks at these events.
struct SimultaneityLine {
  Event with;
  std::optional<Vec3> beta;  ///< of the frame; without it, of the observer's room
  double from_m = 0.0, to_m = 0.0;
};

struct LessonPlan {
  LessonInterval interval;
  std::vector<LessonObserver> observers;
  std::size_t explainedFor = 0;       ///< the velocity with which it explains
  bool offersSpacetime = false;       ///< a button shows the game's spacetime while it explains
  std::vector<std::uint8_t> effects;  ///< that have a button, by their places in kNamedSwitches
  bool holds = false;                 ///< a hand with a force device holds the puck that it points at
  std::vector<Stopwatch> stopwatches;
  std::vector<TickCounter> counters;
  std::vector<Gauge> gauges;
  std::vector<LessonLabel> labels;
  std::vector<LessonArrow> arrows;
  std::vector<ClothLine> lines;
  std::vector<SimultaneityLine> simultaneous;
};

/// The most drawings of each kind that a lesson can have.
inline constexpr std::size_t kMostLessonDrawings = 4;

}  // namespace carom
