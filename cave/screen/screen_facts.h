#pragma once
// What a curved screen is like for somebody who stands before it.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/screen/curved_screen.h"

namespace carom {

struct ScreenFacts {
  double width_m = 0.0, height_m = 0.0;            ///< along the screen, through the middle of its window
  double turns_rad = 0.0;                          ///< a cylinder's angle; of others, of its normals
  double leastPerMetre = 0.0, mostPerMetre = 0.0;  ///< pixels of the window
  double nearest_m = 0.0, farthest_m = 0.0;        ///< from the eyes
  double mostIncidence_rad = 0.0;                  ///< between the screen's normal and the line to the eyes
  double covered = 0.0;                            ///< share of the window that shows screen
  double texelsPerPixel = 0.0;  ///< texels of the flat pieces, of a pixel of the window that shows screen
  bool isBehind = false;        ///< the eyes are behind the whole screen
  /// The window's picture runs mirrored over the screen, as for projection from behind it: all of it turns
  /// its back to the eyes, and yet bends round them.
  bool isMirrored = false;
};

/// Returns the sum of the normals of the screen's cells, to the side from which its window is not mirrored.
glm::dvec3 facingOf(const ScreenMesh& mesh);

/// Returns whether a screen bends round the eyes: along its mean normal the middle of its window is farther
/// from them than its mean place, from which both are given, in metres. `facing`: along that normal, of any
/// length and either sign.
bool bendsRound(const glm::dvec3& central_m, const glm::dvec3& eyes_m, const glm::dvec3& facing);

ScreenFacts factsOf(const CurvedScreen& screen, const glm::ivec2& window_px, const glm::dvec3& eyes_m);

}  // namespace carom
