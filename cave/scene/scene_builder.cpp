#include "cave/scene/scene_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <string>
#include <tuple>

#include <fmt/format.h>
#include <vtkMath.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cave/frame/bodies.h"
#include "cave/frame/body_colour.h"
#include "cave/mesh/surface_tiles.h"
#include "cave/mesh_input/mesh_file.h"
#include "cave/mesh_input/polygons.h"
#include "cave/scene/hall_model.h"
#include "cave/scene/outline_model.h"
#include "cave/scene/puck_model.h"
#include "cave/scene/shadow_model.h"
#include "cave/scene/table_model.h"
#include "engine/game/soft_puck_mesh.h"

namespace carom {
namespace {

constexpr double kLampHeight_m = 1.45;  // above the cloth
constexpr double kOpenPlane_m = 6.0;

void append(std::vector<ScenePart>& to, std::vector<ScenePart> parts) {
  std::move(parts.begin(), parts.end(), std::back_inserter(to));
}

std::size_t verticesOf(std::span<const ScenePart> parts) {
  std::size_t count = 0;
  for (const ScenePart& part : parts) count += static_cast<std::size_t>(part.mesh->GetNumberOfPoints());
  return count;
}

double longestEdgeOf(vtkPolyData& mesh) {
  double longest2 = 0.0;
  forEachPolygon(*mesh.GetPolys(), [&](std::span<const vtkIdType> corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      std::array<double, 3> a{}, b{};
      mesh.GetPoint(corners[i], a.data());
      mesh.GetPoint(corners[(i + 1) % corners.size()], b.data());
      longest2 = std::max(longest2, vtkMath::Distance2BetweenPoints(a.data(), b.data()));
    }
  });
  return std::sqrt(longest2);
}

double longestEdgeOf(std::span<const ScenePart> parts) {
  double longest_m = 0.0;
  for (const ScenePart& part : parts) longest_m = std::max(longest_m, longestEdgeOf(*part.mesh));
  return longest_m;
}

/// Notes how long the cells of coarser meshes are: a triangle lies within a circle of 1/√3 of its longest
/// edge, as cells 2/√3 times as long do.
void measureCoarser(std::span<ScenePart> parts) {
  for (ScenePart& part : parts)
    for (CoarserMesh& coarser : part.coarser)
      coarser.cell_m = 2.0 / std::sqrt(3.0) * longestEdgeOf(*coarser.mesh);
}

double reachOf(std::span<const ScenePart> parts) {
  double reach_m = 0.0;
  for (const ScenePart& part : parts) {
    for (vtkIdType i = 0; i < part.mesh->GetNumberOfPoints(); ++i) {
      std::array<double, 3> place{};
      part.mesh->GetPoint(i, place.data());
      reach_m = std::max(reach_m, vtkMath::Norm(place.data()));
    }
  }
  return reach_m;
}

/// The parts that rest on the board.
struct Resting {
  std::vector<ScenePart> table;
  std::vector<ScenePart> hall;
};

Resting restingParts(const BilliardSetup& setup, const Hall& hall, std::span<const glm::dvec3> lamps_m) {
  Resting resting;
  resting.table = setup.board ? tableParts(*setup.board, hall.floor_m) : openPlaneParts(kOpenPlane_m);
  resting.hall = lampParts(lamps_m, hall.floor_m + hall.size_m.z);
  append(resting.hall, hallParts(hall));
  return resting;
}

/// Notes parts that rest, which have levels.
void addNote(Scene& scene, const std::string& name, std::span<const ScenePart> parts) {
  const std::size_t vertices = verticesOf(parts);
  scene.notes.push_back({"The", name, vertices, vertices, 0, longestEdgeOf(parts) / kMostParts});
}

/// Returns the size of cells whose diagonals are the longest edges.
double cellOf(const Tessellation& tessellation) { return tessellation.edge_m() / std::sqrt(2.0); }

/// Returns the finest parts of a body, with cells no smaller than `finest_m`, that have at most `most`
/// vertices; otherwise the coarsest that `build` makes.
template <typename Build>
std::vector<ScenePart> finestPartsWithin(std::size_t most, double finest_m, const Build& build) {
  constexpr double kLeastStep = 1.1;
  constexpr double kCoarsest_m = 1.0;
  for (double cell_m = finest_m; cell_m < kCoarsest_m;) {
    std::vector<ScenePart> parts = build(cell_m);
    const double share =
        static_cast<double>(verticesOf(parts)) / static_cast<double>(std::max<std::size_t>(1, most));
    if (share <= 1.0) return parts;
    cell_m *= std::max(kLeastStep, std::sqrt(share));  // counts grow at most as 1/cell²
  }
  return build(kAnyCell_m);
}

/// A body as it will be drawn, and its number of vertices without slow light.
struct BuiltBody {
  std::vector<ScenePart> parts;
  std::size_t vertices = 0;
  double longestEdge_m = 0.0;
  double reach_m = 0.0;
};

/// Returns the shadow of a puck with corners; none without.
std::vector<ScenePart> shadowsOf(const BodyLooks& looks, std::size_t body, const Tessellation& tessellation) {
  constexpr double kLeastCell = 0.1;  // of the radius
  if (looks.outline_m.empty()) return {};
  const double cell_m = std::max(cellOf(tessellation), kLeastCell * looks.radius_m);
  return {outlineShadow(looks.outline_m, looks.height_m, body, cell_m)};
}

/// Builds body number `body` from `looks`; `model(cell_m)` makes it if it has no mesh file.
template <typename Model>
BuiltBody buildBody(const BodyLooks& looks, std::size_t body, const glm::vec3& colour,
                    const Tessellation& tessellation, const Model& model) {
  if (!looks.meshPath.empty()) {
    const auto mesh = readMeshFile(looks.meshPath);
    BuiltBody built{shadowsOf(looks, body, tessellation),
                    static_cast<std::size_t>(mesh->GetNumberOfPoints())};
    built.parts.push_back(meshPart(mesh, looks.radius_m, body, colour, tessellation, looks.meshPlace));
    if (looks.sectors > 0) paintSectors(built.parts.back(), looks.sectors, looks.radius_m);
    paintMaterial(built.parts.back(), looks.material);
    return built;
  }
  if (!looks.outline_m.empty()) {
    const auto prism = prismOver(looks.outline_m, looks.height_m);
    BuiltBody built{shadowsOf(looks, body, tessellation),
                    static_cast<std::size_t>(prism->GetNumberOfPoints())};
    built.parts.push_back(surfacePart(prism, body, colour, tessellation));
    return built;
  }
  return {finestPartsWithin(tessellation.mostVertices, cellOf(tessellation), model),
          verticesOf(model(kAnyCell_m)), 0.0, 0.0};
}

/// Bodies that look alike but for their colour share their meshes: each is built once.
class BuiltBodies {
 public:
  /// Returns the parts of body number `body`; `build` makes it if none like it has been built.
  template <typename Build>
  const BuiltBody& of(const BodyLooks& looks, std::size_t body, const glm::vec3& colour, const Build& build) {
    const auto [found, isNew] = built_.try_emplace(
        std::tuple(looks.meshPath, looks.radius_m, looks.height_m, outlineOf(looks),
                   looks.meshPlace ? looks.meshPlace->scale : 0.0, looks.sectors, looks.material));
    BuiltBody& like = found->second;
    if (isNew) {
      like = build();
      like.longestEdge_m = longestEdgeOf(like.parts);
      measureCoarser(like.parts);
      like.reach_m = reachOf(like.parts);
    }
    for (ScenePart& part : like.parts) {
      part.body = body;
      if (part.paint != Paint::shadow) part.colour = colour;
    }
    return like;
  }

