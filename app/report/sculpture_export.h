#pragma once
// Writes sculptures as meshes. In the library that is loaded when it is used (app/report/report_library.h).

#include <span>
#include <string>

#include <glm/vec3.hpp>

#include "engine/sculpture/game_sculpture.h"

namespace carom {

/// How a part of a sculpture looks.
struct SculptureLook {
  glm::vec3 colour;
  float opacity = 1.0F, roughness = 0.5F;
};

struct SculptureFormat {
  const char* id = "";  ///< assimp's name
  bool forPrinters = false;
  bool facets = false;  ///< triangles that share no corners
};

/// Writes a file of this name, as each part looks. Returns whether it could.
bool exportSculpture(const GameSculpture& sculpture, std::span<const SculptureLook> looks,
                     const SculptureFormat& format, const std::string& file);

}  // namespace carom
