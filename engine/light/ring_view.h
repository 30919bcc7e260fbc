#pragma once
// The view of a sampled history (engine/light/vertex_ring.h) by one eye.
// Theory: app/doc/physics.md, Sampled histories.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/light/mesh_view.h"
#include "engine/light/vertex_ring.h"

namespace carom {

/// A view of a ring, which must outlive it. Each run of vertices remembers where its emissions were; the
/// search starts there and goes in either direction, or by bisection after the eye has jumped.
class RingView final : public MeshView {
 public:
  /// One sample as a solve takes it: its anchor from the eye, and its runs.
  struct Sample {
    float anchorT, anchorX, anchorY, anchorZ;
    const VertexRing::Run* runs;
  };

  explicit RingView(const VertexRing& ring, InstructionSet instructions = bestInstructionSet());

  std::size_t size() const override { return ring_.vertexCount(); }
  void look(const Event& observation, const Lorentz& headFromBoard) override;
  std::size_t see(std::size_t first, const SeenPoints& seen) override;
  void properTimes(std::size_t first, std::span<const float> boardTime_m,
                   std::span<double> properTime_s) override;
  std::optional<Emission> emission(std::size_t vertex) const override;

 private:
  /// f(t) = c (t_o − t) − |r_o − r(t)| of a vertex at a sample.
  double fAt(std::size_t sample, std::size_t vertex) const;
  /// The last sample with f ≥ 0; the first sample if there is none.
  std::size_t lastBefore(std::size_t vertex) const;
  /// A vertex's straight path between two samples, in double: its event and own clock at the first, and what
  /// they gain until the second.
  struct Way {
    Displacement start;  // from the observation
    Displacement step;
    double properTime_s = 0.0;
    double properTimeStep_s = 0.0;
  };
  Way wayFrom(std::size_t sample, std::size_t vertex) const;

  const VertexRing& ring_;
  InstructionSet instructions_;
  Event observation_;
  bool looked_ = false;
  Lorentz headFromBoard_{1.0};
  std::vector<Sample> samples_;         // oldest first
  std::vector<std::uint16_t> cursors_;  // of each run: samples from the newest
};

}  // namespace carom
