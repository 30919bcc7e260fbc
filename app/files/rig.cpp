#include "app/files/rig.h"

namespace carom {

RoomGeometry roomGeometryOf(const Rig& rig) {
  return {rig.walls, rig.axes.up, rig.axes.forward, inverse(rig.head.eyesFromSensor)};
}

std::string displayOf(const Rig& rig, int rank) {
  for (const NodeSetup& node : rig.nodes) {
    if (rank >= node.rank && rank < node.rank + node.slots) return node.display;
  }
  return {};
}

}  // namespace carom
