#pragma once
// What there is to see: meshes, each fixed to one body, with the paint they wear. Built once.

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "cave/mesh/tessellation.h"
#include "cave/scene/scene_part.h"
#include "engine/light/light_path.h"
#include "engine/spacetime/world_line.h"

namespace carom {

/// How a kind of things was divided, for the person.
struct MeshNote {
  std::string kind;            ///< "Puck", "Body" or, at rest, "The"
  std::string name;            ///< "red"
  std::size_t vertices = 0;    ///< as they would be without slow light
  std::size_t divided = 0;     ///< and as they are drawn
  std::size_t most = 0;        ///< they may become
  double longestEdge_m = 0.0;  ///< then
};

/// A metre on the cloth: from `from_m` along the unit vector, its light's marks on the side of `aside`. Board
/// frame.
struct Ruler {
  glm::dvec3 from_m{-0.5, -1.0, 0.0};
  glm::dvec3 along{1.0, 0.0, 0.0}, aside{0.0, 1.0, 0.0};
};

/// Its bodies are numbered as cave/frame/bodies.h says.
struct Scene {
  std::vector<ScenePart> parts;
  std::size_t bodyCount = 0;
  /// Of each body: how far from its centre its points reach (its world line's radius).
  std::vector<double> reach_m;
  std::vector<MeshNote> notes;          ///< table, hall, then each body
  std::array<glm::dvec3, 3> lamps_m{};  ///< board frame
  std::vector<LightPath> pulses;
  Ruler ruler;
};

/// What a session says of them, one line for each kind of things and one for all. "Exact to half a pixel" is
/// meant for eyes at least kNearestEye_m away and for heads up to the speed named (cave/mesh/tessellation.h).
std::string tessellationReport(const Scene& scene, const Tessellation& tessellation);

/// The same world lines, each body's radius widened to `reach_m[body]` where its points reach further than
/// the physics knows (a mesh taller than its puck): which legs an eye must look at depends on it.
std::vector<WorldLine> reachingTo(std::span<const WorldLine> histories, std::span<const double> reach_m);

}  // namespace carom
