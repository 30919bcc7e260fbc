#pragma once
// Computes how a contact changes the momenta. c = 1; e is the coefficient of restitution.
//
// Puck with puck, with the contact's normal n and P = p1 + p2:
//     k = n − (n·P/U·P) U     q = −2 (p1·k)/(k·k) k     p1' = p1 + (1+e)/2 q     p2' = p2 − (1+e)/2 q
// k·P = 0, so an elastic kick mirrors both momenta and keeps both rest masses; e < 1 gives v_n' = −e v_n in
// the centre-of-mass frame, conserves the total four-momentum exactly and leaves each puck the heavier, m'² =
// m² + (1−e²) (p1·k)²/(−k·k): heat, which it radiates in its rest frame, keeping its velocity and its nominal
// mass. Puck with cushion: radial in the puck's rest frame; v_t' = v_t and v_n' = −e v_n for every e. The
// cushion takes momentum and no energy, so m'² = m² (1 + (1−e²) u_n²).
// Theory: app/doc/physics.md, Kick.

#include <array>
#include <optional>

#include "engine/collision/cushion_contact.h"
#include "engine/spacetime/minkowski.h"

namespace carom {

struct PairKick {
  std::array<Vec21, 2> u;        ///< four-velocities afterwards
  std::array<double, 2> heat{};  ///< m' − m of each, in units of mass
  double closing = 0.0;          ///< celerity at which slow pucks closed along the normal
};

/// Returns the kick that two pucks give each other; none if the momenta recede from each other along the
/// normal.
std::optional<PairKick> kickPair(const Vec21& U, const Vec21& n, const std::array<Vec21, 2>& u,
                                 const std::array<double, 2>& mass, double restitution);

struct CushionKick {
  Vec21 u;
  double heat = 0.0;
  double closing = 0.0;  ///< celerity at which what touched closed on the cushion
};

/// Returns the kick that a cushion gives; none if the puck does not move towards it.
std::optional<CushionKick> kickOffCushion(const CushionPlane& cushion, const Vec21& u, double mass,
                                          double restitution);

}  // namespace carom
