#include "app/nodes/rig_without.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace carom {
namespace {

/// Returns whom a person looks for: the host of a rank, or its number.
std::string nameOfNode(const Rig& rig, int rank) {
  for (const NodeSetup& node : rig.nodes) {
    if (rank >= node.rank && rank < node.rank + node.slots && !node.host.empty()) return node.host;
  }
  return fmt::format("node {}", rank);
}

/// Adds the walls of a rank to those of its computer.
void addMissing(Rig& rig, int rank) {
  const std::string name = nameOfNode(rig, rank);
  auto found = std::find_if(rig.missing.begin(), rig.missing.end(),
                            [&](const MissingNode& node) { return node.name == name; });
  if (found == rig.missing.end()) found = rig.missing.insert(found, {name, {}});
  for (const Wall& wall : rig.walls) {
    if (wall.node == rank) found->walls.push_back(wall.name);
  }
}

}  // namespace

Rig rigWithout(Rig rig, std::vector<int> nodes) {
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  const auto isOut = [&](int rank) { return std::binary_search(nodes.begin(), nodes.end(), rank); };
  const auto moved = [&](int rank) {
    return rank - static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), rank) - nodes.begin());
  };
  const int last = nodesOf(rig) - 1;
  for (const int node : nodes) {
    if (node < 1 || node > last)
      throw std::runtime_error(
          fmt::format("node {} cannot be left out, expected one of 1 to {}, the rig's last", node, last));
    addMissing(rig, node);
  }
  std::erase_if(rig.walls, [&](const Wall& wall) { return isOut(wall.node); });
  if (rig.walls.empty()) throw std::runtime_error("no wall is left, expected a node that draws one");
  for (Wall& wall : rig.walls) wall.node = moved(wall.node);
  std::vector<NodeSetup> left;
  for (const NodeSetup& node : rig.nodes) {
    for (int rank = node.rank; rank < node.rank + node.slots; ++rank) {
      if (!isOut(rank)) left.push_back({.rank = moved(rank), .display = node.display, .host = node.host});
    }
  }
  rig.nodes = left;
  return rig;
}

}  // namespace carom
