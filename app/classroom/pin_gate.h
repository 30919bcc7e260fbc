#pragma once
// Guards the teacher's PIN against guessing: five wrong tries a minute from an address, then also the right
// one is refused until a minute has passed since the first of them.

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace carom {

enum class PinAnswer { right, wrong, tooMany };

class PinGate {
 public:
  static constexpr std::size_t kTries = 5;
  static constexpr double kWithin_s = 60.0;

  explicit PinGate(std::string pin) : pin_(std::move(pin)) {}

  PinAnswer tryPin(const std::string& pin, const std::string& address, double now_s) {
    for (auto& [from, times_s] : wrong_)
      std::erase_if(times_s, [now_s](double at_s) { return now_s - at_s >= kWithin_s; });
    std::erase_if(wrong_, [](const auto& entry) { return entry.second.empty(); });
    const auto found = wrong_.find(address);
    if (found != wrong_.end() && found->second.size() >= kTries) return PinAnswer::tooMany;
    if (pin == pin_) return PinAnswer::right;
    wrong_[address].push_back(now_s);
    return PinAnswer::wrong;
  }

 private:
  std::string pin_;
  std::map<std::string, std::vector<double>> wrong_;  ///< times of wrong tries in the last minute, by address
};

}  // namespace carom
