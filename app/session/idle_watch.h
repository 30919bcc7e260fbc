#pragma once
// Notices that the room is empty: no input and no motion of the head for a while, after there was some.
// While people discuss a question, the while is longer.

#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "engine/spacetime/event.h"

namespace carom {

class IdleWatch {
 public:
  /// A head that stays within this distance stands still.
  static constexpr double kStill_m = 0.05;
  static constexpr double kDiscusses = 5.0;  ///< times as long while a question stands

  /// Watches for `patience_s` without a sign of life; never if empty.
  explicit IdleWatch(std::optional<double> patience_s = {}) : patience_s_(patience_s) {}

  /// Takes a frame: its time, whether the person did anything, and where their head is in the room. Returns
  /// true in the frame in which the patience ends, and then not again before there is another sign of life.
  bool look(double now_s, bool acted, const Vec3& head_m, bool discusses = false) {
    if (!patience_s_) return false;
    if (std::exchange(discusses_, discusses) && !discusses) wait(now_s);
    const bool moved = head_m_ && glm::distance(*head_m_, head_m) > kStill_m;
    if (!head_m_ || moved) head_m_ = head_m;
    if (acted || moved) latest_s_ = now_s;
    const std::optional<double> left = left_s(now_s);
    if (!left || *left > 0.0) return false;
    latest_s_.reset();
    return true;
  }

  /// Returns for how long the patience lasts without a further sign of life; empty: the room is empty.
  std::optional<double> left_s(double now_s) const {
    if (!patience_s_ || !latest_s_) return {};
    return (discusses_ ? kDiscusses : 1.0) * *patience_s_ - (now_s - *latest_s_);
  }

  /// Says that something is shown to the person, such as a scripted flight: it is no sign of life, but a
  /// watcher need not move meanwhile.
  void wait(double now_s) {
    if (latest_s_) latest_s_ = now_s;
  }

  bool isSomebodyThere() const { return latest_s_.has_value(); }

  /// Forgets the signs of life so far: the next visitor is welcomed already.
  void forget() { latest_s_.reset(); }

 private:
  std::optional<double> patience_s_;
  bool discusses_ = false;
  std::optional<double> latest_s_;  ///< of the latest sign of life; empty: none since the last visitor
  std::optional<Vec3> head_m_;      ///< where the head stands
};

}  // namespace carom
