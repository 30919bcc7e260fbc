#pragma once
// Checks whether a setup can be played.

#include "engine/game/billiard_setup.h"

namespace carom {

/// The least share of a puck's mass in its rim: with much less, rounding decides how fast a rough kick turns
/// it.
inline constexpr double kLeastInertia = 1e-6;

/// Throws std::invalid_argument, which names the pucks and the values, for a setup that cannot be played (see
/// `Billiard`).
void checkSetup(const BilliardSetup& setup);

/// Checks one stroke likewise; `number` is its number in messages. The game checks its arrival.
void checkStroke(const BilliardSetup& setup, const Stroke& stroke, std::size_t number);

/// Whether two pucks overlap as the board shows them at t = 0 (discs as ellipses, R/γ along the motion).
/// What touches does not overlap.
bool overlapOnBoard(const Puck& a, const Puck& b, double c_m_s);

/// Returns how far a puck reaches from its centre along an axis (0: x, 1: y) of the board at t = 0, in the
/// direction of `sign`: a contracted disc, R sqrt(1 − β_n²), or the farthest corner that way.
double extentOnBoard_m(const Puck& puck, int axis, double sign, double c_m_s);

}  // namespace carom
