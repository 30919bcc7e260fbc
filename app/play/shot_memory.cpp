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

bool ShotReplay::look(const ShotMemory& shots, double now_s, bool interrupted) {
  if (!from_s_) return false;
  const double since_s = now_s - *from_s_;
  const bool isOver = isStill_ ? since_s > kStill_s : !shots.at(since_s);
  if (!over_s_ && (interrupted || isOver)) over_s_ = now_s;
  if (over_s_ && (!endsGame_ || now_s - *over_s_ > kHeld_s)) from_s_.reset();
  return true;
}

const ShotView* ShotReplay::view(const ShotMemory& shots, double now_s) const {
  if (!from_s_ || !shots.hasBest()) return nullptr;
  const ShotView* const view = isStill_ ? nullptr : shots.at(now_s - *from_s_);
  return view ? view : &shots.last();
}

}  // namespace carom
