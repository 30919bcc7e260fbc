#pragma once
// The colours of bodies, by their names.

#include <cstddef>
#include <string>

#include <glm/vec3.hpp>

namespace carom {

/// Returns the linear colour of a body of this name. A name that is no colour takes one of a palette by
/// `index`.
glm::vec3 colourOf(const std::string& name, std::size_t index);

}  // namespace carom
