#pragma once
// The part of `carom doctor` about the room as a whole: its trackers, links between nodes, disk and ports.

#include <filesystem>

#include "app/rig/rig.h"
#include "app/room_commands/node_health.h"
#include "cave/cluster/cluster.h"

namespace carom {

/// Listens to the rig's devices for some seconds: do they send, how often, and the sensors that the rig uses?
/// Returns how many poses they all send in a second.
double judgeTrackers(const Rig& rig, NodeHealth& report);

/// Opens the rig's force devices for a moment: are they there, what can they do, do they say where they are?
void judgeForces(const Rig& rig, NodeHealth& report);

/// Judges the messages between the nodes. Every rank must call it; the report is rank 0's.
void judgeLinks(const Cluster& cluster, const Rig& rig, NodeHealth& report);

/// Judges the space for session files in a folder, in hours of session. `rig` may be null; `poses_hz`: those
/// of its trackers.
void judgeDisk(const std::filesystem::path& folder, const Rig* rig, double poses_hz, NodeHealth& report);

/// Judges the ports that the rig fixes for the messages of the nodes. `ranks`: those on this computer.
void judgePorts(const Rig& rig, int ranks, NodeHealth& report);

/// Judges the rig's playlist, if it has one, and lists the files of the rig.
void judgeFiles(const Rig& rig, NodeHealth& report);

}  // namespace carom
