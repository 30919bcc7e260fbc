#pragma once
// The lines, beads and numbers of the sculpture of spacetime: where moments cut its tubes, events, light,
// viewers' own lines, the seconds, and threads to the seen pucks. Its places are those of the room; they are
// clipped to its height.

#include <span>
#include <vector>

#include "cave/marks/mark_buffer.h"
#include "cave/sculpture/sculpture_shape.h"
#include "engine/sculpture/sculpture_place.h"

namespace carom {

/// The parts of the light cone's sheet across the rectangle: of the glass and of the lines on it.
inline constexpr int kSurfaceCells = 12;

/// Memory that is used again.
struct SculptureMemory {
  std::vector<Event> events;
  std::vector<Vec3> points_m;
  std::vector<glm::dvec3> run;
};

/// One eye's look at the sculpture. Its places are drawn from `viewpoint_m`, room frame.
struct SculptureSight {
  const SculptureMap& map;
  const SculptureShape& shape;
  const OwnLines& lines;
  const FrameRecord& record;
  std::span<const GameEvent> events;
  Vec3 viewpoint_m{0.0};
  std::size_t viewer = 0;  ///< whose eye it is
  SculptureMemory& memory;
};

/// Adds all but the threads.
void addSculpture(const SculptureSight& sight, MarkBuffer& batch);

/// Adds a thread from a body's seen rim in the sculpture to where its top is drawn, from the eye.
void addThread(const SculptureSight& sight, const TubeCut& cut, const glm::dvec3& drawn_m, MarkBuffer& batch);

}  // namespace carom
