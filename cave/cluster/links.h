#pragma once
// The speed of the messages between node 0 and each of the others, before a session depends on it.

#include <vector>

#include "cave/cluster/cluster.h"

namespace carom {

/// The messages between node 0 and another.
struct LinkFigures {
  double median_s = 0.0;  ///< of the round trips of a small message, sent at the pace of frames
  double late_s = 0.0;    ///< their 95th percentile
  double bytes_per_s = 0.0;
};

/// Measures node 0's links one after the other, about half a second each. Every rank must call it. Returns,
/// on rank 0, the figures by rank, the first of them zero; elsewhere nothing.
std::vector<LinkFigures> measureLinks(const Cluster& cluster);

}  // namespace carom
