#pragma once
// Sampled histories, for bodies that deform or move freely (a hand, another person's head, a soft body). The
// ring is a table of past events of every vertex (place, board time and proper time), in which new samples
// replace the oldest ones, as in the paper's section 3.2. Between two samples a vertex moves straight and
// evenly.
//
// Rows are samples of the whole mesh and are kept in float from an anchor event in double, so nothing is lost
// after hours. Memory is fixed when the ring is made. Board frame throughout.
// Theory: app/doc/physics.md, Sampled histories.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "engine/spacetime/event.h"

namespace carom {

/// One sample of a mesh: an event of each vertex, as c t, x, y, z from a common anchor near them (metres).
/// The events need not be simultaneous.
struct MeshSample {
  Event anchor;
  std::span<const float> ct_m;
  std::span<const float> x_m;
  std::span<const float> y_m;
  std::span<const float> z_m;
};

/// How far, in metres of light, an eye may step back in time. When the head turns fast, the eyes' events move
/// by up to γ (1 + β) times their separation against the head's. Trimming leaves this margin.
inline constexpr double kEyeStepsBack_m = 1.0;

class VertexRing {
 public:
  /// Makes room for `capacity` samples (at least 3, at most 65535) of `vertexCount` vertices: 20 bytes a
  /// vertex.
  VertexRing(std::size_t vertexCount, std::size_t capacity, double c_m_s);

  /// Adds a sample. Every vertex must be later than its last event and have moved slower than light since;
  /// otherwise throws std::invalid_argument, which names the first vertex that did not, and keeps nothing of
  /// the sample. When the ring is full, it drops the sample between the first and the last that matters
  /// least: one that is close to its neighbours for its age. Histories therefore grow coarser with age, but
  /// have no gaps and stay slower than light.
  void append(const MeshSample& sample);

  /// Removes the samples that no eye will need again: all but the last of those in which every vertex lies
  /// inside the past cone of each of `eyes`, by kEyeStepsBack_m at least.
  void trim(std::span<const Event> eyes);

  std::size_t vertexCount() const { return vertexCount_; }
  std::size_t sampleCount() const { return order_.size(); }
  std::size_t capacity() const { return capacity_; }
  double lightSpeed_m_s() const { return c_m_s_; }

  /// Samples count from the oldest. The vertex's own clock shows 0 in the first sample ever given.
  Event eventOf(std::size_t sample, std::size_t vertex) const;
  double properTime_s(std::size_t sample, std::size_t vertex) const;

  /// kRun neighbouring vertices of a sample, stored together: events from the sample's anchor (metres).
  static constexpr std::size_t kRun = 32;
  struct alignas(64) Run {
    std::array<float, kRun> ct_m, x_m, y_m, z_m;
  };
  const Event& anchorOf(std::size_t sample) const { return anchors_[order_[sample]].event; }
  /// Returns all runs of a sample; the last run may have unused places.
  const Run* runsOf(std::size_t sample) const { return runs_.data() + order_[sample] * runCount(); }
  std::size_t runCount() const { return (vertexCount_ + kRun - 1) / kRun; }

 private:
  struct Anchor {
    Event event;
    double properTime_s = 0.0;
  };
  /// Returns a vertex's event in a sample, from the anchor of the sample.
  glm::vec4 fromAnchor(std::size_t sample, std::size_t vertex) const {
    const Run& run = runsOf(sample)[vertex / kRun];
    const std::size_t i = vertex % kRun;
    return {run.ct_m[i], run.x_m[i], run.y_m[i], run.z_m[i]};
  }
  /// Returns the own time of a vertex from sample `last` to a new one; negative if it would not be slower
  /// than light.
  double properTimeSince(std::size_t last, const MeshSample& sample, std::size_t vertex) const;
  void fillRow(std::uint16_t row, const MeshSample& sample);
  void giveWay();
  bool insideCone(std::size_t sample, const Event& eye) const;

  std::size_t vertexCount_;
  std::size_t capacity_;
  double c_m_s_;
  std::vector<Run> runs_;             // of each row
  std::vector<float> ownTimes_s_;     // of each row, from its anchor's
  std::vector<Anchor> anchors_;       // by row
  std::vector<std::uint16_t> order_;  // rows, oldest sample first
  std::vector<std::uint16_t> free_;   // rows not in use
  std::vector<double> properTime_;    // of every vertex at the last sample
};

}  // namespace carom
