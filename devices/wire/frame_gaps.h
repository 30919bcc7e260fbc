#pragma once
// Counts the frames that never arrived, by the numbers that a device gives its frames.

#include <cstdint>

namespace carom {

class FrameGaps {
 public:
  /// Returns the number of frames missing between the newest one so far and this one. A number that is not
  /// later, or much later, means that the device started anew (or that the frame is late), and counts
  /// nothing.
  std::uint64_t follow(std::uint32_t number) {
    const std::uint32_t step = number - newest_;
    const bool goesOn = begun_ && step > 0 && step <= kMost;
    const bool isLate = begun_ && newest_ - number < kMost;
    if (!isLate) newest_ = number;
    begun_ = true;
    return goesOn ? step - 1 : 0;
  }

 private:
  static constexpr std::uint32_t kMost = 1000;
  std::uint32_t newest_ = 0;
  bool begun_ = false;
};

}  // namespace carom
