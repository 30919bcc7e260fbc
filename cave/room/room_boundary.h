#pragma once
// Tells when the person has left the room, that is, gone behind one of its walls, which then has no picture
// for them.

#include <algorithm>
#include <span>
#include <utility>

#include "cave/room/wall.h"

namespace carom {

class RoomBoundary {
 public:
  /// Allowance for trackers, which err by a centimetre or two at the edge of their volume.
  static constexpr double kBehind_m = 0.05;

  /// Keeps a reference to the walls.
  explicit RoomBoundary(std::span<const Wall> walls) : walls_(walls) {}

  /// Returns the wall that a head at this place is behind: once each time that it leaves the room, otherwise
  /// null.
  const Wall* look(const glm::dvec3& headInRoom_m) {
    const auto wall = std::find_if(walls_.begin(), walls_.end(), [&](const Wall& w) {
      return glm::dot(normalOf(w), headInRoom_m - w.lowerLeft_m) < -kBehind_m;
    });
    const bool was = std::exchange(left_, wall != walls_.end());
    return was || !left_ ? nullptr : &*wall;
  }

 private:
  std::span<const Wall> walls_;
  bool left_ = false;
};

}  // namespace carom
