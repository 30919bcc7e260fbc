#pragma once
// Histories of a few points in double, as rows of places at board times: straight and even between two rows,
// and after the last row as in the last interval. A point is unseen before its first row's light has come. (A
// vertex_ring.h keeps those of whole meshes, in float.) Theory: app/doc/physics.md, Sampled histories.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "engine/light/light_cone.h"

namespace carom {

class SampledHistory {
 public:
  /// Takes at least two ascending times and for each of them, one after the other, the places of all
  /// vertices. Every vertex is slower than light; `velocities`, over c, are those with which it shines at the
  /// rows, if they are not those of the intervals.
  SampledHistory(double c_m_s, std::vector<double> times_s, std::vector<Vec3> places_m,
                 std::vector<Vec3> velocities = {});

  std::size_t rowCount() const { return times_s_.size(); }
  std::size_t vertexCount() const { return places_m_.size() / times_s_.size(); }
  double lightSpeed_m_s() const { return c_m_s_; }
  double time_s(std::size_t row) const { return times_s_[row]; }
  const Vec3& place_m(std::size_t row, std::size_t vertex) const {
    return places_m_[row * vertexCount() + vertex];
  }

  /// Returns the emission event of a vertex; its clock shows 0 at the first row.
  std::optional<Emission> seenAt(std::size_t vertex, const Event& observation,
                                 const Lorentz& headFromBoard) const;

 private:
  Event eventOf(std::size_t row, std::size_t vertex) const {
    return {times_s_[row], places_m_[row * vertexCount() + vertex]};
  }
  double insideBy_m(std::size_t row, std::size_t vertex, const Event& observation) const;
  double properTime_s(std::size_t row, std::size_t vertex) const;
  Vec3 shiningU(std::size_t row, std::size_t vertex, double share, const Vec3& chordU) const;

  double c_m_s_;
  std::vector<double> times_s_;
  std::vector<Vec3> places_m_;
  std::vector<Vec3> velocities_;
};

}  // namespace carom
