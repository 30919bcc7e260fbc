#pragma once
// The nodes of a room, under OpenMPI: rank 0 shares each frame's record, all swap together. A single process
// runs the same code with one rank.
//
// In the frames every wait has an end and a name. A node that keeps the others waiting is named after 0.5 s,
// and again when it is back; after 10 s (60 s while nodes warm up, in their first frames) the session ends.
// When a node dies, mpirun asks the others to end; they say which one is gone and end within half a second.

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "cave/frame/frame_digest.h"
#include "cave/frame/frame_state.h"
#include "cave/frame/frame_timing.h"
#include "cave/room/wall.h"

namespace carom {

/// Nodes hold different things that must be the same. Thrown on every rank, with the same words.
class NodesDiffer : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Cluster {
 public:
  /// Starts MPI, on every core of the machine unless mpirun was told to bind. One per process, before it has
  /// threads. Late and lost nodes are told in the log.
  Cluster();
  ~Cluster();
  Cluster(const Cluster&) = delete;
  Cluster& operator=(const Cluster&) = delete;

  int rank() const { return rank_; }
  int size() const { return size_; }

  /// Ends this process after a session that went well and whose files are closed, once every node is so far
  /// (cave/process/termination.h says why nothing is taken down).
  [[noreturn]] void leave() const;

  /// Ends the job on every node at once, after a fault that this rank alone knows of.
  [[noreturn]] void abort() const;

  /// With fewer ranks than nodes, rank `node mod size` draws for the node.
  bool draws(const Wall& wall) const { return wall.node % size_ == rank_; }
  /// Returns those of the walls that this rank draws.
  std::vector<Wall> wallsOf(std::span<const Wall> walls) const;

  /// The lowest rank whose `failed` is true, or −1. Every rank must call it.
  int firstFailed(bool failed) const;

  /// Every rank must hold the same `content`, of which `what` is the name: throws NodesDiffer, naming the
  /// first node that holds another.
  void agree(const std::string& what, std::string_view content) const;

  /// What each node draws, for the lines about it: all of `walls`, of all nodes.
  void nameNodes(std::span<const Wall> walls);

  /// "node 1 (left)".
  std::string nameOf(int rank) const;

  /// Rank 0's text replaces everyone's.
  void share(std::string& text) const;

  /// Rank 0's state replaces everyone's. Allocates only when a frame brings more knots or events
  /// than any before.
  void share(FrameState& state);
  /// When the newest frame that was shared is on the walls, on the session's clock; NaN: there was none.
  double newest_s() const { return newest_s_; }

  /// What this node says of the frame before: it travels with the word that this one is drawn.
  void report(const NodeReport& mine);
  /// On rank 0, what each node has said with the last frame that was swapped; by rank.
  const NodeReport& reportOf(int rank) const;

  /// This rank has drawn the frame. On rank 0, waits until every rank has. `wantsToEnd`: somebody here does.
  void gatherDrawn(const FrameState& state, const World& world, bool wantsToEnd);

  /// After `gatherDrawn`, waits until rank 0 is here, so that all can swap; returns whether somebody wants to end, on
  /// any rank. Throws NodesDiffer if a rank drew from other numbers than rank 0, naming the frame, the node, the field
  /// and, of a history, the body. `world`: that of gatherDrawn.
  bool releaseSwap(const World& world);

 private:
  struct Room;  // what the ranks say to each other, and the requests under way

  void shareFrame(FrameState& state) const;
  void fromRankZero(void* bytes, std::size_t count) const;
  void await(std::size_t requests, bool fromAll) const;
  bool done(std::size_t requests) const;
  int firstPending(std::size_t requests) const;
  bool isHere(int rank) const;  // on this rank's machine
  bool livesHere(int rank) const;
  [[noreturn]] void giveUp(const std::string& why, bool others) const;
  std::string whereHistoriesPart(std::span<const WorldLine> histories, int other) const;

  int rank_ = 0;
  int size_ = 1;
  std::uint64_t frames_ = 0;  // swapped so far
  std::uint64_t drawn_ = 0;   // the frame that this rank has drawn
  bool wantsToEnd_ = false;   // somebody on this rank, then
  double newest_s_ = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::string> names_;  // of the walls of each rank
  std::unique_ptr<Room> room_;
};

}  // namespace carom
