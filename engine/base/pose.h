#pragma once
// A rigid pose: where something is and how it is turned. Depends on GLM alone, so that devices can
// speak of poses without knowing any relativity.

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace carom {

/// The rigid motion `aFromB`: takes coordinates in frame B to coordinates in frame A.
/// `position_m` is B's origin in A (metres); `orientation` turns B's axes into A's (unit quaternion).
struct Pose {
  glm::dvec3 position_m{0.0};
  glm::dquat orientation{1.0, 0.0, 0.0, 0.0};  // w, x, y, z
};

/// The directions of a person in the room as unit vectors, in the axes of the room, which are those of the
/// rig file.
struct RoomAxes {
  glm::dvec3 right{1.0, 0.0, 0.0};
  glm::dvec3 up{0.0, 1.0, 0.0};
  glm::dvec3 forward{0.0, 0.0, -1.0};
};

/// Takes a point from B's coordinates to A's (metres).
inline glm::dvec3 operator*(const Pose& aFromB, const glm::dvec3& pointInB_m) {
  return aFromB.position_m + aFromB.orientation * pointInB_m;
}

/// Composes two motions; equal frames stand next to each other: aFromC = aFromB * bFromC.
inline Pose operator*(const Pose& aFromB, const Pose& bFromC) {
  return {aFromB * bFromC.position_m, glm::normalize(aFromB.orientation * bFromC.orientation)};
}

inline Pose inverse(const Pose& aFromB) {
  const glm::dquat bFromA = glm::conjugate(aFromB.orientation);
  return {bFromA * -aFromB.position_m, bFromA};
}

}  // namespace carom
