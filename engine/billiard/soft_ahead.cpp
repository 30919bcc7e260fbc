#include "engine/billiard/soft_ahead.h"

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
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

class SoftAhead::Player {
 public:
  explicit Player(const std::vector<SoftCushion>& cushions)
      : play_(cushions), thread_([this](const std::stop_token& stop) { run(stop); }) {}

  void start(Slice from);
  Slice take();

 private:
  void run(const std::stop_token& stop);

  Slice playSlice();

  SoftPlay play_;  // the thread's, as the next
  SoftRowBook rows_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::optional<Slice> start_;  // to start from, until the thread has taken it
  std::deque<Slice> ahead_;
  std::exception_ptr failure_;
  std::jthread thread_;  // last: it uses the rest
};

SoftAhead::SoftAhead(const std::vector<SoftCushion>& cushions)
    : player_(std::make_unique<Player>(cushions)) {}

SoftAhead::~SoftAhead() = default;

void SoftAhead::start(Slice from) { player_->start(std::move(from)); }

SoftAhead::Slice SoftAhead::take() { return player_->take(); }

void SoftAhead::Player::start(Slice from) {
  const std::lock_guard lock(mutex_);
  start_ = std::move(from);
  ahead_.clear();
  failure_ = nullptr;
  changed_.notify_all();
}

SoftAhead::Slice SoftAhead::Player::take() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !ahead_.empty() || failure_; });
  if (ahead_.empty()) std::rethrow_exception(failure_);
  Slice next = std::move(ahead_.front());
  ahead_.pop_front();
  changed_.notify_all();
  return next;
}

SoftAhead::Slice SoftAhead::Player::playSlice() {
  play_.playSlice();
  rows_.endSlice(play_);
  Slice slice{play_.snapshot(), rows_.snapshot(play_.time()), {}};
  rows_.take(slice.rows);
  return slice;
}

void SoftAhead::Player::run(const std::stop_token& stop) {
  play_.watch([this](std::size_t body, double) { rows_.step(body, play_); });
  std::unique_lock lock(mutex_);
  std::size_t most = 0;
  while (changed_.wait(lock, stop, [&] { return start_ || (!failure_ && ahead_.size() < most); })) {
    const std::optional<Slice> from = std::exchange(start_, std::nullopt);
    lock.unlock();
    std::optional<Slice> next;
    std::exception_ptr failure;
    try {
      if (from) {
        play_.restore(*from->play);
        rows_.continueFrom(from->recorders);
        most = statesOf(play_);
      }
      next = playSlice();
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    if (start_) continue;  // void
    failure_ = failure;
    if (next) ahead_.push_back(std::move(*next));
    changed_.notify_all();
  }
}

}  // namespace carom
