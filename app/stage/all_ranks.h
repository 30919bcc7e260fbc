#pragma once
// What happens on every rank or on none.

#include <functional>

#include "cave/cluster/cluster.h"

namespace carom {

/// Raised on every rank once one has failed and said why.
struct RankFailed {};

/// Runs `step` on every rank; if it fails on any, the lowest such rank says why and RankFailed is thrown
/// everywhere.
void onAllRanks(const Cluster& cluster, const std::function<void()>& step);

/// Runs a whole session on this rank, which leaves by itself once all is well (Cluster::leave) or comes back:
/// its exit status is 0 then, or 1 after the log has told why. `failed` runs after that, on the rank that told
/// it, before the others are ended.
int runOnCluster(const std::function<void(Cluster&)>& session,
                 const std::function<void(const Cluster&)>& failed = {});

}  // namespace carom
