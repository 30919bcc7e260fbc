#pragma once
// A soft body as one eye sees it: every vertex at its own emission event, on the rows of its node or, before
// they begin, on the leg of the rigid puck that it was. Made on the processor, in double; shaders light and
// paint it.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "cave/record/frame_state.h"
#include "cave/scene/soft_model.h"
#include "engine/light/row_eye.h"

namespace carom {

/// The quantity that a body's colours tell instead of its paint.
enum class Told : std::uint8_t { nothing, strain, heat };

/// A vertex as shaders take it.
struct SeenVertex {
  glm::vec3 drawn{0.0F};     ///< from the eye, in the frame in which walls draw
  float boardTime_m = 0.0F;  ///< c (t − t_o)
  glm::vec3 u{0.0F};         ///< γβ on the board
  float told = 0.0F;         ///< the share that `Told` asks for; of nothing, its heat
  glm::vec3 normal{0.0F};    ///< in the vertex's own frame, in the board's axes
};

/// A sphere around the drawn vertices, and how its middle moves.
struct SeenBound {
  glm::dvec3 middle{0.0};
  double radius = 0.0;
  glm::dvec3 middleU{0.0};  ///< γβ
  double hottest = 0.0;     ///< the largest `told`
};

/// Which eye sees, and how.
struct SeenHow {
  Event observation;
  Lorentz headFromBoard;
  Switches switches{};
  ViewTime moment = ViewTime::seen;
};

class SeenRows {
 public:
  /// Fills `vertices`, as many as the model of a told body has. Those that are unseen yet have a board time
  /// before kUnseen_m.
  SeenBound see(const SoftModel& model, const SeenHow& how, std::span<SeenVertex> vertices);
  static constexpr float kUnseen_m = -1e5F;

  /// Fills `vertices`, as many as the model has. `past` has rows.
  SeenBound see(const SoftModel& model, const SoftPast& past, const SeenHow& how, Told told,
                std::span<SeenVertex> vertices);

 private:
  struct Point {
    glm::dvec3 drawn{0.0}, u{0.0};
    double boardTime_m = 0.0, told = 0.0;
    RowSpot spot;
    bool isOnLeg = false;  ///< seen as a point of the rigid puck that it was
  };
  template <typename Rows>
  void findPoints(const SoftModel& model, const SoftPast& past, const RowEye& eye, const Rows& rows,
                  Told told);
  void findOnLeg(const SoftModel& model, std::size_t number, const RowEye& eye);

  std::vector<Point> points_;
  std::vector<double> times_m_;  // of the rows, from the observation
  std::vector<glm::dvec3> normals_;
  BodyView rigid_;
};

}  // namespace carom
