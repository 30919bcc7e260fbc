#pragma once
// Guards the teacher's PIN against guessing: five wrong tries a minute from an address.

#include <string>
#include <utility>

#include "app/classroom/guess_gate.h"

namespace carom {

enum class PinAnswer { right, wrong, tooMany };

class PinGate {
 public:
  static constexpr std::size_t kTries = 5;
  static constexpr double kWithin_s = GuessGate::kWithin_s;

  explicit PinGate(std::string pin) : pin_(std::move(pin)) {}

  PinAnswer tryPin(const std::string& pin, const std::string& address, double now_s) {
    if (gate_.isShut(address, now_s)) return PinAnswer::tooMany;
    if (pin == pin_) return PinAnswer::right;
    gate_.wrong(address, now_s);
    return PinAnswer::wrong;
  }

 private:
  std::string pin_;
  GuessGate gate_{kTries};
};

}  // namespace carom
