#include "app/stage/scenario_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>
#include <span>
#include <stdexcept>

#include "app/toml/toml_file.h"
#include "cave/frame/bodies.h"
#include "cave/frame/body_colour.h"
#include "cave/mesh_input/mesh_file.h"
#include "cave/mesh_input/mesh_size.h"
#include "cave/mesh_input/polygons.h"
#include "cave/outlines/footprint.h"
#include "cave/scene/puck_model.h"
#include "cave/scene/scene_builder.h"
#include "engine/text/log.h"

namespace carom {

namespace {

std::string pathOf(const std::optional<std::filesystem::path>& mesh) {
  return mesh ? mesh->string() : std::string();
}

/// Returns the distance of a mesh's farthest vertex from the z axis.
double rimOf(vtkPolyData& mesh) {
  double rim_m = 0.0;
  for (vtkIdType i = 0; i < mesh.GetNumberOfPoints(); ++i) {
    std::array<double, 3> place{};
    mesh.GetPoint(i, place.data());
    rim_m = std::max(rim_m, std::hypot(place[0], place[1]));
  }
  return rim_m;
}

/// Returns what a body that moves as told is drawn with, in few triangles.
ScenePart partOf(const ScriptedBody& body) {
  const glm::vec3 any(1.0F);
  const Tessellation undivided{.pixel_rad = 1.0};
  return body.mesh ? meshPart(readMeshFile(body.mesh->string()), 0.0, kRestingBody, any, undivided)
                   : rodPart(kRestingBody, any);
}

/// Throws std::runtime_error if the body's spin would carry a part of its picture round as fast as light.
void checkSpin(const ScriptedBody& body, double c_m_s) {
  const double turn_rad_s = std::abs(body.worldLine.knots().front().spin.omega_rad_s);
  if (turn_rad_s == 0.0) return;
  const ScenePart part = partOf(body);
  const double rim_m = rimOf(*part.mesh);
  if (turn_rad_s * rim_m < c_m_s) return;
  throw std::runtime_error(fmt::format(
      "body '{}': spin_rad_s is {:.6g}, so its farthest point, {:.6g} m from its axis, would move at {:.6g} "
      "c, expected less than {:.6g} rad/s",
      body.name, turn_rad_s, rim_m, turn_rad_s * rim_m / c_m_s, c_m_s / rim_m));
}

/// Returns the mesh files of the scenario, each once.
std::set<std::string> meshesOf(const Scenario& scenario) {
  std::set<std::string> paths;
  for (const auto& mesh : scenario.puckMeshes) paths.insert(mesh ? mesh->file.string() : "");
  for (const ScriptedBody& body : scenario.bodies) paths.insert(pathOf(body.mesh));
  paths.erase("");
  return paths;
}

/// Warns of a mesh that takes more time or memory than an examination may.
void warnOfLarge(const std::string& path) {
  std::error_code failed;
  const double bytes = static_cast<double>(std::filesystem::file_size(path, failed));
  const auto faces = facesIn(path);
  // About, with VTK 9.1: a triangle of a binary STL takes 1.5 µs and 250 bytes.
  constexpr double kPerFace_s = 1.5e-6, kPerFace_bytes = 250.0;
  log::warn(fmt::format(
      "{}:1:1: is large, {:.0f} MB{}, and was not read here: whether it is whole is not known", path,
      1e-6 * bytes,
      faces ? fmt::format(", {} faces: a session takes some {:.1f} s of processor and {:.0f} MB to read it",
                          *faces, kPerFace_s * static_cast<double>(*faces),
                          1e-6 * kPerFace_bytes * static_cast<double>(*faces))
            : std::string(" of a kind that tells its number of faces only when it is read")));
}

/// Returns what stands in the room as spacetime.
SculptedGame sculptedOf(const Scenario& scenario) {
  constexpr double kMargin_m = 0.2, kLeast_m = 0.5;
  const BilliardSetup& setup = scenario.billiard;
  const SculptedBodies shown = sculptedBodies(scenario);
  SculptedGame game;
  game.hasCushions = setup.board.has_value();
  for (const Flash& flash : setup.flashes) game.flashes.push_back(flash.name);
  const auto add = [&](std::size_t body, const Puck& puck) {
    game.bodies.push_back({body, puck, colourOf(puck.name, body - kFirstPuck)});
    game.top_m = std::max(game.top_m, puck.height_m);
  };
  for (const std::size_t i : shown.pucks) add(kFirstPuck + i, setup.pucks[i]);
  const double topOfPucks_m = game.top_m;
  for (const std::size_t i : shown.bodies)
    add(kFirstPuck + setup.pucks.size() + i, outlineOf(scenario.bodies[i]));
  if (!shown.pucks.empty()) game.top_m = topOfPucks_m;
  if (setup.board) {
    game.half_m = 0.5 * glm::dvec2(setup.board->length_m, setup.board->width_m);
    return game;
  }
  game.half_m = glm::dvec2(kLeast_m);
  for (const std::size_t i : shown.pucks)
    game.half_m = glm::max(game.half_m, glm::abs(setup.pucks[i].position_m) + kMargin_m);
  return game;
}

}  // namespace

SculptedBodies sculptedBodies(const Scenario& scenario) {
  const std::vector<Puck>& pucks = scenario.billiard.pucks;
  SculptedBodies shown;
  for (std::size_t i = 0; i < pucks.size(); ++i) shown.pucks.push_back(i);
  const auto away_m = [&](std::size_t i) { return glm::length(pucks[i].position_m); };
  std::stable_sort(shown.pucks.begin(), shown.pucks.end(),
                   [&](std::size_t a, std::size_t b) { return away_m(a) < away_m(b); });
  shown.pucks.resize(std::min(shown.pucks.size(), kMostSculpted));
  std::sort(shown.pucks.begin(), shown.pucks.end());
  const std::size_t bodies = std::min(scenario.bodies.size(), kMostSculpted - shown.pucks.size());
  for (std::size_t i = 0; i < bodies; ++i) shown.bodies.push_back(i);
  shown.leftOut = pucks.size() + scenario.bodies.size() - shown.pucks.size() - bodies;
  return shown;
}

Puck outlineOf(const ScriptedBody& body) {
  constexpr double kLine_m = 0.02;
  constexpr std::uintmax_t kMost_bytes = 16U << 20U;
  Puck puck;
  puck.name = body.name;
  puck.radius_m = kLine_m;
  std::error_code failed;
  if (!body.isDrawn || (body.mesh && std::filesystem::file_size(*body.mesh, failed) > kMost_bytes))
    return puck;
  const ScenePart part = partOf(body);
  std::vector<glm::dvec2> corners;
  double top_m = 0.0;
  forEachPolygon(*part.mesh->GetPolys(), [&](std::span<const vtkIdType> ids) {
    for (const vtkIdType id : ids) {
      glm::dvec3 place{0.0};
      part.mesh->GetPoint(id, &place.x);
      corners.emplace_back(place.x, place.y);
      top_m = std::max(top_m, place.z);
    }
  });
  try {
    const Footprint footprint = footprintOf(corners);
    for (const glm::dvec2& corner : footprint.corners) puck.outline_m.push_back(footprint.centre + corner);
  } catch (const std::runtime_error&) {
    return puck;  // seen from above it is a line, or has too many corners
  }
  puck.radius_m = 0.0;
  for (const Vec2& corner : puck.outline_m) puck.radius_m = std::max(puck.radius_m, glm::length(corner));
  puck.height_m = 2.0 * top_m;
  return puck;
}

Tessellation tessellationFor(const Rig& rig, bool inSoftware) {
  // Eight views of half a million vertices take a few milliseconds on a GPU, and a second on two CPU cores.
  constexpr std::size_t kMostOnCard = 500000;
  Tessellation tessellation;
  tessellation.pixel_rad = finestPixel_rad(drawnWalls(rig), rig.axes.up * kStandingEyes_m);
  if (!inSoftware) tessellation.mostVertices = kMostOnCard;
  return tessellation;
}

Scene sceneOf(const Scenario& scenario, const Tessellation& tessellation) {
  std::vector<BodyLooks> pucks;
  for (std::size_t i = 0; i < scenario.billiard.pucks.size(); ++i) {
    const Puck& puck = scenario.billiard.pucks[i];
    const std::optional<PuckMesh>& mesh = scenario.puckMeshes[i];
    pucks.push_back({puck.name, mesh ? mesh->file.string() : "", puck.radius_m, puck.height_m, puck.outline_m,
                     mesh ? mesh->place : std::nullopt, mesh ? mesh->sectors : 0});
  }
  std::vector<BodyLooks> told;
  for (const ScriptedBody& body : scenario.bodies)
    told.push_back({.name = body.name,
                    .meshPath = pathOf(body.mesh),
                    .isDrawn = body.isDrawn,
                    .material = body.material});
  Hall hall;
  hall.floor_m = scenario.observer.position_m.z;
  hall.lamps = scenario.lamps;
  Scene scene = buildScene(scenario.billiard, pucks, told, hall, tessellation);
  for (std::size_t i = 0; i < scenario.told.size(); ++i) {
    const ToldBody& body = scenario.told[i];
    const auto shape = std::make_shared<const ToldShape>(ToldShape{body.history, body.triangles});
    scene.soft.push_back(toldModel(shape, colourOf(body.name, told.size() + i)));
  }
  for (const Pulse& pulse : scenario.pulses) scene.pulses.push_back({pulse.at_s, pulse.path_m});
  for (const Flash& flash : scenario.billiard.flashes) scene.flashes.push_back(flash.name);
  if (scenario.lesson) scene.lesson = scenario.lesson->plan;
  scene.sculpted = sculptedOf(scenario);
  scene.ruler = rulerBeside(scenario.billiard, scenario.observer.position_m);
  return scene;
}

void openMeshes(const Scenario& scenario) {
  std::vector<InputError> faults;
  for (const std::string& path : meshesOf(scenario)) {
    constexpr std::uintmax_t kSmall = 8U << 20U;
    std::error_code unknown;
    if (const auto bytes = std::filesystem::file_size(path, unknown); !unknown && bytes > kSmall)
      log::note(fmt::format("Opening {}, {} MiB.", path, bytes >> 20U));
    try {
      openMeshFile(path);
    } catch (const InputError& fault) {
      faults.push_back(fault);
    }
  }
  if (!faults.empty()) throw InputErrors(std::move(faults));
  for (const ScriptedBody& body : scenario.bodies) checkSpin(body, scenario.billiard.lightSpeed_m_s);
}

void examineMeshes(const Scenario& scenario) {
  constexpr std::uintmax_t kMostExamined = 16U << 20U;
  std::set<std::string> large;
  std::vector<InputError> faults;
  for (const std::string& path : meshesOf(scenario)) {
    std::error_code failed;
    try {
      const bool isSmall = !(std::filesystem::file_size(path, failed) > kMostExamined) || failed;
      if (isSmall) readMeshFile(path);
      if (isSmall) continue;
    } catch (const MeshTooLarge&) {  // is told like a large file
    } catch (const InputError& fault) {
      faults.push_back(fault);
      continue;
    }
    large.insert(path);
    warnOfLarge(path);
  }
  if (!faults.empty()) throw InputErrors(std::move(faults));
  for (const ScriptedBody& body : scenario.bodies)
    if (!large.contains(pathOf(body.mesh))) checkSpin(body, scenario.billiard.lightSpeed_m_s);
}

std::vector<SeenBody> seenBodies(const Scenario& scenario, std::span<const WorldLine> pucks,
                                 std::span<const SoftPast> soft) {
  std::vector<SeenBody> bodies{{"table and hall", restingWorldLine(scenario.billiard.lightSpeed_m_s)}};
  for (std::size_t i = 0; i < pucks.size(); ++i)
    bodies.push_back({scenario.billiard.pucks[i].name, pucks[i]});
  for (const ScriptedBody& body : scenario.bodies) bodies.push_back({body.name, body.worldLine});
  for (std::size_t i = 0; i < std::min(bodies.size(), soft.size()); ++i)
    bodies[i].rows = soft[i].rows.rowCount() > 0 ? &soft[i].rows : nullptr;
  return bodies;
}

namespace {

/// Plays the scenario up to a board time. Returns the rows of its soft pucks, of every body of its scene or
/// none.
std::vector<SoftPast> softUntil(const Scenario& scenario, double until_s) {
  const auto isSoft = [](const Puck& puck) { return puck.soft.has_value(); };
  const std::vector<Puck>& pucks = scenario.billiard.pucks;
  if (std::none_of(pucks.begin(), pucks.end(), isSoft)) return {};
  Billiard billiard(scenario.billiard);
  billiard.advanceTo(until_s);
  SoftRows made;
  billiard.takeSoftRows(made);
  std::vector<SoftPast> soft(kFirstPuck + pucks.size());
  std::size_t first = 0;
  for (const SoftRow& row : made.rows) {
    soft[kFirstPuck + row.body].rows.append(row, std::span(made.nodes).subspan(first, row.nodes));
    first += row.nodes;
  }
  return soft;
}

}  // namespace

std::string seenSceneVtp(const Scenario& scenario, std::span<const WorldLine> pucks, const Event& observation,
                         const Lorentz& headFromBoard) {
  openMeshes(scenario);
  const std::vector<SoftPast> soft = softUntil(scenario, observation.t_s);
  const SeenMesh seen =
      seenMesh(sceneOf(scenario, {}), seenBodies(scenario, pucks, soft), observation, headFromBoard);
  log::note(fmt::format("The seen scene: {} points; {} are unseen, and {} triangles with them.",
                        seen.mesh->GetNumberOfPoints(), seen.unseenPoints, seen.unseenTriangles));
  return vtpText(seen);
}

}  // namespace carom
