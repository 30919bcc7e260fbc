#pragma once
// Spacetime as a thing in the room: where it stands, how large it is, and in which frame it is shown.

#include <cstdint>

#include "engine/base/pose.h"
#include "engine/sculpture/sculpture_place.h"

namespace carom {

/// What a frame's record holds of it; the flag whether it is shown is among the views of time.
struct SculptureView {
  SculpturePlace place;
  std::uint64_t picked = 0;    ///< 1 and the number of the event whose double cone is shown; 0: none
  std::uint64_t compared = 0;  ///< of the event that was picked before it
  std::uint8_t held = 0;       ///< 1: a hand holds it
};

}  // namespace carom
