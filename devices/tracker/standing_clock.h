#pragma once
// Detects a device's clock that stands: all its messages carry the same time, as those of a server that never
// sets it or that plays one packet again and again; or it advances in steps much coarser than its messages.

#include <algorithm>

namespace carom {

class StandingClock {
 public:
  /// Takes a pose of a sensor. `same`: its time is that of the sensor's pose before. `news`: the pose differs
  /// from that one, or the time has not changed for kLong_s. (A server may send one measurement several
  /// times.)
  void see(bool same, bool news) {
    if (same && !news) return;
    evidence_ = std::clamp(evidence_ + (same ? 1 : -1), 0, kMost);
    stands_ = evidence_ >= kEnough || (stands_ && evidence_ > 0);
  }
  bool stands() const { return stands_; }

  static constexpr double kLong_s = 0.5;

 private:
  static constexpr int kEnough = 8, kMost = 16;
  int evidence_ = 0;
  bool stands_ = false;
};

}  // namespace carom
