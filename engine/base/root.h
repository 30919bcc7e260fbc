#pragma once
// Finds the root of an increasing function to the last bit. The function must have a root; nothing else is
// assumed.

namespace carom {

/// Returns the place where f changes from not above 0 to above 0. Searches outwards from `guess` in steps
/// that double from `step`, then halves the interval until no number lies between its ends.
template <typename Function>
double rootOfIncreasing(const Function& f, double guess, double step = 1e-3) {
  double low = guess - step;
  double high = guess + step;
  for (double reach = step; f(low) > 0.0; reach *= 2.0) low -= reach;
  for (double reach = step; !(f(high) > 0.0) && reach < 1e300; reach *= 2.0) high += reach;
  for (;;) {
    const double middle = low + 0.5 * (high - low);
    if (!(middle > low && middle < high)) return low;
    (f(middle) > 0.0 ? high : low) = middle;
  }
}

}  // namespace carom
