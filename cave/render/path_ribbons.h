#pragma once
// The ways of pucks' centres over the cloth, as ribbons that rest on the board, with a dot for every tenth of
// a second of board time and a larger one for every second. Full as far as the puck is seen to have come,
// dashed and fainter from there to where its way is known; the past fades.

#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "engine/light/switches.h"
#include "engine/spacetime/event.h"
#include "engine/spacetime/world_line.h"

namespace carom {

class PathRibbons {
 public:
  static constexpr double kPast_s = 4.0;         ///< how long a way is kept behind the seen puck
  static constexpr double kHalfWidth_m = 0.014;  ///< of the ribbon, dots included
  static constexpr double kAbove_m = 0.0015;     ///< the cloth

  /// A corner on the board. Times are counted from the board time of the mesh.
  struct Corner {
    glm::vec2 place_m{0.0F};
    float across_m = 0.0F;   ///< from the middle of the way
    float time_s = 0.0F;     ///< at which the centre is there
    float speed_m_s = 0.0F;  ///< on the board
  };

  /// Made and destroyed with the drawing context current.
  PathRibbons();
  ~PathRibbons();
  PathRibbons(const PathRibbons&) = delete;
  PathRibbons& operator=(const PathRibbons&) = delete;

  /// The ways of these pucks, for eyes at board time `now_s`; made anew only when knots have changed, or
  /// every few seconds.
  void follow(std::span<const WorldLine> pucks, double now_s);

  /// For one eye: what it has seen of each puck.
  void look(std::span<const WorldLine> pucks, const Event& observation, const Switches& switches,
            double now_s);

  /// `colours`: of the pucks, linear. `drawnFromBoard`: as ViewFrame has it. Within a GlStateGuard that tests
  /// depth and blends.
  void draw(const glm::mat4& clipFromDrawn, const glm::mat4& drawnFromBoard,
            std::span<const glm::vec3> colours) const;

 private:
  /// The way of one puck, and what it was made of.
  struct Way {
    int first = 0, count = 0;
    std::size_t knots = 0;
    double firstTurn_s = 0.0, lastTurn_s = 0.0;
    float seen_s = 0.0F, known_s = 0.0F;  // for the eye at hand
  };
  bool changed(std::span<const WorldLine> pucks, double now_s) const;

  unsigned program_ = 0, vertexArray_ = 0, buffer_ = 0;
  std::vector<Way> ways_;
  std::vector<Corner> corners_;
  double base_s_ = 0.0, madeUntil_s_ = 0.0;
  glm::vec3 eyeOnBoard_m_{0.0F};
};

/// The corners of one puck's way from board time `from_s` to `until_s`, as triangles; times from `base_s`.
void addWay(const WorldLine& puck, double from_s, double until_s, double base_s,
            std::vector<PathRibbons::Corner>& corners);

}  // namespace carom
