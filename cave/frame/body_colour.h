#pragma once
// The colours of bodies, by their names.

#include <cstddef>
#include <string>

#include <glm/vec3.hpp>

namespace carom {

/// Returns the linear colour of a body called `name`. If the name is not a colour, `index` selects one from a
/// palette.
glm::vec3 colourOf(const std::string& name, std::size_t index);

}  // namespace carom
