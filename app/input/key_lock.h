#pragma once
// Locks the keys that end or spoil a demonstration, so that visitors can be left alone with a keyboard.
//
// F12, the digits of the PIN and Enter open the lock; F12 closes it again. While it is closed, the windows'
// close buttons and these keys do nothing: Escape, Q, T, X, K, B, L, + and -. A session that runs unattended
// or with a study, without a PIN, locks what ends it: Escape, Q and the close buttons, and nothing opens
// them.

#include <string>

#include "cave/gl/graphics.h"

namespace carom {

class KeyLock {
 public:
  /// Without a PIN, and if somebody attends, nothing is ever locked.
  explicit KeyLock(std::string pin = {}, bool isUnattended = false)
      : pin_(std::move(pin)), isUnattended_(isUnattended) {}

  /// Returns the input without locked keys, and without those typed to open the lock. The result is valid
  /// until the next call.
  const WindowInput& pass(const WindowInput& input);

 private:
  bool takes(const KeyInput& key);

  std::string pin_, typed_;
  bool isUnattended_;
  bool isOpen_ = false, isTyping_ = false;
  WindowInput passed_;
};

}  // namespace carom
