#pragma once
// The data from which marks among the bodies are made: one eye's view, and where that eye sees what rests on
// the board.

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "cave/marks/mark_buffer.h"
#include "cave/record/lesson_words.h"
#include "cave/record/time_views.h"
#include "cave/scene/ghosts.h"
#include "engine/game/game_event.h"
#include "engine/light/light_cone.h"
#include "engine/linked/told_path.h"
#include "engine/spacetime/observer.h"

namespace carom {

/// The view of one eye, and the observer it belongs to.
struct MarkContext {
  const ObserverView& observer;
  const EyeView& eye;
  Switches switches;
  TimeViews views;
  std::size_t pucks = 0;                 ///< bodies 1 to this are pucks
  std::span<const WorldLine> histories;  ///< of every body of the scene
  std::span<const BodyView> bodies;      ///< as the eye sees them
  std::span<const GameEvent> events;
  Ghosts ghosts;
  LessonState lesson = {};
  Lorentz boardFromRoom{1.0};             ///< the room's attitude and motion
  std::span<const ToldView> people = {};  ///< of another room, as the eye sees them
};

/// Returns the person's board time, that of the point between the eyes, so that both eyes see the same marks.
inline double boardNow_s(const MarkContext& sight) { return sight.observer.middle.observation.t_s; }

/// Returns for how long the eye has seen that this event has happened; negative if it has not seen it yet.
inline double seenSince_s(const MarkContext& sight, const Event& event) {
  const Event& eye = sight.eye.observation;
  const double way_m = sight.switches.retardation ? glm::length(eye.r_m - event.r_m) : 0.0;
  return eye.t_s - event.t_s - way_m / sight.observer.headFromBoard.lightSpeed_m_s();
}

/// Computes where places at rest on the board are drawn: light from them has come straight, (−|x|, x).
class Resting {
 public:
  explicit Resting(const MarkContext& sight)
      : drawnFromBoard_(ViewFrame(sight.observer.headFromBoard, sight.switches).drawnFromBoard.matrix()),
        eye_m_(sight.eye.observation.r_m) {}
  glm::dvec3 operator()(const Vec3& place_m) const {
    return kernel::rayThrough(drawnFromBoard_, place_m - eye_m_);
  }

 private:
  glm::dmat4 drawnFromBoard_;
  Vec3 eye_m_;
};

/// Computes where points of a body are drawn, at the moment that is viewed.
class OnBody {
 public:
  OnBody(const MarkContext& sight, const BodyView& view, ViewTime moment)
      : view_(view),
        drawnFromSeen_(
            ViewFrame(sight.observer.headFromBoard, sight.switches, moment).drawnFromSeen.matrix()) {}
  glm::dvec3 operator()(const Vec3& offset_m) const {
    return kernel::rayThrough(drawnFromSeen_, seenFromEye(view_, emissionIn(view_, offset_m)));
  }

 private:
  const BodyView& view_;
  glm::dmat4 drawnFromSeen_;
};

/// Returns the horizontal unit vector to the right of a person who looks at this place from between the eyes:
/// plates face the person.
inline Vec3 rightOf(const MarkContext& sight, const Vec3& place_m) {
  const Vec3 way = place_m - sight.observer.middle.observation.r_m;
  const double length_m = std::hypot(way.x, way.y);
  return length_m > 0.0 ? Vec3(way.y, -way.x, 0.0) / length_m : Vec3(1.0, 0.0, 0.0);
}

inline constexpr double kOnCloth_m = 0.003;  ///< height above the cloth of marks that lie on it

/// Adds a ring on the board around `middle_m`, between two radii.
void addClothRing(MarkBuffer& batch, const Resting& draw, const Vec3& middle_m, double inner_m,
                  double outer_m, const glm::vec4& colour);
inline constexpr std::size_t kAround = 96;  ///< parts of rings and arcs

/// A plate that stands at a place and faces the person, large enough to be read from where the person is.
struct StandingPlate {
  PlateText text;
  PlateShape shape = PlateShape::box;
  Vec3 foot_m{0.0};  ///< the middle of its lower border, board frame
  double scale = 1.0;
  double width_m() const { return kPlaceWidth_m * scale * placesAcross(text, shape); }
  double height_m() const { return kPlateHeight_m * scale; }

  static constexpr double kPlaceWidth_m = 0.033, kPlateHeight_m = 0.055;  // of a nearby plate
};

/// Returns a plate that can be read from between the eyes: beyond 1.6 m it is enlarged, at most three times,
/// so that it looks as large as at 1.6 m.
StandingPlate standingPlate(const MarkContext& sight, const PlateText& text, PlateShape shape,
                            const Vec3& foot_m);

/// Adds the plate. `draw(offset)` returns where a point at this offset from the plate's foot is drawn.
template <typename Draw>
void addPlate(MarkBuffer& batch, const MarkContext& sight, const StandingPlate& plate,
              const glm::vec4& colour, const Draw& draw) {
  constexpr std::size_t kAcross = 5;  // points along a plate's borders
  const Vec3 right_m = plate.width_m() * rightOf(sight, plate.foot_m);
  std::array<glm::dvec3, kAcross> lower, upper;
  for (std::size_t i = 0; i < kAcross; ++i) {
    const Vec3 aside_m = (static_cast<double>(i) / static_cast<double>(kAcross - 1) - 0.5) * right_m;
    lower[i] = draw(aside_m);
    upper[i] = draw(aside_m + Vec3(0.0, 0.0, plate.height_m()));
  }
  batch.addPlate(lower, upper, plate.text, plate.shape, colour);
}

/// Keeps plates from covering each other, as seen from between the eyes: later plates are placed higher.
class LabelLayout {
 public:
  explicit LabelLayout(const MarkContext& sight) : eye_m_(sight.observer.middle.observation.r_m) {}
  /// Adds a plate that would stand at its foot, and returns by how much it must stand higher.
  double raise_m(const StandingPlate& plate);

 private:
  struct Box {  // as seen: azimuth of the middle, half the width, and the heights over the distance
    double azimuth_rad, half, lower, upper;
  };
  Vec3 eye_m_;
  std::array<Box, 32> boxes_{};
  std::size_t count_ = 0;
};

}  // namespace carom
