#include "engine/billiard/soft_ahead.h"

#include <algorithm>
#include <utility>

namespace carom {
namespace {

constexpr std::size_t kMostSlices = static_cast<std::size_t>(SoftAhead::kFarthest / SoftPlay::kSlice);
constexpr std::size_t kFewestSlices = 4;
constexpr std::size_t kMostNodes = 400000;  // in all states that are kept: some 100 bytes each

/// Returns how many states of a play are kept.
std::size_t statesOf(const SoftPlay& play) {
  std::size_t nodes = 1;
  for (std::size_t body = 0; body < play.size(); ++body) nodes += play.body(body).size();
  return std::clamp(kMostNodes / nodes, kFewestSlices, kMostSlices);
}

}  // namespace

SoftAhead::SoftAhead(const std::vector<SoftCushion>& cushions)
    : play_(cushions), thread_([this](const std::stop_token& stop) { run(stop); }) {}

void SoftAhead::start(std::shared_ptr<const SoftPlay::Snapshot> from) {
  const std::lock_guard lock(mutex_);
  start_ = std::move(from);
  ahead_.clear();
  failure_ = nullptr;
  changed_.notify_all();
}

std::shared_ptr<const SoftPlay::Snapshot> SoftAhead::take() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !ahead_.empty() || failure_; });
  if (ahead_.empty()) std::rethrow_exception(failure_);
  State next = std::move(ahead_.front());
  ahead_.pop_front();
  changed_.notify_all();
  return next;
}

void SoftAhead::run(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  std::size_t most = 0;
  while (changed_.wait(lock, stop, [&] { return start_ || (!failure_ && ahead_.size() < most); })) {
    const State from = std::exchange(start_, nullptr);
    lock.unlock();
    State next;
    std::exception_ptr failure;
    try {
      if (from) {
        play_.restore(*from);
        most = statesOf(play_);
      }
      play_.playSlice();
      next = play_.snapshot();
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    if (start_) continue;  // void
    failure_ = failure;
    if (next) ahead_.push_back(std::move(next));
    changed_.notify_all();
  }
}

}  // namespace carom
