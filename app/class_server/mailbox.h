#pragma once
// A bounded queue between the threads of frames and of the class. Neither waits for the other: what does not
// fit drops the oldest, and who finds it in use takes what there is the next time.

#include <cstddef>
#include <deque>
#include <mutex>
#include <utility>

namespace carom {

template <typename Letter>
class Mailbox {
 public:
  explicit Mailbox(std::size_t most) : most_(most) {}

  void put(Letter letter) {
    const std::scoped_lock hold(mutex_);
    if (letters_.size() >= most_) letters_.pop_front();
    letters_.push_back(std::move(letter));
  }

  /// Calls `take(letter)` for each letter, in their order; for none if another thread uses the queue.
  template <typename Take>
  void takeAll(Take&& take) {
    std::unique_lock hold(mutex_, std::try_to_lock);
    if (!hold || letters_.empty()) return;
    std::deque<Letter> taken = std::exchange(letters_, {});
    hold.unlock();
    for (Letter& letter : taken) take(std::move(letter));
  }

 private:
  std::size_t most_;
  std::mutex mutex_;
  std::deque<Letter> letters_;
};

}  // namespace carom
