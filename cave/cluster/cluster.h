#pragma once
// The nodes of a room, under OpenMPI: rank 0 shares each frame's record, and all ranks swap together. A
// single process runs the same code with one rank.
//
// Within the frames every wait is bounded, and a node that keeps the others waiting is named in the log after
// 0.5 s, and again when it is back. After 10 s (60 s while nodes warm up, in their first frames) the session
// ends. When a node dies, those of its machine see it after 0.1 s, and mpirun asks the others to end; one of
// them says which is gone, after it has closed its files, and all end.

#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "cave/frame/frame_timing.h"
#include "cave/record/frame_digest.h"
#include "cave/record/frame_state.h"
#include "cave/room/wall.h"

namespace carom {

/// Thrown on every rank, with the same message, if nodes differ in data that must be the same.
class NodesDiffer : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The exit status of a session that ends because a node is gone or hangs, and that can go on; of EX_TEMPFAIL
/// in sysexits.h.
inline constexpr int kNodeLost = 75;

class Cluster {
 public:
  /// Starts MPI, and uses every core of the machine unless mpirun was told to bind the process. Create one
  /// per process, before it has threads. Late and lost nodes are named in the log.
  Cluster();
  ~Cluster();
  Cluster(const Cluster&) = delete;
  Cluster& operator=(const Cluster&) = delete;

  int rank() const { return rank_; }
  int size() const { return size_; }

  /// Ends this process, after a successful session whose files are closed, once every node has come this far
  /// (cave/process/termination.h says why no objects are destroyed).
  [[noreturn]] void leave() const;

  /// Ends the job on every node at once, after a fault that only this rank has found.
  [[noreturn]] void abort(int status = 1) const;

  /// Returns whether this rank draws `wall`. With fewer ranks than nodes, rank `node mod size` draws for the
  /// node.
  bool draws(const Wall& wall) const { return wall.node % size_ == rank_; }
  /// Returns the walls that this rank draws.
  std::vector<Wall> wallsOf(std::span<const Wall> walls) const;

  /// Returns the lowest rank whose `failed` is true, or −1. Every rank must call it.
  int firstFailed(bool failed) const;

  /// Checks that every rank holds the same `content`, which messages call `what`. Throws NodesDiffer, naming
  /// the first node with another content.
  void agree(const std::string& what, std::string_view content) const;

  /// Sets the walls that messages name each node by. `walls`: those of all nodes.
  void nameNodes(std::span<const Wall> walls);

  /// Returns the name of a rank for messages, such as "node 1 (left)", with its host if there are several:
  /// "node 1 (left) on cave-left".
  std::string nameOf(int rank) const;

  /// Returns, on rank 0, the rank that keeps the others waiting at this moment, or −1. From any thread.
  int lateRank() const { return late_; }

  /// Replaces the text of every rank by rank 0's.
  void share(std::string& text) const;

  /// Returns, on rank 0, the text of every rank, in the order of ranks; elsewhere nothing.
  std::vector<std::string> gather(const std::string& text) const;

  /// Returns the name and version of the MPI library.
  static std::string libraryVersion();

  /// Replaces the state of every rank by rank 0's. Allocates memory only when a frame brings more knots or
  /// events than any before.
  void share(FrameState& state);
  /// Returns when the newest shared frame is on the walls, on the session's clock, or NaN if none was shared.
  double newest_s() const { return newest_s_; }

  /// Sets this node's report on the previous frame. It travels with the message that the current frame is
  /// drawn.
  void report(const NodeReport& mine);
  /// Returns, on rank 0, what `rank` reported with the last frame that was swapped.
  const NodeReport& reportOf(int rank) const;

  /// Says that this rank has drawn the frame. On rank 0, waits until every rank has. `wantsToEnd`: the
  /// session is asked to end on this rank.
  void gatherDrawn(const FrameState& state, const World& world, bool wantsToEnd);

  /// Waits, after `gatherDrawn`, until rank 0 has come this far, so that all can swap. Returns whether the
  /// session is asked to end on any rank. Throws NodesDiffer if a rank drew from other numbers than rank 0;
  /// the message names the frame, the node, the field and, for a history, the body. `world`: the one given to
  /// gatherDrawn.
  bool releaseSwap(const World& world);

 private:
  struct Room;  // the messages between ranks, and the pending requests

  void shareFrame(FrameState& state) const;
  void fromRankZero(void* bytes, std::size_t count) const;
  void await(std::size_t requests, bool fromAll) const;
  bool done(std::size_t requests) const;
  int firstPending(std::size_t requests) const;
  bool isHere(int rank) const;  // the rank runs on this rank's machine
  bool livesHere(int rank) const;
  bool isReported() const;
  [[noreturn]] void giveUp(const std::string& why, bool others) const;
  std::string whereHistoriesPart(std::span<const WorldLine> histories, int other) const;

  int rank_ = 0;
  int size_ = 1;
  std::uint64_t frames_ = 0;  // number of frames swapped so far
  std::uint64_t drawn_ = 0;   // number of the frame that this rank has drawn
  bool wantsToEnd_ = false;   // whether this rank asked for the end with that frame
  double newest_s_ = std::numeric_limits<double>::quiet_NaN();
  mutable std::atomic<int> late_ = -1;
  std::vector<std::string> names_;  // of each rank: the names of its walls
  std::unique_ptr<Room> room_;
};

}  // namespace carom
