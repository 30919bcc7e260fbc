#include "app/room_formats/sgct_nodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "app/room_checks/foreign_room.h"
#include "app/room_parts/room_parts.h"

namespace carom {
namespace {

struct SgctComputer {
  std::string address;
  FilePlace at;
};

/// Returns whether an address is of the computer itself: SGCT simulates clusters by 127.0.0.2 and so on.
bool isThisOne(const std::string& address) {
  return address.empty() || address == "localhost" || address.starts_with("127.");
}

std::vector<SgctComputer> computersOf(const JsonNode& nodes) {
  std::vector<SgctComputer> computers;
  for (const JsonNode& node : nodes.children) {
    const JsonNode* address = node.member("address");
    const bool isText = address && address->kind == JsonNode::Kind::text;
    computers.push_back({isText ? address->text : "", isText ? address->at : node.at});
  }
  return computers;
}

}  // namespace

void addSgctNodes(const JsonNode& root, Room& room) {
  const JsonNode* nodes = root.member("nodes");
  if (!nodes) return;
  const std::vector<SgctComputer> computers = computersOf(*nodes);
  if (const JsonNode* master = root.member("masteraddress")) {
    const auto found = std::find_if(computers.begin(), computers.end(), [&](const SgctComputer& computer) {
      return computer.address == master->text;
    });
    if (found != computers.begin() && !isThisOne(master->text)) {
      addWarning(room, master->at,
                 found == computers.end()
                     ? fmt::format("no node has the address of the master '{}': here the first leads",
                                   printable(master->text))
                     : fmt::format("the master '{}' is node {}: here the first leads, which has rank 0",
                                   printable(master->text), found - computers.begin()));
    }
  }
  if (std::all_of(computers.begin(), computers.end(),
                  [](const SgctComputer& computer) { return isThisOne(computer.address); }))
    return;
  Ranks ranks(room);
  for (const SgctComputer& computer : computers)
    ranks.next(isThisOne(computer.address) ? "" : computer.address, computer.at);
  ranks.finish();
}

}  // namespace carom
