#include "cave/room/sky_eyes.h"

#include <glm/geometric.hpp>

namespace carom {

ObserverView viewOf(const SkyEyes& sky, const ObserverView& viewer, const Lorentz& boardFromRoom,
                    double room_s) {
  const Vec3 right_m =
      0.5 * glm::distance(viewer.left.positionInRoom_m, viewer.right.positionInRoom_m) * sky.right;
  if (sky.from_m) return viewAtRest(viewer, boardFromRoom, room_s, *sky.from_m, right_m);
  return viewOfEyes(viewer.headFromBoard, viewer.middle, right_m, viewer.properTime_s);
}

}  // namespace carom
