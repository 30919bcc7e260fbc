#include "app/files/rig.h"

namespace carom {

RoomGeometry roomGeometryOf(const Rig& rig) {
  RoomGeometry room{rig.walls, rig.axes.up, rig.axes.forward, {}};
  for (const ViewerSetup& viewer : rig.viewers)
    room.viewers.push_back({viewer.name, inverse(viewer.head.eyesFromSensor)});
  return room;
}

std::string displayOf(const Rig& rig, int rank) {
  for (const NodeSetup& node : rig.nodes) {
    if (rank >= node.rank && rank < node.rank + node.slots) return node.display;
  }
  return {};
}

}  // namespace carom
