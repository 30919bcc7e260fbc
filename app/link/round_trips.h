#pragma once
// How long messages take to another room and back.

#include <algorithm>
#include <array>
#include <cstddef>

namespace carom {

/// Seconds; 0 while nothing is known.
struct RoundTrip {
  double least_s = 0.0, median_s = 0.0, p99_s = 0.0;
  std::size_t count = 0;
  double most_s = 0.0;
  std::size_t stalls = 0;  ///< that took more than twice the median
};

/// The newest measurements. Allocates nothing.
class RoundTrips {
 public:
  void add(double round_s) {
    all_s_[next_] = round_s;
    next_ = (next_ + 1) % all_s_.size();
    count_ = std::min(count_ + 1, all_s_.size());
    now_ = summary();
  }
  std::size_t count() const { return count_; }
  const RoundTrip& now() const { return now_; }

 private:
  RoundTrip summary() const {
    std::array<double, kMost> sorted_s = all_s_;
    const auto end = sorted_s.begin() + static_cast<std::ptrdiff_t>(count_);
    std::sort(sorted_s.begin(), end);
    const double median_s = sorted_s[count_ / 2];
    const auto stalls = end - std::upper_bound(sorted_s.begin(), end, 2.0 * median_s);
    return {sorted_s[0],
            median_s,
            sorted_s[(count_ - 1) * 99 / 100],
            count_,
            sorted_s[count_ - 1],
            static_cast<std::size_t>(stalls)};
  }

  static constexpr std::size_t kMost = 240;
  std::array<double, kMost> all_s_{};
  std::size_t next_ = 0, count_ = 0;
  RoundTrip now_;  ///< of them all, which frames ask for more often than one is added
};

}  // namespace carom
