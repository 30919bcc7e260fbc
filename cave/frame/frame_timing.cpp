#include "cave/frame/frame_timing.h"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

constexpr float kNotMeasured = std::numeric_limits<float>::quiet_NaN();

/// Returns the index of the nearest rank of `fraction` among `count` sorted values.
std::size_t rankOf(double fraction, std::size_t count) {
  const auto rank = static_cast<std::size_t>(std::ceil(fraction * static_cast<double>(count)));
  return std::clamp<std::size_t>(rank, 1, count) - 1;
}

}  // namespace

void FrameStopwatch::begin() {
  stamps_.parts_s.fill(kNotMeasured);
  marked_ = std::chrono::steady_clock::now();
}

void FrameStopwatch::mark(FramePart part) {
  const Time now = std::chrono::steady_clock::now();
  set(part, std::chrono::duration<double>(now - marked_).count());
  marked_ = now;
}

const FrameTiming& FrameStopwatch::swapped(std::uint64_t frame) {
  mark(FramePart::swap);
  stamps_.frame = frame;
  if (begun_) {
    set(FramePart::late, std::chrono::duration<double>(marked_ - swapped_).count() - period_s_);
  }
  begun_ = true;
  swapped_ = marked_;
  return stamps_;
}

FrameHistory::FrameHistory(std::size_t kept) : stamps_(std::max<std::size_t>(kept, 1)) {
  sorted_s_.reserve(stamps_.size());
}

void FrameHistory::add(const FrameTiming& stamps) { stamps_[added_++ % stamps_.size()] = stamps; }

PartStatistics FrameHistory::statistics(FramePart part, std::size_t last) const {
  sorted_s_.clear();
  double sum_s = 0.0;
  for (std::size_t back = 1; back <= std::min(last, size()); ++back) {
    const float value_s = stamps_[(added_ - back) % stamps_.size()][part];
    if (std::isnan(value_s)) continue;
    sorted_s_.push_back(value_s);
    sum_s += value_s;
  }
  PartStatistics statistics;
  statistics.frames = sorted_s_.size();
  if (sorted_s_.empty()) return statistics;
  std::sort(sorted_s_.begin(), sorted_s_.end());
  statistics.median_s = sorted_s_[rankOf(0.5, sorted_s_.size())];
  statistics.p99_s = sorted_s_[rankOf(0.99, sorted_s_.size())];
  statistics.most_s = sorted_s_.back();
  const double mean_s = sum_s / static_cast<double>(sorted_s_.size());
  double squares = 0.0;
  for (const float value_s : sorted_s_) squares += (value_s - mean_s) * (value_s - mean_s);
  statistics.jitter_s = static_cast<float>(std::sqrt(squares / static_cast<double>(sorted_s_.size())));
  return statistics;
}

void SessionLateness::add(float late_s) {
  if (std::isnan(late_s)) return;
  ++frames_;
  const double ticks = std::round(late_s / period_s_);
  if (ticks > 0.0) missed_ += static_cast<std::uint64_t>(ticks);
  const double bin = std::clamp(std::ceil(late_s / kBin_s), 0.0, static_cast<double>(kBins - 1));
  ++bins_[static_cast<std::size_t>(bin)];
}

double SessionLateness::p99_s() const {
  if (frames_ == 0) return std::numeric_limits<double>::quiet_NaN();
  const std::uint64_t rank = rankOf(0.99, frames_);
  std::uint64_t counted = 0;
  std::size_t bin = 0;
  while (bin + 1 < kBins && (counted += bins_[bin]) <= rank) ++bin;
  return static_cast<double>(bin) * kBin_s;
}

}  // namespace carom
