#pragma once
// The world tube of a puck: its outline at the height of its top, swept along its world line. Each point of
// the outline has a history of its own (engine/light/vertex_history.h), which the tube follows exactly: where
// the puck turns, the side that is struck turns first.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/game/billiard_setup.h"
#include "engine/light/vertex_history.h"
#include "engine/sculpture/solid.h"
#include "engine/sculpture/spacetime_frame.h"

namespace carom {

/// The histories of points of a puck's top rim, anticlockwise seen from above.
struct WorldTube {
  double c_m_s = 1.0;
  Span span;                                         ///< in which the puck is shown
  std::vector<std::vector<VertexPiece>> generators;  ///< one for each point
};

/// Returns the tube of a rigid puck. `widened` multiplies the distances of the rim's points from the centre;
/// of the points of `rimOf`, each one of `every` is taken.
WorldTube worldTube(const Puck& puck, const WorldLine& line, const Span& span, double widened = 1.0,
                    std::size_t every = 1);

/// Returns the events of a history from the first to the second board time: at both, at every turn between,
/// and where it does not move straight so near that its chords are off by less than `chord_m`.
std::vector<Event> eventsAlong(const std::vector<VertexPiece>& history, const Span& span, double c_m_s,
                               double chord_m = 1e-4);

/// Adds the triangles between the events of neighbouring generators, in the order of their board times. The
/// events are numbered from `first` on, generator by generator.
void addSides(const std::vector<std::vector<Event>>& events, std::uint32_t first,
              std::vector<std::array<std::uint32_t, 3>>& triangles);

/// Returns the places of the rim's points in the centre's rest frame, anticlockwise seen from above: of a
/// disc or of an outline.
std::vector<Vec2> rimOf(const Puck& puck);

/// Returns of how many of these points one may be taken, so that chords of a disc's rim are nowhere off by
/// more than `fine_m`: R (1 − cos(π/n)). An outline keeps its corners, and small ones nothing else.
std::size_t everyFor(const Puck& puck, double fine_m);

/// Returns the tube as a closed surface in a frame: the events of neighbouring generators, joined by
/// triangles in the order of their board times, with a lid at each end.
SolidMesh solidOf(const WorldTube& tube, const SpacetimeFrame& frame);

}  // namespace carom
