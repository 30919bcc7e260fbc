#pragma once
// The part of `carom doctor RIG` that judges the link with another room.

#include "app/rig/rig.h"
#include "app/room_commands/node_health.h"

namespace carom {

/// Judges key, port and line of a rig's [link]; takes some seconds if the rig says whom it calls. Does
/// nothing without a link.
void lookAtLink(const Rig& rig, NodeHealth& report);

}  // namespace carom
