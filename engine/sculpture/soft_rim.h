#pragma once
// The rim of a soft puck in spacetime: the nodes of its hull, each with its own history. They are at the
// places of its rows (engine/soft/soft_history.h), between which they move straight and evenly; a puck that
// was rigid before has the history of a rigid one until the first row.

#include <cstddef>
#include <span>
#include <vector>

#include "engine/game/billiard_setup.h"
#include "engine/sculpture/rim_cut.h"
#include "engine/sculpture/spacetime_frame.h"
#include "engine/soft/soft_history.h"
#include "engine/spacetime/world_line.h"

namespace carom {

/// A soft puck that has rows; all of it is kept by reference.
struct SoftRim {
  const SoftHistory& rows;
  const WorldLine* rigid = nullptr;    ///< its motion before the first row, if it was rigid until then
  std::span<const std::size_t> nodes;  ///< of its hull, anticlockwise seen from above
  const Rim& relaxed;                  ///< these nodes in the relaxed body, at its top
  double lightSpeed_m_s = 1.0;
  double top_m() const { return 2.0 * relaxed.front().z; }  ///< the height of the rim on the board
};

/// The nodes of a puck's hull, if it is soft or when it becomes so: all of an outline, and of a disc not more
/// than its tube needs.
struct SoftHull {
  std::vector<std::size_t> nodes;
  Rim relaxed;
};
SoftHull softHullOf(const Puck& puck);

/// The rows by which the events of a span are told, so that they are only made anew where there are others.
struct SliceOfRows {
  std::size_t count = 0;
  double first = 0.0, last = 0.0;  ///< their times
  glm::dvec2 lastCentre{0.0};
  bool isRigid = false;  ///< until the first of them
  bool operator==(const SliceOfRows&) const = default;
};
SliceOfRows rowsOf(const SoftRim& rim, const Span& span);

/// Returns the events of one of the nodes, at the height of the puck's top, from the first to the second
/// board time: at both, and at every row between.
std::vector<Event> softEventsAlong(const SoftRim& rim, std::size_t node, const Span& span);

/// Sets `events` to those of the nodes at a moment of an observer, as cutRim does. `view` is memory that is
/// used again.
void cutSoftRim(const SoftRim& rim, const Event& observation, const Lorentz& headFromBoard, ViewTime moment,
                BodyView& view, std::vector<Event>& events);

}  // namespace carom
