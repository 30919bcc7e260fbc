#pragma once
// What cannot be played.

#include "engine/billiard/billiard_setup.h"

namespace carom {

/// Throws std::invalid_argument, naming the pucks and the values, for a setup that cannot be played: see
/// `Billiard`.
void checkSetup(const BilliardSetup& setup);

/// The same for one stroke, whose number in messages is `number`. Its arrival is checked by the game.
void checkStroke(const BilliardSetup& setup, const Stroke& stroke, std::size_t number);

/// Do the discs of two pucks, as the board shows them at t = 0 (ellipses, R/γ along the motion), overlap?
/// Touching is not overlapping.
bool overlapOnBoard(const Puck& a, const Puck& b);

}  // namespace carom
