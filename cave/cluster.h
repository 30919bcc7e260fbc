#pragma once
// The nodes of a room, under OpenMPI: rank 0 shares each frame's record, all swap together. A single process
// runs the same code with one rank.

#include <cstdint>
#include <span>
#include <vector>

#include "cave/frame_state.h"
#include "cave/wall.h"

namespace carom {

class Cluster {
 public:
  /// Starts MPI. One per process.
  Cluster();
  ~Cluster();
  Cluster(const Cluster&) = delete;
  Cluster& operator=(const Cluster&) = delete;

  int rank() const { return rank_; }
  int size() const { return size_; }

  /// Ends the job on every node at once, after a fault that this rank alone knows of.
  [[noreturn]] void abort() const;

  /// With fewer ranks than nodes, rank `node mod size` draws for the node.
  bool draws(const Wall& wall) const { return wall.node % size_ == rank_; }

  /// The lowest rank whose `failed` is true, or −1. Every rank must call it.
  int firstFailed(bool failed) const;

  /// Rank 0's state replaces everyone's. Allocates only when a frame brings more knots than any before.
  void share(FrameState& state);

  /// Waits until every rank has drawn the frame, then returns, everywhere, so that all can swap. `digest` is
  /// of what this rank drew from: throws std::runtime_error naming the frame and the nodes that differ from
  /// rank 0.
  void swapTogether(const FrameState& state, std::uint64_t digest);

 private:
  int rank_ = 0;
  int size_ = 1;
  std::vector<std::uint64_t> digests_;
};

/// Digest of a frame's record and of the histories' newest knots, of the same bits on every rank.
std::uint64_t digestOf(const FrameState& state, std::span<const WorldLine> histories);

}  // namespace carom
