#pragma once
// A device's clock that does not go: all its messages carry the same time, as those of a server that never
// sets it, or of one that plays one packet again and again; or it goes in steps much coarser than its
// messages.

#include <algorithm>

namespace carom {

class StandingClock {
 public:
  /// A pose of a sensor has come. `same`: its time is that of the sensor's pose before; `news`: it is another
  /// pose than that, or that time has not changed for kLong_s. (A server may send one measurement several
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
