#pragma once
// Calls that block, made all at once: each has a thread of its own.

#include <atomic>
#include <barrier>
#include <functional>
#include <thread>
#include <vector>

namespace carom {

class ParallelCalls {
 public:
  /// The calls must not throw. Throws std::system_error if the system gives no more threads.
  explicit ParallelCalls(std::vector<std::function<void()>> calls);
  ~ParallelCalls();
  ParallelCalls(const ParallelCalls&) = delete;
  ParallelCalls& operator=(const ParallelCalls&) = delete;

  /// Makes every call once and returns when all have returned.
  void run();

 private:
  std::atomic<bool> ends_ = false;
  std::barrier<> begun_, done_;
  std::vector<std::function<void()>> calls_;
  std::vector<std::jthread> threads_;
};

}  // namespace carom
