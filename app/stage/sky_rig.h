#pragma once
// A picture by direction in the place of a room's walls, for planetariums and films of 360°.

#include <optional>

#include "app/rig/rig.h"
#include "cave/screen/sky.h"

namespace carom {

struct SkyPicture {
  SkyKind kind = SkyKind::fisheye;
  int size_px = 2048;               ///< across a fisheye's circle, all longitudes or a square of a cubemap
  std::optional<glm::dvec3> eye_m;  ///< a place in the room from which it is seen; none: the recorded head
  bool twoEyes = false;             ///< the left eye's picture above the right eye's
};

/// Returns the rig with the picture in the place of its walls, on the first node. Words stand where they
/// stood. Throws std::runtime_error if the rig is a headset.
Rig withSky(Rig rig, const SkyPicture& picture);

}  // namespace carom
