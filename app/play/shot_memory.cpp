#include "app/play/shot_memory.h"

#include <algorithm>

namespace carom {

void ShotMemory::see(const ShotView& view) {
  if (!isOn_) return;
  if (current_.size() == kMostViews) {
    isOn_ = false;
    current_.clear();
    return;
  }
  current_.push_back(view);
  if (!caromAt_s_ || view.shown_s - *caromAt_s_ < kAfter_s) return;
  isOn_ = false;
  if (!best_.empty() && cushions_ < bestCushions_) return current_.clear();
  best_.swap(current_);
  bestCushions_ = cushions_;
  current_.clear();
}

const ShotView* ShotMemory::at(double since_s) const {
  if (best_.empty()) return nullptr;
  const double then_s = best_.front().shown_s + since_s;
  const auto next =
      std::upper_bound(best_.begin(), best_.end(), then_s,
                       [](double time_s, const ShotView& view) { return time_s < view.shown_s; });
  if (next == best_.end() && then_s > best_.back().shown_s) return nullptr;
  return &*(next == best_.begin() ? next : next - 1);
}

const ObserverView& ShotMemory::earliest(const ObserverView& now, double now_s) {
  if (!best_.empty() && now_s - best_.back().shown_s > kKept_s) best_.clear();
  if (!best_.empty()) return best_.front().observer;
  return current_.empty() ? now : current_.front().observer;
}

}  // namespace carom
