#pragma once
// What there is to see: meshes, each fixed to one body, with the paint they wear. Built once.

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <glm/vec3.hpp>

#include "cave/tessellation.h"
#include "engine/billiard.h"
#include "engine/light_path.h"
#include "engine/world_line.h"

namespace carom {

/// How a surface is painted; each is one small fragment shader, cave/shaders/paint_NAME.glsl.
enum class Paint {
  plain,   ///< colour alone
  cloth,   ///< of the table
  wood,    ///< rails, with diamonds
  floor,   ///< tiles
  panels,  ///< walls and ceiling of the hall
  puck,    ///< sectors, rings and rim marks that show how it is deformed
  bands,   ///< of a rod
  shadow,  ///< on the cloth under a puck
  clock,   ///< digits showing the board time at which their light left
  lamp,    ///< shines
};

/// Part of a body. Point data of the mesh: points and normals in the body's rest frame (metres, from its
/// centre) and, for painting, an array "surface" of three floats a point (what they mean is said in the
/// paint's shader).
struct ScenePart {
  std::size_t body = 0;
  vtkSmartPointer<vtkPolyData> mesh;
  Paint paint = Paint::plain;
  glm::vec3 colour{1.0F};  ///< linear light, the share reflected
  float gloss = 0.0F;      ///< strength of the highlight
};

/// How a puck, or a body that moves as told, looks.
struct BodyLooks {
  std::string name;       ///< "white", "yellow", "red" … give the colour; others take one of a palette
  std::string meshPath;   ///< as readMeshFile takes it; empty: the built-in puck, or for told bodies a rod of
                          ///< 1 m along x
  double radius_m = 0.0;  ///< a puck's mesh is scaled to it; 0: as it is
  double height_m = 0.0;  ///< of the built-in puck
};

/// The hall around the table: its floor's height below the playing surface.
struct Hall {
  double floor_m = -0.75;
  glm::dvec3 size_m{14.0, 12.0, 5.0};
};

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

/// The ruler halfway to the near rail of someone who stands on the side of `person_m`; without a board, 1 m from
/// its origin.
Ruler rulerBeside(const BilliardSetup& setup, const glm::dvec3& person_m);

/// Bodies are numbered: 0 is everything at rest on the board, then the pucks, then the told bodies, as given.
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

/// The body of all that rests on the board.
inline constexpr std::size_t kRestingBody = 0;

/// Of `setup` only the board is looked at. Throws MeshFault (cave/mesh_file.h) for a mesh file at fault.
Scene buildScene(const BilliardSetup& setup, std::span<const BodyLooks> pucks,
                 std::span<const BodyLooks> told = {}, const Hall& hall = {},
                 const Tessellation& tessellation = {});

/// What a session says of them, one line for each kind of things and one for all. "Exact to half a pixel" is
/// meant for eyes at least kNearestEye_m away and for heads up to the speed named (cave/tessellation.h).
std::string tessellationReport(const Scene& scene, const Tessellation& tessellation);

/// The same world lines, each body's radius widened to `reach_m[body]` where its points reach further than
/// the physics knows (a mesh taller than its puck): which legs an eye must look at depends on it.
std::vector<WorldLine> reachingTo(std::span<const WorldLine> histories, std::span<const double> reach_m);

/// The world line of what rests on the board.
inline WorldLine restingWorldLine(double lightSpeed_m_s) { return WorldLine(Knot{}, lightSpeed_m_s); }

}  // namespace carom
