#include "app/stage/all_ranks.h"

#include <exception>
#include <string>

#include "app/toml/input_file.h"
#include "engine/text/log.h"

namespace carom {
namespace {

/// Logs the error, with the node unless it is rank 0.
void sayWhy(const Cluster& cluster, const std::exception& error) {
  const std::string node = cluster.rank() == 0 ? "" : "node " + std::to_string(cluster.rank()) + ": ";
  if (const auto* input = dynamic_cast<const InputErrors*>(&error)) {
    for (const InputError& fault : input->faults()) log::error(node + fault.what());
  } else {
    log::error(node + error.what());
  }
}

}  // namespace

void onAllRanks(const Cluster& cluster, const std::function<void()>& step) {
  std::exception_ptr error;
  try {
    step();
  } catch (const std::exception&) {
    error = std::current_exception();
  }
  const int failed = cluster.firstFailed(error != nullptr);
  if (failed < 0) return;
  try {
    if (failed == cluster.rank()) std::rethrow_exception(error);
  } catch (const std::exception& why) {
    sayWhy(cluster, why);
  }
  throw RankFailed{};
}

int runOnCluster(const std::function<void(Cluster&)>& session,
                 const std::function<void(const Cluster&)>& failed) {
  Cluster cluster;
  const auto tell = [&] {
    if (failed) failed(cluster);
  };
  try {
    session(cluster);
    return 0;
  } catch (const RankFailed&) {
    if (cluster.rank() == 0) tell();
    return 1;
  } catch (const NodesDiffer& error) {
    if (cluster.rank() > 0) return 1;
    log::error(error.what());
    tell();
    return 1;
  } catch (const std::exception& error) {
    sayWhy(cluster, error);
    tell();
    if (cluster.size() > 1) cluster.abort();
    return 1;
  }
}

}  // namespace carom
