#pragma once
// Takes what a hand device reports into its state, frame by frame: each frame sees at most one change of a
// button, so that a press shorter than a frame is a press.

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "devices/tracker/tracker.h"

namespace carom {

/// Pressed buttons (bit i: button i) and axis values.
struct ButtonState {
  std::uint32_t down = 0;
  std::array<double, 6> axes{};
};

class ButtonChanges {
 public:
  ButtonChanges() { later_.reserve(kMostLater), now_.reserve(kMostLater); }

  /// Begins a frame with the changes that waited for it.
  void beginFrame(ButtonState& state) {
    changed_ = waits_ = 0;
    now_.swap(later_);
    later_.clear();
    for (const Reading& reading : now_) take(reading, state);
  }

  void take(const Reading& reading, ButtonState& state) {
    if (reading.index < 0) return;
    const auto index = static_cast<unsigned>(reading.index);
    if (reading.kind == Reading::Kind::axis && index < state.axes.size())
      state.axes[index] = std::clamp(reading.value, -1.0, 1.0);
    if (reading.kind != Reading::Kind::button || index >= 32) return;
    const std::uint32_t bit = 1U << index, down = reading.value != 0.0 ? bit : 0;
    const bool isChange = (state.down & bit) != down;
    if ((waits_ & bit) != 0 || (isChange && (changed_ & bit) != 0)) {
      if (later_.size() == kMostLater) later_.erase(later_.begin());
      later_.push_back(reading);
      waits_ |= bit;
      return;
    }
    if (isChange) changed_ |= bit;
    state.down = (state.down & ~bit) | down;
  }

  /// Forgets what waits, as for a device that is lost.
  void forget() { later_.clear(); }

 private:
  static constexpr std::size_t kMostLater = 64;
  std::vector<Reading> later_, now_;
  std::uint32_t changed_ = 0, waits_ = 0;  ///< in this frame
};

}  // namespace carom
