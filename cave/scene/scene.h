#pragma once
// The visible scene: meshes, each fixed to one body, with their paint. It is built once.

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "cave/frame/hall.h"
#include "cave/frame/lesson_plan.h"
#include "cave/mesh/tessellation.h"
#include "cave/scene/scene_part.h"
#include "cave/scene/soft_model.h"
#include "engine/game/billiard_setup.h"
#include "engine/light/light_path.h"
#include "engine/spacetime/world_line.h"

namespace carom {

/// How a kind of objects was divided, for a message to the person.
struct MeshNote {
  std::string kind;          ///< "Puck", "Body" or, at rest, "The"
  std::string name;          ///< "red"
  std::size_t vertices = 0;  ///< without the division that slow light needs
  std::size_t divided = 0;   ///< as they are drawn
  std::size_t most = 0;      ///< the most that are allowed; none of what rests, which is divided for each eye
  double longestEdge_m = 0.0;  ///< after the division; of what rests, of its finest level
};

/// A metre on the cloth: it starts at `from_m` and goes along the unit vector `along`; light's marks are on
/// the side of `aside`. Board frame.
struct Ruler {
  glm::dvec3 from_m{-0.5, -1.0, 0.0};
  glm::dvec3 along{1.0, 0.0, 0.0}, aside{0.0, 1.0, 0.0};
};

/// Light that falls as flat as it can, 0.05 in cave/bodies/shaders/body_vert.glsl, makes a shadow 20 times as
/// long as the puck is high; its motion may double that.
inline constexpr double kLongestShadow = 40.0;

/// A body whose world tube stands in the room when spacetime is shown.
struct SculptedBody {
  std::size_t body = 0;
  Puck puck;               ///< its outline and height
  glm::vec3 colour{1.0F};  ///< linear light
};

/// What the sculpture of the game's spacetime shows (cave/sculpture/room_sculpture.h).
struct SculptedGame {
  std::vector<SculptedBody> bodies;
  glm::dvec2 half_m{1.0};  ///< from the board's middle to its cushions, or to the pucks
  bool hasCushions = false;
  double top_m = 0.0;                ///< height of the plane of the pucks' tops
  std::vector<std::string> flashes;  ///< the names of the game's flashes, in their order
};
inline constexpr std::size_t kMostSculpted = 100;

/// Its bodies are numbered as cave/frame/bodies.h says.
struct Scene {
  std::vector<ScenePart> parts;
  std::size_t bodyCount = 0;
  /// The first body of people of another room, which come last (cave/scene/person_model.h); 0: there are
  /// none.
  std::size_t firstPerson = 0;
  /// For each body, how far its points reach from its centre (the radius of its world line).
  std::vector<double> reach_m;
  std::vector<double> coldMasses_kg;    ///< of the pucks, in the order of the setup
  std::vector<MeshNote> notes;          ///< table, hall, then each body
  std::array<glm::dvec3, 3> lamps_m{};  ///< board frame
  Hall hall;  ///< as large as it is; if it has lamps, `lamps_m` are theirs, the first in place of others
  /// How far the far end of a puck's shadow can be from the puck at most, in heights of the puck.
  double longestShadow = kLongestShadow;
  std::vector<ScenePart>
      casters;                  ///< table and hall, undivided: what throws shadows (cave/scene/baked_light.h)
  std::vector<SoftModel> soft;  ///< of the bodies that are soft or can become so, in their order
  SculptedGame sculpted;
  std::vector<LightPath> pulses;
  Ruler ruler;
  std::vector<std::string> flashes;  ///< the names of the game's flashes, in their order
  LessonPlan lesson;
};

/// Returns how far each body reaches along x, without its shadow: the radius of a round body.
std::vector<double> rimsOf(const Scene& scene);

/// Returns a session's message about the division, one line for each kind of objects and one for all. "Exact
/// to half a pixel" holds for eyes at least kNearestEye_m away, of what rests at least as far as it says, and
/// for heads up to the speed named (cave/mesh/tessellation.h).
std::string tessellationReport(const Scene& scene, const Tessellation& tessellation);

/// Returns the same world lines, each with its body's radius widened to `reach_m[body]` if the mesh reaches
/// further than the physics knows (a mesh taller than its puck). The radius decides which legs an eye must
/// examine.
std::vector<WorldLine> reachingTo(std::span<const WorldLine> histories, std::span<const double> reach_m);

}  // namespace carom
