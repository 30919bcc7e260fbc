#pragma once
// The parts that a scene is built from: meshes with their paint, how bodies look, how large the hall is.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/frame/bodies.h"
#include "cave/frame/body_colour.h"
#include "cave/frame/hall.h"
#include "cave/outlines/footprint.h"

namespace carom {

/// How a surface is painted; each is one small fragment shader, cave/bodies/shaders/paint_NAME.glsl.
enum class Paint {
  plain,    ///< colour alone
  cloth,    ///< of the table
  wood,     ///< rails, with diamonds
  floor,    ///< tiles
  panels,   ///< walls and ceiling of the hall
  puck,     ///< sectors, rings and rim marks that show how it is deformed
  soft,     ///< a soft puck's rings and spokes, or its strain or heat
  bands,    ///< of a rod
  metal,    ///< sheets with rivets
  sectors,  ///< around a mesh's axis, alternately in its colour and pale
  shadow,   ///< on the cloth under a puck
  clock,    ///< digits showing the board time at which their light left
  lamp,     ///< shines
};

/// Returns whether a surface of this paint is polished so well that, at rest, it mirrors the lamps and the
/// hall pixel by pixel.
constexpr bool isPolished(Paint paint) { return paint == Paint::floor || paint == Paint::wood; }

/// A mesh for the same part that may stand for it where its cells, up to `cell_m` long and drawn flat, and
/// its shape, off by up to `off_m`, are seen as small as need be.
struct CoarserMesh {
  vtkSmartPointer<vtkPolyData> mesh;
  double cell_m = 0.0;
  double off_m = 0.0;
};

/// Part of a body. The mesh has points and normals in the body's rest frame (metres, from its centre) and,
/// for painting, a point array "surface" of three floats per point, whose meaning the paint's shader
/// explains.
struct ScenePart {
  std::size_t body = 0;
  vtkSmartPointer<vtkPolyData> mesh;
  Paint paint = Paint::plain;
  glm::vec3 colour{1.0F};              ///< linear light, the share reflected
  float roughness = 0.0F;              ///< Trowbridge and Reitz's α of its varnish; 0: it has none
  bool isRound = false;                ///< looks the same however the body has turned
  std::vector<CoarserMesh> coarser{};  ///< for eyes farther and farther away
};

/// How a puck or a scripted body looks.
struct BodyLooks {
  std::string name;      ///< "white", "yellow", "red" … give the colour; others take one of a palette
  std::string meshPath;  ///< as readMeshFile takes it; empty: the built-in puck, or for scripted bodies a rod
                         ///< of 1 m along x
  double radius_m = 0.0;                 ///< a puck's mesh is scaled to it; 0: as it is
  double height_m = 0.0;                 ///< of the built-in puck
  std::vector<glm::dvec2> outline_m{};   ///< corners of the built-in puck; none: a disc
  std::optional<MeshPlace> meshPlace{};  ///< of a mesh that is not scaled to the radius
  int sectors = 0;  ///< an even number, in which a mesh is painted around its axis; 0: it has one colour
  bool isDrawn = true;
  Material material = Material::lacquer;  ///< of a scripted body's mesh
};

}  // namespace carom
