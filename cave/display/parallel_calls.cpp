#include "cave/display/parallel_calls.h"

#include <utility>

namespace carom {

ParallelCalls::ParallelCalls(std::vector<std::function<void()>> calls)
    : begun_(static_cast<std::ptrdiff_t>(calls.size()) + 1),
      done_(static_cast<std::ptrdiff_t>(calls.size()) + 1),
      calls_(std::move(calls)) {
  try {
    for (const std::function<void()>& call : calls_) {
      threads_.emplace_back([this, &call] {
        for (begun_.arrive_and_wait(); !ends_; begun_.arrive_and_wait()) {
          call();
          done_.arrive_and_wait();
        }
      });
    }
  } catch (...) {  // the threads that there are wait for those that are not
    ends_ = true;
    static_cast<void>(begun_.arrive(static_cast<std::ptrdiff_t>(calls_.size() - threads_.size()) + 1));
    throw;
  }
}

ParallelCalls::~ParallelCalls() {
  ends_ = true;
  begun_.arrive_and_wait();
}

void ParallelCalls::run() {
  begun_.arrive_and_wait();
  done_.arrive_and_wait();
}

}  // namespace carom
