#include "app/keys.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace carom {
namespace {

struct SwitchKey {
  int key;  // GLFW's
  const char* label;
  const NamedSwitch& turns;
};

constexpr std::array<int, 2> kEndKeys{GLFW_KEY_ESCAPE, GLFW_KEY_Q};
constexpr std::array<SwitchKey, 5> kSwitchKeys{{{GLFW_KEY_1, "1", kNamedSwitches[0]},
                                                {GLFW_KEY_2, "2", kNamedSwitches[1]},
                                                {GLFW_KEY_3, "3", kNamedSwitches[2]},
                                                {GLFW_KEY_4, "4", kNamedSwitches[3]},
                                                {GLFW_KEY_5, "5", kNamedSwitches[4]}}};

constexpr std::array<int, 2> kFurtherKeys{GLFW_KEY_EQUAL, GLFW_KEY_KP_ADD};  // + without Shift is =
constexpr std::array<int, 2> kCloserKeys{GLFW_KEY_MINUS, GLFW_KEY_KP_SUBTRACT};
constexpr std::array<const char*, 3> kShownNames{"the session", "test patterns", "seam pattern"};

template <std::size_t count>
bool isOneOf(int key, const std::array<int, count>& keys) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

bool endsSession(const KeyInput& input) { return input.pressed && isOneOf(input.key, kEndKeys); }

}  // namespace

bool wantsToEnd(const WindowInput& input) {
  return input.closeRequested || std::any_of(input.keys.begin(), input.keys.end(), endsSession);
}

void turnSwitches(const WindowInput& input, Switches& switches) {
  for (const KeyInput& pressed : input.keys) {
    for (const SwitchKey& key : kSwitchKeys) {
      if (!pressed.pressed || pressed.key != key.key) continue;
      std::uint8_t& value = switches.*key.turns.value;
      value = value ? 0 : 1;
      fmt::print(stderr, "{}: {}\n", key.turns.name, value ? "on" : "off");
    }
  }
}

void steerWalls(const WindowInput& input, WallControls& controls, bool inSession) {
  for (const KeyInput& pressed : input.keys) {
    if (!pressed.pressed) continue;
    if (pressed.key == GLFW_KEY_T) {
      auto next = (static_cast<std::size_t>(controls.shown) + 1) % kShownNames.size();
      if (next == 0 && !inSession) next = 1;
      controls.shown = static_cast<Shown>(next);
      fmt::print(stderr, "shown: {}\n", kShownNames[next]);
    } else if (pressed.key == GLFW_KEY_B) {
      controls.blank = controls.blank ? 0 : 1;
      fmt::print(stderr, "walls: {}\n", controls.blank ? "black" : "lit");
    } else if (pressed.key == GLFW_KEY_X) {
      controls.eyesSwapped = controls.eyesSwapped ? 0 : 1;
      fmt::print(stderr, "eyes: {}\n", controls.eyesSwapped ? "swapped" : "as in the rig");
    }
  }
}

void setEyesApart(const WindowInput& input, double& eyeSeparation_m) {
  for (const KeyInput& pressed : input.keys) {
    const int steps = isOneOf(pressed.key, kFurtherKeys) - isOneOf(pressed.key, kCloserKeys);
    if (!pressed.pressed || steps == 0) continue;
    // To a tenth of a millimetre, so that steps there and back end where they began.
    const double set_m = std::round((eyeSeparation_m + steps * kEyeSeparationStep_m) * 1e4) / 1e4;
    eyeSeparation_m = std::clamp(set_m, 0.0, kMostEyeSeparation_m);
    fmt::print(stderr, "eyes: {:.1f} mm apart\n", eyeSeparation_m * 1e3);
  }
}

void sayKeys() {
  fmt::print(stderr, "Keys:");
  for (const SwitchKey& key : kSwitchKeys) fmt::print(stderr, " {} {},", key.label, key.turns.name);
  fmt::print(stderr, " T patterns, B black walls, X swapped eyes, + and - eye separation,");
  fmt::print(stderr, " Escape or Q ends the session, as the window's button does.\n");
}

void sayPatternKeys() {
  fmt::print(stderr, "Keys: T next pattern, B black walls, X swapped eyes, Escape or Q ends.\n");
}

}  // namespace carom
