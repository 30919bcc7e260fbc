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
};

/// The newest measurements. Allocates nothing.
class RoundTrips {
 public:
  void add(double round_s) {
    all_s_[next_] = round_s;
    next_ = (next_ + 1) % all_s_.size();
    count_ = std::min(count_ + 1, all_s_.size());
  }
  std::size_t count() const { return count_; }
  RoundTrip now() const {
    if (count_ == 0) return {};
    std::array<double, kMost> sorted_s = all_s_;
    const auto end = sorted_s.begin() + static_cast<std::ptrdiff_t>(count_);
    std::sort(sorted_s.begin(), end);
    return {sorted_s[0], sorted_s[count_ / 2], sorted_s[(count_ - 1) * 99 / 100], count_};
  }

 private:
  static constexpr std::size_t kMost = 240;
  std::array<double, kMost> all_s_{};
  std::size_t next_ = 0, count_ = 0;
};

}  // namespace carom
