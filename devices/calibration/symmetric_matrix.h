#pragma once
// Symmetric matrices, of which the normal equations of a fit are made.

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace carom {

/// Returns the eigenvalues, the least first.
glm::dvec3 eigenvaluesOf(const glm::dmat3& symmetric);

/// Returns the eigenvector of length 1 to the largest eigenvalue.
glm::dvec4 largestEigenvectorOf(const glm::dmat4& symmetric);

/// Returns the shortest of the x that make |a x - right| least.
glm::dvec3 leastSolution(const glm::dmat3& a, const glm::dvec3& right);

}  // namespace carom
