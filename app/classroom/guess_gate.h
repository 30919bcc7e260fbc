#pragma once
// Guards a secret against guessing. After a number of wrong tries within a minute an address is refused, also
// with the right secret, until a minute has passed since the first of them.

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace carom {

class GuessGate {
 public:
  static constexpr double kWithin_s = 60.0;

  explicit GuessGate(std::size_t tries) : tries_(tries) {}

  /// Returns whether this address has guessed too often.
  bool isShut(const std::string& address, double now_s) {
    for (auto& [from, times_s] : wrong_)
      std::erase_if(times_s, [now_s](double at_s) { return now_s - at_s >= kWithin_s; });
    std::erase_if(wrong_, [](const auto& entry) { return entry.second.empty(); });
    const auto found = wrong_.find(address);
    return found != wrong_.end() && found->second.size() >= tries_;
  }
  /// Notes a wrong try.
  void wrong(const std::string& address, double now_s) { wrong_[address].push_back(now_s); }

 private:
  std::size_t tries_;
  std::map<std::string, std::vector<double>> wrong_;  ///< times of wrong tries in the last minute, by address
};

}  // namespace carom
