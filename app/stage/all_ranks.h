#pragma once
// Steps that succeed on every rank or fail on all.

#include <functional>

#include "cave/cluster/cluster.h"

namespace carom {

/// Thrown on every rank after one has failed and logged the reason.
struct RankFailed {};

/// Runs `step` on every rank. If it fails on any, the lowest such rank logs the reason and RankFailed is
/// thrown on all.
void onAllRanks(const Cluster& cluster, const std::function<void()>& step);

/// Runs a whole session on this rank. If all goes well, the rank leaves by itself (Cluster::leave) or returns
/// exit status 0; after an error the log gives the reason and the status is 1. `failed` then runs on the rank
/// that logged the error, before the others are ended.
int runOnCluster(const std::function<void(Cluster&)>& session,
                 const std::function<void(const Cluster&)>& failed = {});

}  // namespace carom
