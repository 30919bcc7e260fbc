#pragma once
// Shadows of pucks on the cloth.
//
// A shadow is old: light that would have lit the cloth beside the puck passed the puck's top, 2 cm higher,
// at least 14 ms earlier. At 0.9 c the puck was then 18 mm further back, which is 10 pixels for a person 1.5
// m away, so a shape straight below the puck would be wrong. While the puck moves straight, each lamp's
// shadow moves with it, and the vertex shader (body_vert.glsl, `shadowed`) places it where it is, and where
// it is seen. After a bounce the shadow follows the puck's centre at once, 14 ms too early.

#include <cstddef>
#include <span>

#include <glm/vec2.hpp>

#include "cave/scene/scene_part.h"

namespace carom {

inline constexpr double kShadowAboveCloth_m = 0.0005;
/// Each of the three lamps throws a shadow of its own, and the hall's light another.
inline constexpr int kShadowLights = 4, kShadowOfHall = 3;
/// For a lamp of 0.22 m radius 1.45 m above, the upper rim's shadow is soft over ±0.15 of its height.
inline double shadowSoftOf_m(double height_m) { return 0.15 * height_m; }
/// How far the shadow of the hall's light reaches from the rim.
inline double hallShadowReachOf_m(double height_m) { return 0.9 * height_m; }

/// Returns the shadow of a disc, in cells no larger than `cell_m`: the fraction that it takes from the
/// cloth's light of each lamp (0 to 2) and of the hall (3), in this order in surface.y. surface.x is 0 where
/// all of that light is hidden and 1 where none is; surface.z is the puck's height. Normals point out of the
/// puck: where they point away from the light, the shader places the far side of the shadow.
ScenePart discShadow(double radius_m, double height_m, std::size_t body, double cell_m);

/// Returns the shadow of a prism over an outline (engine/polygons/outline.h). Where the shadow of one side
/// falls into a dent and on that of another, it is drawn twice.
ScenePart outlineShadow(std::span<const glm::dvec2> corners_m, double height_m, std::size_t body,
                        double cell_m);

}  // namespace carom
