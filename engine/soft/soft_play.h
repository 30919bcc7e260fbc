#pragma once
// Plays all soft bodies of a table, in slices of board time beside a game of rigid pucks. c = 1, metres,
// board frame.
//
// A relaxed body in free flight is exact and costs nothing: it is asleep. It wakes at the start of the slice
// in which the circle around it meets a cushion, a stroke, a turn of the told body that holds it, or the
// circle of another body, and sleeps again when it has been left alone for 2R/c_s (c_s the speed of sound in
// the relaxed body), its elastic energy and the motion of its nodes beside its mean motion are below 1e-5 of
// its mass, and its spin below 1e-6 M R: the rest of its energy is heat then. Bodies within reach of each
// other take common steps; others do not know of each other.
//
// A stroke pushes the half of a body that faces it (engine/soft/soft_push.h).
// Theory: app/doc/physics.md, Soft bodies.

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/soft/far_sides.h"
#include "engine/soft/soft_collisions.h"
#include "engine/soft/soft_group.h"
#include "engine/soft/soft_player.h"
#include "engine/soft/soft_push.h"

namespace carom {

/// A rigid body near by, at the start of a slice.
struct RigidNeighbour {
  glm::dvec2 place{0.0};
  double radius = 0.0;
};

/// What the play exchanges with the rest of the world.
struct SoftAccounts {
  Vec21 motion;           ///< of the bodies
  glm::dvec2 taken{0.0};  ///< momentum, by the cushions
  Vec21 givenByStrokes;
  Vec21 givenByHolders;
  double heat = 0.0;  ///< Σ (rest mass − cold mass)
};

/// A body that could not be followed and goes on in its mean motion.
struct SoftFrozen {
  std::size_t body = 0;
  double time = 0.0;
};

class SoftPlay {
 public:
  static constexpr double kSlice = 0.005;  ///< of board time

  explicit SoftPlay(std::vector<SoftCushion> cushions);
  ~SoftPlay();
  SoftPlay(SoftPlay&&) noexcept;
  SoftPlay& operator=(SoftPlay&&) noexcept;

  /// Adds a body, asleep, at the present time. Returns its number; numbers follow the order in which bodies
  /// come.
  std::size_t add(const SoftEntry& entry);
  void addStroke(const SoftStroke& stroke);

  /// Returns the present: a multiple of kSlice.
  double time() const;
  /// Returns which of these rigid bodies come within reach of a soft one in the next slice. They want to be
  /// added.
  std::vector<std::size_t> reached(std::span<const RigidNeighbour> rigid) const;
  /// Plays the next slice, or its part until `until`, after which nothing more can be played.
  void playSlice(double until = std::numeric_limits<double>::infinity());

  const std::vector<SoftCushion>& cushions() const { return cushions_; }

  // Of a body, at the present.
  std::size_t size() const;
  const std::string& name(std::size_t body) const;
  const SoftBody& body(std::size_t body) const;
  bool isAwake(std::size_t body) const;
  double timeOf(
      std::size_t body) const;  ///< of its state: the present at the latest, while it sleeps earlier
  /// The energy's centre with its mean velocity, momentum and heat.
  SoftTotals totals(std::size_t body) const;
  glm::dvec2 centre(std::size_t body) const;  ///< of energy
  glm::dvec2 place(std::size_t body, const SoftMesh::Inside& inside) const;
  glm::dvec2 velocity(std::size_t body, const SoftMesh::Inside& inside) const;
  double clock(std::size_t body, const SoftMesh::Inside& inside) const;
  /// Fills `places` with all nodes of a body as it flies on from its state to a time, or for no time given at
  /// its state; with that of their places which fades after it has fallen asleep. Returns whether something
  /// does.
  bool drawnPlaces(std::size_t body, std::optional<double> time, std::vector<glm::dvec2>& places) const;

  /// The collisions, in the order of their first touches as the play found them, since its beginning.
  std::span<const SoftCollision> collisions() const;
  /// The places in that list of the collisions that are over, in the order in which this was known.
  std::span<const std::size_t> parted() const;
  /// The far sides that have heard of a touch, a stroke or a pull.
  std::span<const FarSides::Heard> heard() const;
  std::span<const SoftFrozen> frozen() const;
  SoftAccounts accounts() const;
  /// Returns when a stroke began to push, by its number in the order of addition.
  std::optional<double> strokeBegan(std::size_t stroke) const;

  /// Calls `stepped` with the number of a body and the time after every step of it, when it wakes, when it
  /// falls asleep, and at the end of a slice.
  void watch(std::function<void(std::size_t body, double time)> stepped);

  /// A point of the play to which it can return from anywhere later, or go on from the beginning of the slice
  /// that ends there. A play to which the time before is unknown can take it, too: then only what happens
  /// since is among its collisions and other lists.
  struct Snapshot;
  std::shared_ptr<const Snapshot> snapshot() const;
  /// A point to which it can go from anywhere.
  std::shared_ptr<const Snapshot> wholeSnapshot() const;
  void restore(const Snapshot& snapshot);

 private:
  struct Present;
  struct Cluster;

  void wakeAll(double end);
  bool mustWake(const SoftPlayer& player, double end) const;
  void fallAsleep(std::size_t body, bool atOnce);
  void restTheQuiet();
  std::vector<std::vector<std::size_t>> clusters() const;
  void play(const std::vector<std::size_t>& members, double end);
  double nextCut(const Cluster& cluster, double end) const;
  void setHolds(Cluster& cluster);
  void setPushes(const Cluster& cluster);
  void note(const Cluster& cluster);
  void book(const Cluster& cluster);
  void tell(std::size_t body) const;

  std::vector<SoftCushion> cushions_;
  std::unique_ptr<Present> now_;
  std::function<void(std::size_t, double)> stepped_;
};

}  // namespace carom
