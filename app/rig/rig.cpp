#include "app/rig/rig.h"

#include <algorithm>
#include <utility>

#include "cave/screen/curved_screen.h"

namespace carom {

std::vector<Wall> drawnWalls(const Rig& rig) {
  std::vector<Wall> walls;
  for (const Wall& wall : rig.walls) {
    for (Wall& flat : flatWallsOf(wall)) walls.push_back(std::move(flat));
  }
  return walls;
}

std::vector<Wall> standingWalls(const Rig& rig) {
  if (isHeadset(rig)) return {};
  std::vector<Wall> walls = drawnWalls(rig);
  std::erase_if(walls, [](const Wall& wall) { return wall.sky.has_value(); });
  return walls;
}

RoomGeometry roomGeometryOf(const Rig& rig) {
  RoomGeometry room{
      {}, rig.axes.up, rig.axes.forward, {}, isHeadset(rig) ? rig.board : rig.panel, isHeadset(rig)};
  if (isHeadset(rig))
    room.walls = {*rig.board};
  else
    room.walls = standingWalls(rig);
  if (room.walls.empty() && rig.panel) room.walls = {*rig.panel};  // of pictures by direction alone
  for (const ViewerSetup& viewer : rig.viewers)
    room.viewers.push_back({viewer.name, inverse(viewer.head.eyesFromSensor), viewer.hand.has_value()});
  return room;
}

int nodesOf(const Rig& rig) {
  int nodes = 1;
  for (const Wall& wall : rig.walls) nodes = std::max(nodes, wall.node + 1);
  for (const NodeSetup& node : rig.nodes) nodes = std::max(nodes, node.rank + node.slots);
  return nodes;
}

std::string displayOf(const Rig& rig, int rank) {
  for (const NodeSetup& node : rig.nodes) {
    if (rank >= node.rank && rank < node.rank + node.slots) return node.display;
  }
  return {};
}

}  // namespace carom
