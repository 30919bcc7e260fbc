#pragma once
// One mesh as one eye sees it. Callers use it in the same way whatever holds the history of its vertices: the
// knots of a rigid body (RigidMeshView), or samples of a body that deforms or moves freely (RingView,
// engine/light/vertex_ring.h). Keep one view for each eye from frame to frame: it remembers where it found
// the last emissions.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "engine/light/light_cone.h"
#include "engine/light/mesh_emission.h"

namespace carom {

class MeshView {
 public:
  virtual ~MeshView() = default;

  virtual std::size_t size() const = 0;  ///< vertices

  /// Sets the eye to the board event `observation`, in whose past all following solves look for emissions.
  /// Call it once a frame, after the history has been extended.
  virtual void look(const Event& observation, const Lorentz& headFromBoard) = 0;

  /// Solves for the vertices from `first` on, as many as `seen` has room for; returns how many of them are
  /// unseen. Slices that begin at multiples of kSlice may be solved by several threads at once, with the
  /// same bits for any number of threads. Allocates nothing.
  virtual std::size_t see(std::size_t first, const SeenPoints& seen) = 0;
  static constexpr std::size_t kSlice = 1024;

  /// Writes the readings of the vertices' own clocks at emission, from vertex `first` on, for the board times
  /// that see() has written for them.
  virtual void properTimes(std::size_t first, std::span<const float> boardTime_m,
                           std::span<double> properTime_s) = 0;

  /// Returns the emission of one vertex, in double; none if it is unseen.
  virtual std::optional<Emission> emission(std::size_t vertex) const = 0;
};

/// The view of a rigid body: a world line and the intrinsic places of the vertices, which must both
/// outlive the view.
class RigidMeshView final : public MeshView {
 public:
  RigidMeshView(const WorldLine& line, const Points& offsets) : line_(line), offsets_(offsets) {}

  std::size_t size() const override { return offsets_.size(); }
  void look(const Event& observation, const Lorentz& headFromBoard) override;
  std::size_t see(std::size_t first, const SeenPoints& seen) override;
  /// Computes the history of each vertex, which takes about a microsecond for each bounce.
  void properTimes(std::size_t first, std::span<const float> boardTime_m,
                   std::span<double> properTime_s) override;
  std::optional<Emission> emission(std::size_t vertex) const override;

 private:
  Vec3 offset_m(std::size_t vertex) const;

  const WorldLine& line_;
  Points offsets_;
  Event observation_;
  Lorentz headFromBoard_{1.0};
  BodyView view_;
};

}  // namespace carom
