#pragma once
// Computes how far an error of the celerity turns what the eye sees.
// Theory: app/doc/physics.md, Aberration and cells.

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace carom {

/// Returns by how much (radians, one standard deviation) the sky swings when a celerity has this covariance:
/// about that of the landmark that swings most. To first order in the error δw of a celerity w = c sinh η:
///
///   δw∥/(cγ) along the motion      (1 + tanh(η/2)) δw⊥/c across it
///
/// Seen from the head, an error is one boost more: by δη = δw∥/(cγ) along the motion and by δw⊥/c across it,
/// and a boost by δη turns directions by up to δη. One across turns the axes as well, by the Thomas-Wigner
/// angle tanh(η/2) δw⊥/c.
double aberrationError_rad(const glm::dvec3& celerity_m_s, const glm::dmat3& covariance_m2_s2,
                           double lightSpeed_m_s);

}  // namespace carom
