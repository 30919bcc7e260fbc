#include "devices/programs/trackd_pause.h"

#include <algorithm>
#include <functional>

namespace carom {

void TrackdPause::changed(bool isLater, Clock::time_point now) {
  ++changes_;
  const std::optional<Clock::duration> gap = last_ ? std::optional(now - *last_) : std::nullopt;
  last_ = now;
  if (before_ && gap) inPose_ = std::max(inPose_, std::min(*before_, *gap));
  before_ = isLater ? std::nullopt : gap;
  if (!isLater) return;
  pauses_[poses_++ % kRemembered] = inPose_;
  inPose_ = {};
}

TrackdPause::Clock::duration TrackdPause::settle() const {
  auto sorted = pauses_;
  std::nth_element(sorted.begin(), sorted.begin() + kRare, sorted.end(), std::greater<>());
  return std::clamp<Clock::duration>(sorted[kRare] * 3 / 2 + kLeast / 2, kLeast, kMost);
}

}  // namespace carom
