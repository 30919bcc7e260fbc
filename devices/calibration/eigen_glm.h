#pragma once
// Vectors and turns for Eigen, which solves the equations of this room.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace carom {

inline Eigen::Vector3d eigenOf(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
inline Eigen::Matrix3d eigenOf(const glm::dquat& q) {
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
}

}  // namespace carom
