#pragma once
// Narrows an interval to the place where a condition ends.

namespace carom {

/// An interval at whose lower end a condition holds, and at whose upper end it does not.
struct Bracket {
  double low = 0.0;
  double high = 0.0;
};

/// Returns the interval after `halvings` halvings, or after fewer when no number lies between its ends.
/// `holds(x)` is true below some place in the interval, and false from there on.
template <typename Condition>
Bracket bisect(Bracket bracket, int halvings, const Condition& holds) {
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (bracket.low + bracket.high);
    if (!(middle > bracket.low && middle < bracket.high)) break;
    if (holds(middle)) {
      bracket.low = middle;
    } else {
      bracket.high = middle;
    }
  }
  return bracket;
}

}  // namespace carom
