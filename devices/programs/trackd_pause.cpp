#include "devices/programs/trackd_pause.h"

#include <algorithm>

namespace carom {

void TrackdPause::changed(bool isLater, Clock::time_point now) {
  ++changes_;
  if (poses_ >= kWatched) return;
  const std::optional<Clock::duration> gap = last_ ? std::optional(now - *last_) : std::nullopt;
  last_ = now;
  if (before_ && gap) {
    inPose_ = std::max(inPose_, std::min(*before_, *gap));
    ++(*gap < *before_ ? timesLast_ : timesFirst_);
  }
  before_ = isLater ? std::nullopt : gap;
  if (!isLater) return;
  watched_[poses_++] = inPose_;
  inPose_ = {};
}

TrackdPause::Clock::duration TrackdPause::settle(bool isKnownByTime) const {
  if (isKnownByTime && timesLast_ > 3 * timesFirst_) return kLeast;
  auto sorted = watched_;
  std::sort(sorted.begin(), sorted.end());
  const auto first = std::upper_bound(sorted.begin(), sorted.end(), Clock::duration(0));
  const auto count = static_cast<std::size_t>(sorted.end() - first);
  if (count < kSeldom) return kLeast;
  const Clock::duration usual = *(first + static_cast<std::ptrdiff_t>(count / 2));
  return std::clamp<Clock::duration>(usual * 3 / 2 + kLeast / 2, kLeast, kMost);
}

}  // namespace carom
