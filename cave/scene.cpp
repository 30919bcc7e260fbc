#include "cave/scene.h"

#include <algorithm>
#include <iterator>

#include "cave/hall_model.h"
#include "cave/puck_model.h"
#include "cave/table_model.h"

namespace carom {
namespace {

constexpr double kLampHeight_m = 1.45;  // above the cloth
constexpr double kOpenPlane_m = 6.0;
constexpr double kAroundTable_m = 5.0;  // the least space between the table and the hall's walls

void append(std::vector<ScenePart>& to, std::vector<ScenePart> parts) {
  std::move(parts.begin(), parts.end(), std::back_inserter(to));
}

}  // namespace

Scene buildScene(const BilliardSetup& setup, std::span<const BodyLooks> pucks,
                 std::span<const BodyLooks> told, const Hall& hall) {
  Scene scene;
  scene.bodyCount = 1 + pucks.size() + told.size();
  const glm::dvec2 table_m =
      setup.board ? glm::dvec2(setup.board->length_m, setup.board->width_m) : glm::dvec2(kOpenPlane_m);
  Hall around = hall;
  around.size_m.x = std::max(hall.size_m.x, table_m.x + 2.0 * kAroundTable_m);
  around.size_m.y = std::max(hall.size_m.y, table_m.y + 2.0 * kAroundTable_m);
  const double ceiling_m = around.floor_m + around.size_m.z;
  const double lampHeight_m = std::min(kLampHeight_m, ceiling_m - 0.5);
  for (int i = 0; i < 3; ++i) scene.lamps_m[i] = {(i - 1) * table_m.x / 3.0, 0.0, lampHeight_m};

  append(scene.parts, setup.board ? tableParts(*setup.board, around.floor_m) : openPlaneParts(kOpenPlane_m));
  std::size_t body = kRestingBody + 1;
  for (std::size_t i = 0; i < pucks.size(); ++i, ++body) {
    const glm::vec3 colour = colourOf(pucks[i].name, i);
    if (pucks[i].meshPath.empty()) {
      append(scene.parts, puckParts(pucks[i].radius_m, pucks[i].height_m, body, colour));
    } else {
      scene.parts.push_back(meshPart(pucks[i].meshPath, pucks[i].radius_m, body, colour));
    }
  }
  for (std::size_t i = 0; i < told.size(); ++i, ++body) {
    const glm::vec3 colour = colourOf(told[i].name, i);
    scene.parts.push_back(told[i].meshPath.empty()
                              ? rodPart(body, colour)
                              : meshPart(told[i].meshPath, told[i].radius_m, body, colour));
  }
  // Last what is behind all else, so that most of it is found hidden before it is painted.
  append(scene.parts, lampParts(scene.lamps_m, ceiling_m));
  append(scene.parts, hallParts(around, table_m));
  return scene;
}

}  // namespace carom
