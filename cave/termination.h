#pragma once
// Ctrl-C, and what mpirun sends to the other nodes when one of them has died.

namespace carom {

/// From now on SIGINT and SIGTERM ask this process to end instead of ending it. A second Ctrl-C ends it at
/// once.
void noticeTermination();

/// Whether they have.
bool terminationAsked();

}  // namespace carom
