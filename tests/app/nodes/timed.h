#pragma once
// How long work takes, and what says that it shall go on.

#include <atomic>
#include <chrono>
#include <functional>

namespace carom::test {

inline const std::atomic<bool> kGoOn = false;

inline double secondsOf(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace carom::test
