#pragma once
// Checks whether a setup can be played.

#include "engine/billiard/billiard_setup.h"

namespace carom {

/// The least share of a puck's mass in its rim: with much less, rounding decides how fast a rough kick turns it.
inline constexpr double kLeastInertia = 1e-6;

/// Throws std::invalid_argument, which names the pucks and the values, for a setup that cannot be played (see
/// `Billiard`).
void checkSetup(const BilliardSetup& setup);

/// Checks one stroke likewise; `number` is its number in messages. The game checks its arrival.
void checkStroke(const BilliardSetup& setup, const Stroke& stroke, std::size_t number);

/// Whether the discs of two pucks overlap as the board shows them at t = 0 (ellipses, R/γ along the motion).
/// Discs that touch do not overlap.
bool overlapOnBoard(const Puck& a, const Puck& b);

}  // namespace carom
