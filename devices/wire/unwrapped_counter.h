#pragma once
// Turns a device's counter that starts again at zero when it is full into one that does not.

#include <concepts>
#include <cstdint>
#include <type_traits>

namespace carom {

/// Follows a counter of type T. A step of more than half its range counts as a step back.
template <std::unsigned_integral T>
class UnwrappedCounter {
 public:
  std::int64_t follow(T count) {
    const T step = static_cast<T>(count - last_);
    last_ = count;
    total_ += begun_ ? static_cast<std::make_signed_t<T>>(step) : std::int64_t{count};
    begun_ = true;
    return total_;
  }

 private:
  T last_ = 0;
  std::int64_t total_ = 0;
  bool begun_ = false;
};

}  // namespace carom
