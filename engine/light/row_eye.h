#pragma once
// One eye that looks at points whose histories are rows: places at common board times, between which every
// point moves straight and evenly. For soft pucks and told deforming bodies, which are drawn from their rows;
// it knows all switches and moments of ViewTime. With (T, X) a point's event from the observation, and a step
// later (T + ΔT, X + ΔX), it is seen where f = −T − |X| vanishes. f falls along all that is slower than
// light, so one pair of rows has f ≥ 0 before and f < 0 after. The retarded root, and at the other moments:
//     s = C/(B + sqrt(B² − A C)),   A = ΔT² − ΔX²,   B = X·ΔX − T ΔT,   C = T² − X²
//     s = −T/ΔT   at the board's present
//     s = −(T − β·X)/(ΔT − β·ΔX)   at the present of a head that moves with β on the board
//
// Theory: app/doc/physics.md, Sampled histories.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "engine/light/light_cone.h"

namespace carom {

/// Rows as one eye has them.
template <typename Rows>
concept RowsOfEye = requires(const Rows& rows, std::size_t k, std::size_t point) {
  { rows.count() } -> std::convertible_to<std::size_t>;  // at least one
  { rows.time_m(k) } -> std::convertible_to<double>;     // c (t − t_o)
  { rows.fromEye_m(k, point) } -> std::convertible_to<Vec3>;
  { rows.velocityBefore(point) } -> std::convertible_to<Vec3>;  // over c, before the first row
  { rows.velocityAfter(point) } -> std::convertible_to<Vec3>;   // and after the last
};

/// Where in its history a point is seen: between `row` and the next by `share`, or before all rows or after
/// them.
struct RowSpot {
  std::size_t row = 0;
  double share = 0.0;  ///< 0 before all rows and after them
  bool isBeforeAll = false;
  double boardTime_m = 0.0;  ///< c (t − t_o)
  Vec3 fromEye_m{0.0};       ///< on the board
};

class RowEye {
 public:
  /// An eye at `observation`, with the frame that walls draw by these switches.
  RowEye(const Event& observation, const Lorentz& headFromBoard, const Switches& switches,
         ViewTime moment = ViewTime::seen);

  const Event& observation() const { return observation_; }
  /// Whether bodies are drawn contracted; if not, rows are to give stretched places.
  bool isContracted() const { return isContracted_; }

  /// Finds a point; the search starts at row `guess`.
  template <RowsOfEye Rows>
  RowSpot find(const Rows& rows, std::size_t point, std::size_t guess) const;

  /// Whether what the eye shows of a point is at an event, from the observation, or later.
  bool isAtOrAfter(double time_m, const Vec3& fromEye_m) const;
  /// Returns where an event is drawn, from the eye.
  Vec3 drawn(double boardTime_m, const Vec3& fromEye_m) const;
  /// Does the same for a place as the emission kernel gives it.
  Vec3 drawnAtSeen(const Vec3& seen) const;
  /// Returns the time that shaders are told for an event: none where bodies are at the board's present.
  double toldTime_m(double boardTime_m) const { return kind_ == Kind::boardNow ? 0.0 : boardTime_m; }

 private:
  enum class Kind { seen, boardNow, myNow };
  /// The share of a step after which the point is shown.
  double shareOf(double time_m, const Vec3& from_m, double step_m, const Vec3& way_m) const;
  static RowSpot spotOn(std::size_t row, double share, double time_m, const Vec3& from_m, double step_m,
                        const Vec3& way_m) {
    return {row, share, false, time_m + share * step_m, from_m + share * way_m};
  }

  Event observation_;
  Kind kind_;
  bool isContracted_, isAberrated_;
  ViewFrame frame_;
  Vec3 headBeta_;
};

template <RowsOfEye Rows>
RowSpot RowEye::find(const Rows& rows, std::size_t point, std::size_t guess) const {
  const std::size_t last = rows.count() - 1;
  std::size_t row = std::min(guess, last);
  while (row > 0 && !isAtOrAfter(rows.time_m(row), rows.fromEye_m(row, point))) --row;
  const Vec3 from = rows.fromEye_m(row, point);
  if (!isAtOrAfter(rows.time_m(row), from)) {
    const Vec3 v = rows.velocityBefore(point);
    RowSpot spot = spotOn(0, shareOf(rows.time_m(0), from, 1.0, v), rows.time_m(0), from, 1.0, v);
    spot.share = 0.0;
    spot.isBeforeAll = true;
    return spot;
  }
  Vec3 here = from;
  while (row < last) {
    const Vec3 next = rows.fromEye_m(row + 1, point);
    const double time = rows.time_m(row), step = rows.time_m(row + 1) - time;
    if (!isAtOrAfter(time + step, next)) {
      const double share = std::clamp(shareOf(time, here, step, next - here), 0.0, 1.0);
      return spotOn(row, share, time, here, step, next - here);
    }
    here = next;
    ++row;
  }
  const Vec3 v = rows.velocityAfter(point);
  RowSpot spot = spotOn(row, shareOf(rows.time_m(row), here, 1.0, v), rows.time_m(row), here, 1.0, v);
  spot.share = 0.0;
  return spot;
}

}  // namespace carom
