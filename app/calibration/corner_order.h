#pragma once
// In which order points were touched, if not in the one that was asked for.

#include <cstddef>
#include <span>
#include <vector>

#include "devices/calibration/rigid_fit.h"

namespace carom {

struct CornerOrder {
  std::vector<std::size_t> corner;  ///< the corner that touch i was of; empty if no order fits
  double largest_m = 0.0;           ///< largest miss in that order
};

/// Returns the order in which the touches (B) fit the corners (A) as they stand in the room. Of several that
/// fit about equally, as in a room with equal walls, it is the one that moves the fewest touches. An order
/// fits if no touch misses by more than `most_m`.
CornerOrder likeliestOrder(std::span<const PointPair> pairs, double most_m = 0.05);

}  // namespace carom
