#pragma once
// The collisions of a play of soft bodies: touches that follow each other soon are one. c = 1, metres, board
// frame. Theory: app/doc/physics.md, Soft bodies.

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "engine/soft/list_tail.h"
#include "engine/soft/soft_group.h"

namespace carom {

/// Touches of two bodies, or of a body and a cushion, less than 2R/c_s apart: one collision.
struct SoftCollision {
  std::size_t body = 0;
  std::size_t other = SoftExchange::kNone;    ///< the other body
  std::size_t cushion = SoftExchange::kNone;  ///< or the cushion
  Vec21 contact;                              ///< the first touch
  double lastTouch = 0.0;                     ///< the end of the last step in which they touched
  bool isOver = false;                        ///< they have not touched for 2R/c_s
  glm::dvec2 lastPlace{0.0};                  ///< where they touched then
  glm::dvec2 impulse{0.0};                    ///< received by `body`
  double heatBefore = 0.0, heatAfter = 0.0;   ///< of both bodies, at the contact and at the last touch
  double heat() const { return heatAfter - heatBefore; }
};

class SoftCollisions {
 public:
  /// In the order of their first touches as the play found them.
  std::span<const SoftCollision> all() const { return all_; }
  /// Their places in that list once they are over, in the order in which this was known.
  std::span<const std::size_t> parted() const { return parted_; }

  /// Notes a touch within the step of a group that ended at a time; `members` are the numbers of its bodies.
  /// Returns the collision if it has just begun, or null.
  const SoftCollision* note(const SoftExchange& touch, const SoftGroup& group,
                            std::span<const std::size_t> members, double time);
  /// Ends those whose bodies have not touched for `soundTimeOf` the slower of them.
  void end(double time, const std::function<double(std::size_t body)>& soundTimeOf);

  /// How long the lists are, as far as they do not change any more.
  struct Lengths {
    std::size_t all = 0, parted = 0;
  };
  Lengths lengths() const { return {settled_, parted_.size()}; }

  /// The ends of the lists from these lengths on.
  struct State {
    std::size_t settled;
    ListTail<SoftCollision> all;
    ListTail<std::size_t> parted;
  };
  State state(const Lengths& from) const { return {settled_, {all_, from.all}, {parted_, from.parted}}; }
  void restore(const State& state);

 private:
  std::vector<SoftCollision> all_;
  std::size_t settled_ = 0;  // of them are over
  std::vector<std::size_t> parted_;
};

}  // namespace carom
