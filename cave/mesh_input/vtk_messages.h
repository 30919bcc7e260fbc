#pragma once
// What VTK says.

namespace carom {

/// From now on warnings and errors of VTK go to the log (engine/text/log.h), each once, and not to the
/// terminal as they are.
void sendVtkMessagesToLog();

}  // namespace carom
