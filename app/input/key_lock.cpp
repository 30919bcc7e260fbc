#include "app/input/key_lock.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>

#include "engine/text/log.h"

namespace carom {
namespace {

constexpr std::array kLocked{GLFW_KEY_ESCAPE, GLFW_KEY_Q,           GLFW_KEY_T,    GLFW_KEY_X,
                             GLFW_KEY_K,      GLFW_KEY_B,           GLFW_KEY_L,    GLFW_KEY_EQUAL,
                             GLFW_KEY_KP_ADD, GLFW_KEY_KP_SUBTRACT, GLFW_KEY_MINUS};
constexpr std::size_t kLongest = 32;  // of what is typed

char typedDigit(int key) {
  if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) return static_cast<char>('0' + (key - GLFW_KEY_0));
  if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) return static_cast<char>('0' + (key - GLFW_KEY_KP_0));
  return 0;
}

/// Returns whether a key ends the session.
bool ends(const KeyInput& key) { return key.key == GLFW_KEY_ESCAPE || key.key == GLFW_KEY_Q; }

}  // namespace

/// Takes a key that is locked or that belongs to the PIN. Returns whether it did.
bool KeyLock::takes(const KeyInput& key) {
  if (pin_.empty()) return ends(key);
  const bool isLocked = !isOpen_ && std::find(kLocked.begin(), kLocked.end(), key.key) != kLocked.end();
  if (key.key == GLFW_KEY_F12) {
    if (!key.pressed) return true;
    if (isOpen_) log::note("The keys are locked.");
    isTyping_ = !isOpen_;
    isOpen_ = false;
    typed_.clear();
    return true;
  }
  if (!isTyping_ || !key.pressed) return isLocked;
  if (const char digit = typedDigit(key.key); digit != 0) {
    if (typed_.size() < kLongest) typed_ += digit;
    return true;
  }
  isTyping_ = false;
  if (key.key != GLFW_KEY_ENTER && key.key != GLFW_KEY_KP_ENTER) return isLocked;
  isOpen_ = typed_ == pin_;
  log::note(isOpen_ ? "The keys are open." : "That is not the PIN: the keys stay locked.");
  return true;
}

const WindowInput& KeyLock::pass(const WindowInput& input) {
  if (pin_.empty() && !isUnattended_) return input;
  passed_.keys.clear();
  for (const KeyInput& key : input.keys) {
    if (!takes(key)) passed_.keys.push_back(key);
  }
  passed_.closeRequested = input.closeRequested && isOpen_;
  passed_.wheel = input.wheel;
  return passed_;
}

}  // namespace carom
