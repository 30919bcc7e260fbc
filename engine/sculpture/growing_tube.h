#pragma once
// The world tube of a puck while the game goes on: a surface to which each new knot, or row of a soft puck,
// adds what follows from it. What lies before the signal of a knot stays as it is.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "engine/game/billiard_setup.h"
#include "engine/sculpture/soft_rim.h"
#include "engine/sculpture/world_tube.h"

namespace carom {

class GrowingTube {
 public:
  /// How far ahead of the present it reaches at least; it is made in slices of kSlice_s.
  static constexpr double kAhead_s = 8.0, kSlice_s = 4.0;

  /// Follows the world line of a rigid puck from `past_s` before `now_s` on; its last leg is continued. It is
  /// as coarse as `fine_m` allows: that far it may be off, at right angles to a disc's tube and along the
  /// board. The times of the points are counted from board time `base_s`. Where that or `fine_m` differs from
  /// the last one, all is made anew. Returns whether the surface has changed.
  bool follow(const Puck& puck, const WorldLine& line, double past_s, double now_s, double base_s,
              double fine_m);

  /// The same of a soft puck that has rows.
  bool follow(const SoftRim& rim, double past_s, double now_s, double base_s, double fine_m);

  /// Points (x, y, c (t − base)), metres.
  std::span<const glm::vec3> points() const { return points_; }
  std::span<const std::array<std::uint32_t, 3>> triangles() const { return triangles_; }

  /// Returns those among which all are that reach into a span of board times.
  TriangleRange trianglesIn(const Span& span) const;

 private:
  /// The surface of one slice.
  struct Part {
    Span span;
    std::size_t firstLeg = 0;
    std::vector<Knot> knots;                // those whose signals reach a point of the slice
    SliceOfRows rows;                       // of a soft puck
    std::size_t points = 0, triangles = 0;  // where its own begin
  };
  /// What a slice is to be made from: some knots of a line, or rows.
  struct Wanted {
    Span span;
    std::size_t firstLeg = 0, behind = 0;
    SliceOfRows rows;
  };
  static bool isSame(const Part& part, const Wanted& wanted, const WorldLine* line);
  void clear();
  bool isUpToDate(const WorldLine& line, const Span& window, double base_s, double fine_m);
  void findParts(const WorldLine& line, const Span& window);
  void forgetBefore(double from_s);
  void findParts(const SoftRim& rim, const Span& window);
  void add(const Puck& puck, const WorldLine& line, const Wanted& wanted);
  void add(const SoftRim& rim, const Wanted& wanted);
  void append(const std::vector<std::vector<Event>>& events, double c_m_s, Part part);
  template <typename Add>
  bool remake(const WorldLine* line, const Add& add);

  /// What it was made from.
  struct Made {
    std::size_t knots = 0;
    Knot first, last;
    Span window;
    double base_s = 0.0, fine_m = 0.0;
    bool isSoft = false;
  } made_;
  std::vector<Part> parts_;
  std::vector<Wanted> wanted_;
  std::vector<glm::vec3> points_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

/// Leaves out events between the first and the last, as long as the straight line over those left out is
/// nowhere further from them than `off_m` at the same board time.
void thin(std::vector<Event>& events, double off_m);

}  // namespace carom
