#pragma once
// Waits on a device's thread, which must end when it is asked to.

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>

namespace carom {

/// Waits for `duration`, or until a stop is requested.
inline void waitUnlessStopped(const std::stop_token& stop, std::chrono::milliseconds duration) {
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any().wait_for(lock, stop, duration, [] { return false; });
}

}  // namespace carom
