#pragma once
// A vertex of a mesh as it is drawn.

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

namespace carom {

/// A vertex as the shaders take it. Body's rest frame, from its centre.
struct MeshVertex {
  glm::vec3 place_m{0.0F};
  glm::vec3 normal{0.0F};
  glm::vec3 surface{0.0F};  ///< for painting
  /// The share of each lamp's light and of the hall's that reaches it, of 255.
  std::array<std::uint8_t, 4> lit{255, 255, 255, 255};
};

}  // namespace carom
