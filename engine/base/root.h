#pragma once
// Finds the root of an increasing function to the last bit. The function must have a root; nothing else is
// assumed.

#include <algorithm>
#include <cmath>

namespace carom {

/// Returns the place where f changes from not above 0 to above 0. Searches outwards from `guess` in steps
/// that double from `step`, then narrows the interval until no number lies between its ends: by Oliveira and
/// Takahashi's steps (2020, "An enhancement of the bisection method average performance preserving minmax
/// optimality"), which go to where the chord between the ends is 0 and a little beyond, and no further from
/// the middle than that halving alone would hardly be faster.
template <typename Function>
double rootOfIncreasing(const Function& f, double guess, double step = 1e-3) {
  double low = guess - step, atLow = f(low);
  double high = guess + step, atHigh = f(high);
  for (double reach = step; atLow > 0.0; reach *= 2.0) atLow = f(low -= reach);
  for (double reach = step; !(atHigh > 0.0) && reach < 1e300; reach *= 2.0) atHigh = f(high += reach);
  const double width = high - low;
  // Half the interval that halving alone would have by now, and twice that.
  double allowed = 2.0 * width;
  for (;;) {
    const double middle = low + 0.5 * (high - low);
    if (!(middle > low && middle < high)) return low;
    const double chord = low - (high - low) * (atLow / (atHigh - atLow));
    const double beyond = 0.2 * (high - low) * ((high - low) / width);
    double next = middle;
    if (std::abs(middle - chord) > beyond) next = chord + std::copysign(beyond, middle - chord);
    const double most = std::max(allowed - 0.5 * (high - low), 0.0);
    next = std::clamp(next, middle - most, middle + most);
    if (!(next > low && next < high)) next = middle;
    const double there = f(next);
    if (there > 0.0) {
      high = next;
      atHigh = there;
    } else {
      low = next;
      atLow = there;
    }
    allowed *= 0.5;
  }
}

}  // namespace carom
