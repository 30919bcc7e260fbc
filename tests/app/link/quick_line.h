#pragma once
// A key, limits and waits for lines that are tested.

#include <chrono>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

#include "app/link/line.h"
#include "app/link/link_key.h"

namespace carom::test {

inline LinkKey key() { return LinkKey::of("0000-0000-0000-0000-0000-0000-0000"); }

inline LinkLimits quick() {
  LinkLimits limits;
  limits.handshake = std::chrono::milliseconds(400);
  limits.callAgain = std::chrono::milliseconds(50);
  limits.silence = limits.listening = std::chrono::milliseconds(500);
  limits.unknown = std::chrono::milliseconds(20000);
  limits.unproven = 1000;
  limits.calls_1_s = 1000.0;
  limits.pings_1_s = 20.0;
  return limits;
}

/// Waits for something, for some seconds at most.
inline bool comes(const std::function<bool()>& isThere, double most_s = 10.0) {
  for (int i = 0; i < static_cast<int>(most_s / 0.005); ++i) {
    if (isThere()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return isThere();
}

inline std::vector<std::uint8_t> bytesOf(const LinkMessage& message) {
  std::vector<std::uint8_t> bytes;
  append(message, bytes);
  return bytes;
}

}  // namespace carom::test
