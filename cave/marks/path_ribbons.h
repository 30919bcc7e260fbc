#pragma once
// The paths of the pucks' centres over the cloth, as ribbons that rest on the board, with a dot for every
// tenth of a second of board time and a larger one for every second. A ribbon is solid up to where the puck
// is seen, then dashed and fainter up to where its path is known; the past fades.

#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/gl/gl_objects.h"
#include "engine/light/switches.h"
#include "engine/spacetime/event.h"
#include "engine/spacetime/world_line.h"

namespace carom {

class PathRibbons {
 public:
  static constexpr double kPast_s = 4.0;         ///< how long a path is kept behind the seen puck
  static constexpr double kHalfWidth_m = 0.014;  ///< of the ribbon, including its dots
  static constexpr double kAbove_m = 0.0015;     ///< height above the cloth

  /// A corner on the board. Times are counted from the board time of the mesh.
  struct Corner {
    glm::vec2 place_m{0.0F};
    float across_m = 0.0F;   ///< distance from the middle of the path
    float time_s = 0.0F;     ///< when the puck's centre is there
    float speed_m_s = 0.0F;  ///< the puck's speed on the board
  };

  /// Create and destroy it with the drawing context current.
  PathRibbons();

  /// Updates the paths of these pucks, for eyes at board time `now_s`. They are computed anew only when knots
  /// have changed, or every few seconds.
  void follow(std::span<const WorldLine> pucks, double now_s);

  /// Sets, for one eye, how far it has seen each puck come.
  void look(std::span<const WorldLine> pucks, const Event& observation, const Switches& switches,
            double now_s);

  /// Draws the paths. `colours`: of the pucks, linear. `drawnFromBoard`: as in ViewFrame. Call it within a
  /// GlStateGuard, with depth test and blending on.
  void draw(const glm::mat4& clipFromDrawn, const glm::mat4& drawnFromBoard,
            std::span<const glm::vec3> colours) const;

 private:
  /// The path of one puck, and the knots from which it was made.
  struct Way {
    int first = 0, count = 0;
    std::size_t knots = 0;
    double firstTurn_s = 0.0, lastTurn_s = 0.0;
    float seen_s = 0.0F, known_s = 0.0F;  // for the current eye
  };
  bool changed(std::span<const WorldLine> pucks, double now_s) const;

  GlProgram program_;
  VertexStream<Corner> stream_;
  std::vector<Way> ways_;
  std::vector<Corner> corners_;
  double base_s_ = 0.0, madeUntil_s_ = 0.0;
  glm::vec3 eyeOnBoard_m_{0.0F};
};

/// Adds the corners of one puck's path from board time `from_s` to `until_s`, as triangles; their times are
/// counted from `base_s`.
void addWay(const WorldLine& puck, double from_s, double until_s, double base_s,
            std::vector<PathRibbons::Corner>& corners);

}  // namespace carom
