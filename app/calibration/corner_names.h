#pragma once
// The corners of a rig's walls by name: "front.lower_left".

#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "app/rig/rig.h"

namespace carom {

struct NamedCorner {
  std::string name;                  ///< "front.lower_left"
  std::vector<std::string> aliases;  ///< the same place on other walls: "left.lower_right"
  glm::dvec3 at_m{0.0};              ///< in the room
  glm::dvec3 normal{0.0};            ///< of the wall that gives the name, towards the person
};

/// Returns the corners of all walls in the order of the rig. Corners up to 5 mm apart are one place, which
/// has the name of the first.
std::vector<NamedCorner> cornersOf(const Rig& rig);

/// Returns a corner in words: "the lower left corner of wall 'front'".
std::string wordsFor(const NamedCorner& corner);

/// Returns the corners that `names` lists, with commas between them. Throws std::invalid_argument, which
/// names the unknown corner and those of the rig.
std::vector<NamedCorner> chosenCorners(const std::vector<NamedCorner>& corners, std::string_view names);

}  // namespace carom
