#pragma once
// Reads the nodes of a rig file and how they are started.

#include "app/rig/rig.h"
#include "app/toml/toml_file.h"

namespace carom {

NodeSetup readNode(const TomlTable& table);

StartSetup readStart(const TomlTable& table);

/// Reports ranks that are in two entries.
void checkNodes(const std::vector<NodeSetup>& nodes, const std::vector<TomlTable>& tables);

}  // namespace carom