 private:
  static std::vector<std::pair<double, double>> outlineOf(const BodyLooks& looks) {
    std::vector<std::pair<double, double>> corners;
    for (const glm::dvec2& corner_m : looks.outline_m) corners.emplace_back(corner_m.x, corner_m.y);
    return corners;
  }

  std::map<
      std::tuple<std::string, double, double, std::vector<std::pair<double, double>>, double, int, Material>,
      BuiltBody>
      built_;
};

/// Returns how long the shadows of pucks on a table can be, in heights of the puck. Light from a lamp that is
/// H above and ρ beside the puck's upper rim reaches the cloth ρ/H heights beside the rim; while it falls,
/// for √(1 + ρ²/H²) heights, the puck goes no further than that.
double longestShadowOn(const glm::dvec2& table_m, std::span<const glm::dvec3> lamps_m,
                       std::span<const BodyLooks> pucks) {
  constexpr double kBeyond_m = 1.0;  // no point of a puck is drawn so far from its table, stretched or not
  double highest_m = 0.0, longest = 0.0;
  for (const BodyLooks& puck : pucks) highest_m = std::max(highest_m, puck.height_m);
  for (const glm::dvec3& lamp_m : lamps_m) {
    const glm::dvec2 corner_m = glm::abs(glm::dvec2(lamp_m)) + 0.5 * table_m + kBeyond_m;
    const double above_m = lamp_m.z - highest_m;
    if (above_m <= 0.0) return kLongestShadow;
    longest = std::max(longest, 2.0 * glm::length(glm::dvec3(corner_m, above_m)) / above_m);
  }
  return std::min(longest, kLongestShadow);
}

void addBodies(Scene& scene, std::span<const BodyLooks> pucks, std::span<const BodyLooks> told,
               const Tessellation& tessellation) {
  Tessellation shared = tessellation;
  shared.mostVertices /= std::max<std::size_t>(1, pucks.size() + told.size());
  std::size_t body = kRestingBody;
  const auto add = [&](const char* kind, const BodyLooks& looks, const BuiltBody& built) {
    scene.notes.push_back({kind, looks.name, built.vertices, verticesOf(built.parts), shared.mostVertices,
                           built.longestEdge_m});
    scene.reach_m.push_back(built.reach_m);
    append(scene.parts, built.parts);
  };
  BuiltBodies builtPucks, builtTold;
  for (std::size_t i = 0; i < pucks.size(); ++i) {
    const BodyLooks& puck = pucks[i];
    const glm::vec3 colour = colourOf(puck.name, i);
    ++body;
    add("Puck", puck, builtPucks.of(puck, body, colour, [&] {
      return buildBody(puck, body, colour, shared, [&](double cell_m) {
        return puckParts(puck.radius_m, puck.height_m, body, colour, cell_m);
      });
    }));
  }
  for (std::size_t i = 0; i < told.size(); ++i) {
    const glm::vec3 colour = told[i].material == Material::wood ? kPineColour : colourOf(told[i].name, i);
    ++body;
    if (!told[i].isDrawn) {
      scene.reach_m.push_back(0.0);
      continue;
    }
    add("Body", told[i], builtTold.of(told[i], body, colour, [&] {
      return buildBody(told[i], body, colour, shared,
                       [&](double cell_m) { return std::vector<ScenePart>{rodPart(body, colour, cell_m)}; });
    }));
  }
}

/// Adds the soft models of all pucks if one of them is soft: then all of them can become so.
void addSoftModels(Scene& scene, const BilliardSetup& setup, std::span<const BodyLooks> looks) {
  const auto isSoft = [](const Puck& puck) { return puck.soft.has_value(); };
  if (std::none_of(setup.pucks.begin(), setup.pucks.end(), isSoft)) return;
  for (std::size_t i = 0; i < setup.pucks.size(); ++i) {
    const Puck& puck = setup.pucks[i];
    scene.soft.push_back(softModel(softMeshOf(puck), puck.outline_m.empty(), puck.height_m, kFirstPuck + i,
                                   colourOf(looks[i].name, i)));
  }
}

}  // namespace

