#pragma once
// The world tube of a puck while the game goes on: a surface to which each new knot adds what follows from
// it. What lies before the signal of a knot stays as it is.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "engine/billiard/billiard_setup.h"
#include "engine/sculpture/world_tube.h"

namespace carom {

class GrowingTube {
 public:
  /// How far ahead of the present it reaches at least; it is made in slices of kSlice_s.
  static constexpr double kAhead_s = 8.0, kSlice_s = 4.0;
  /// Of the rim's points it takes one of so many: between them it is off by at most 2 % of a disc's radius.
  static constexpr std::size_t kEvery = 3;
  /// By how much chords may be off where a point does not move straight.
  static constexpr double kChord_m = 5e-4;

  /// Follows the world line of a rigid puck from `past_s` before `now_s` on; its last leg is continued. The
  /// times of the points are counted from board time `base_s`; where that differs from the last one, all is
  /// made anew. Returns whether the surface has changed.
  bool follow(const Puck& puck, const WorldLine& line, double past_s, double now_s, double base_s);

  /// Points (x, y, c (t − base)), metres.
  std::span<const glm::vec3> points() const { return points_; }
  std::span<const std::array<std::uint32_t, 3>> triangles() const { return triangles_; }

 private:
  /// The surface between two board times, in which no signal of another knot arrives at the puck.
  struct Part {
    Knot knot;
    Span span;
    std::size_t leg = 0;                    // index of the knot
    std::size_t points = 0, triangles = 0;  // where its own begin
    bool isSame(const Part& other) const;
  };
  bool isUpToDate(const WorldLine& line, double now_s, double base_s);
  void findParts(const WorldLine& line, const Span& window);
  void forgetBefore(double from_s);
  void add(const Puck& puck, const WorldLine& line, Part part);

  /// What it was made from.
  struct Made {
    std::size_t knots = 0;
    Knot first, last;
    double slice = 0.0, base_s = 0.0;
  } made_;
  std::vector<Part> parts_, wanted_;
  std::vector<glm::vec3> points_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace carom
