#include "app/files/rig.h"

namespace carom {

std::vector<Wall> standingWalls(const Rig& rig) { return isHeadset(rig) ? std::vector<Wall>() : rig.walls; }

RoomGeometry roomGeometryOf(const Rig& rig) {
  RoomGeometry room{isHeadset(rig) ? std::vector{*rig.board} : rig.walls,
                    rig.axes.up,
                    rig.axes.forward,
                    {},
                    isHeadset(rig)};
  for (const ViewerSetup& viewer : rig.viewers)
    room.viewers.push_back({viewer.name, inverse(viewer.head.eyesFromSensor), viewer.hand.has_value()});
  return room;
}

std::string displayOf(const Rig& rig, int rank) {
  for (const NodeSetup& node : rig.nodes) {
    if (rank >= node.rank && rank < node.rank + node.slots) return node.display;
  }
  return {};
}

}  // namespace carom