Scene buildScene(const BilliardSetup& setup, std::span<const BodyLooks> pucks,
                 std::span<const BodyLooks> told, const Hall& hall, const Tessellation& tessellation) {
  Scene scene;
  scene.bodyCount = 1 + pucks.size() + told.size();
  for (const Puck& puck : setup.pucks) scene.coldMasses_kg.push_back(puck.mass_kg);
  const glm::dvec2 table_m =
      setup.board ? glm::dvec2(setup.board->length_m, setup.board->width_m) : glm::dvec2(kOpenPlane_m);
  scene.hall = hall;
  scene.hall.size_m = {hallFloor_m(table_m, hall), hall.size_m.z};
  const double lampHeight_m = std::min(kLampHeight_m, hall.floor_m + hall.size_m.z - 0.5);
  for (int i = 0; i < 3; ++i) scene.lamps_m[i] = {(i - 1) * table_m.x / 3.0, 0.0, lampHeight_m};
  for (std::size_t i = 0; i < scene.lamps_m.size() && !hall.lamps.empty(); ++i)
    scene.lamps_m[i] = hall.lamps[i < hall.lamps.size() ? i : 0].place_m;
  const auto lamps = std::span(scene.lamps_m).first(hall.lamps.empty() ? 3 : hall.lamps.size());

  if (setup.board) scene.longestShadow = longestShadowOn(table_m, scene.lamps_m, pucks);
  Resting resting = restingParts(setup, scene.hall, lamps);
  addNote(scene, "table", resting.table);
  addNote(scene, "hall", resting.hall);
  scene.reach_m.push_back(std::max(reachOf(resting.table), reachOf(resting.hall)));
  append(scene.casters, resting.table);
  append(scene.casters, resting.hall);

  append(scene.parts, std::move(resting.table));
  addBodies(scene, pucks, told, tessellation);
  addSoftModels(scene, setup, pucks);
  // The background comes last, so that most of it is hidden before it is painted.
  append(scene.parts, std::move(resting.hall));
  return scene;
}

Ruler rulerBeside(const BilliardSetup& setup, const glm::dvec3& person_m) {
  // The ruler is visible over the rail from a metre beside the table, also on a screen that begins at the
  // table's height.
  const double y = setup.board ? 0.25 * setup.board->width_m : 1.0;
  const double side = person_m.y > 0.0 ? 1.0 : -1.0;
  return {{0.5 * side, side * y, 0.0}, {-side, 0.0, 0.0}, {0.0, -side, 0.0}};
}

}  // namespace carom
