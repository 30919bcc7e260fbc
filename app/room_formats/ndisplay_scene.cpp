#include "app/room_formats/ndisplay_scene.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/trigonometric.hpp>

#include "app/room_checks/foreign_room.h"

namespace carom {
namespace {

constexpr std::size_t kDeepestScene = 64;

}  // namespace

/// The rows of Unreal's FRotationMatrix are the directions of the turned axes:
/// x = (cP cY, cP sY, sP), y = (sR sP cY − cR sY, sR sP sY + cR cY, −sR cP),
/// z = (−(cR sP cY + sR sY), cY sR − cR sP sY, cR cP)
/// (RotationTranslationMatrix.h of Unreal Engine).
glm::dmat3 unrealRotation(double pitch_deg, double yaw_deg, double roll_deg) {
  const double p = glm::radians(pitch_deg), y = glm::radians(yaw_deg), r = glm::radians(roll_deg);
  const double cP = std::cos(p), sP = std::sin(p), cY = std::cos(y), sY = std::sin(y), cR = std::cos(r),
               sR = std::sin(r);
  return {glm::dvec3(cP * cY, cP * sY, sP),
          glm::dvec3(sR * sP * cY - cR * sY, sR * sP * sY + cR * cY, -sR * cP),
          glm::dvec3(-(cR * sP * cY + sR * sY), cY * sR - cR * sP * sY, cR * cP)};
}

void NdisplayScene::add(SceneNode node) {
  const auto [known, isNew] = nodes_.emplace(node.id, node);
  if (isNew) return;
  addError(room_, node.at,
           fmt::format("the name '{}' is taken in line {}, expected another", printable(node.id),
                       known->second.at.line));
}

const SceneNode* NdisplayScene::find(const std::string& id) const {
  const auto found = nodes_.find(id);
  return found == nodes_.end() ? nullptr : &found->second;
}

std::optional<UnrealPlace> NdisplayScene::placeOf(const std::string& id) {
  UnrealPlace place;
  const SceneNode* node = find(id);
  for (std::size_t depth = 0; node; ++depth) {
    place.position_m = node->local.position_m + node->local.matrix * place.position_m;
    place.matrix = node->local.matrix * place.matrix;
    if (node->parent.empty()) return place;
    const SceneNode* parent = find(node->parent);
    if (!parent || parent == node || depth > kDeepestScene) {
      if (refused_.insert(node->id).second) {
        addError(room_, node->parentAt,
                 parent ? fmt::format("'{}' hangs on itself through its parent '{}', expected a tree",
                                      printable(node->id), printable(node->parent))
                        : fmt::format("there is no parent '{}' for '{}'", printable(node->parent),
                                      printable(node->id)));
      }
      return {};
    }
    node = parent;
  }
  return {};
}

std::optional<ReadCorners> NdisplayScene::cornersOf(const std::string& screen) {
  const auto place = placeOf(screen);
  if (!place) return {};
  const SceneNode& node = *find(screen);
  return rectangleAround(turned(place->position_m), turned(place->matrix[1]), turned(place->matrix[2]),
                         node.width_m, node.height_m);
}

void NdisplayScene::tellUnused(const std::vector<std::string>& screens, const std::string& head) const {
  std::set<std::string> used(screens.begin(), screens.end());
  used.insert(head);
  for (const std::string& screen : screens) {
    const SceneNode* node = find(screen);
    for (std::size_t depth = 0; node && depth <= kDeepestScene; ++depth) {
      used.insert(node->id);
      node = find(node->parent);
    }
  }
  for (const auto& [id, node] : nodes_) {
    if (!used.contains(id) && !node.isCamera && !node.isTracked)
      addWarning(room_, node.at,
                 fmt::format("component '{}' is left out: no screen hangs on it", printable(id)));
  }
}

bool NdisplayScene::hangsOn(const std::string& id, const std::string& ancestor) const {
  const SceneNode* node = find(id);
  for (std::size_t depth = 0; node && depth <= kDeepestScene; ++depth) {
    if (node->parent == ancestor) return true;
    node = find(node->parent);
  }
  return false;
}

}  // namespace carom
