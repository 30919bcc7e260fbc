#include "app/stage/all_ranks.h"

#include <cstdio>
#include <exception>
#include <string>

#include "app/files/input_file.h"

namespace carom {
namespace {

/// What to tell the person; names the node where it is not the one they sit at.
std::string messageOf(const Cluster& cluster, const std::exception& error) {
  const std::string node = cluster.rank() == 0 ? "" : " (node " + std::to_string(cluster.rank()) + ")";
  const auto* input = dynamic_cast<const InputErrors*>(&error);
  if (!input) return std::string("error: ") + error.what() + node;
  std::string lines;
  for (const InputError& fault : input->faults()) {
    lines += (lines.empty() ? "error: " : "\nerror: ") + std::string(fault.what()) + node;
  }
  return lines;
}

}  // namespace

void onAllRanks(const Cluster& cluster, const std::function<void()>& step) {
  std::string message;
  try {
    step();
  } catch (const std::exception& error) {
    message = messageOf(cluster, error);
  }
  const int failed = cluster.firstFailed(!message.empty());
  if (failed < 0) return;
  if (failed == cluster.rank()) std::fprintf(stderr, "%s\n", message.c_str());
  throw RankFailed{};
}

int runOnCluster(const std::function<void(Cluster&)>& session) {
  Cluster cluster;
  try {
    session(cluster);
    return 0;
  } catch (const RankFailed&) {
    return 1;
  } catch (const NodesDiffer& error) {
    if (cluster.rank() == 0) std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", messageOf(cluster, error).c_str());
    if (cluster.size() > 1) cluster.abort();
    return 1;
  }
}

}  // namespace carom
