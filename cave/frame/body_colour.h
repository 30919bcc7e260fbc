#pragma once
// The colours of bodies, by their names, and what they can be made of.

#include <cstddef>
#include <string>

#include <glm/vec3.hpp>

namespace carom {

/// What a scripted body with a mesh is made of.
enum class Material {
  lacquer,  ///< of its colour
  metal,    ///< sheets of 10 cm in its colour, riveted together
  wood,     ///< planks along x
};

/// Returns the linear colour of a body called `name`. If the name is not a colour, `index` selects one from a
/// palette.
glm::vec3 colourOf(const std::string& name, std::size_t index);

}  // namespace carom
