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

#include "engine/billiard.h"
#include "engine/world_line.h"

namespace carom {

/// How a surface is painted; each is one small fragment shader, cave/shaders/paint_<name>.glsl.
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
  std::string meshPath;   ///< .obj .stl .ply .vtk .vtp; empty: the built-in puck, or for told bodies a rod of
                          ///< 1 m along x
  double radius_m = 0.0;  ///< a puck's mesh is scaled to it; 0: as it is
  double height_m = 0.0;  ///< of the built-in puck
};

/// The hall around the table: its floor's height below the playing surface.
struct Hall {
  double floor_m = -0.75;
  glm::dvec3 size_m{14.0, 12.0, 5.0};
};

/// Bodies are numbered: 0 is everything at rest on the board, then the pucks, then the told bodies, as given.
struct Scene {
  std::vector<ScenePart> parts;
  std::size_t bodyCount = 0;
  std::array<glm::dvec3, 3> lamps_m{};  ///< board frame
};

/// The body of all that rests on the board.
inline constexpr std::size_t kRestingBody = 0;

/// Of `setup` only the board is looked at. Throws std::runtime_error if a mesh file cannot be read or is
/// empty.
Scene buildScene(const BilliardSetup& setup, std::span<const BodyLooks> pucks,
                 std::span<const BodyLooks> told = {}, const Hall& hall = {});

/// The world line of what rests on the board.
inline WorldLine restingWorldLine(double lightSpeed_m_s) { return WorldLine(Knot{}, lightSpeed_m_s); }

}  // namespace carom
