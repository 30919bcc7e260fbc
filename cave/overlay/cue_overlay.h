#pragma once
// Shows what a hand does, drawn over the pictures of the walls in the room's own frame
// (cave/record/hand_view.h): the ray that it points with, a ring around the puck that it aims at and, while
// the cue is drawn back, the cue behind the puck, an arrow in the direction of the stroke, and a scale of its
// cost.
//
// The scale stands beside and above the puck, at the puck's distance, upright for the person. Its height is
// the stroke's cost, the kinetic energy γ − 1 in rest energies of the puck: ticks at 0.5, 0.8, 0.9 and 0.95 c
// show that every further step towards c takes more than the last. Below the scale are the speed and the cost
// that the stroke would now have. With a force device the force in the hand follows, and the room's scale:
// "1 N = 2 N" where one newton in the hand is two at the cue.

#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "cave/gl/letter_batch.h"
#include "cave/gl/line_batch.h"
#include "cave/gl/picture.h"
#include "cave/record/frame_state.h"
#include "cave/room/room_geometry.h"
#include "cave/room/wall.h"

namespace carom {

/// A plane that stands upright for the person and leans back only as far as needed to be read from above. It
/// has a place, its directions right and up there, and its distance from the eyes. Sizes on it scale with the
/// distance, so that they look equally large everywhere.
struct FacingPlane {
  glm::dvec3 place_m{0.0}, right{0.0}, up{0.0};
  double distance_m = 0.0;
  /// Returns the point that lies this many distances to the right of the place and above it.
  glm::dvec3 at(double across, double upwards) const {
    return place_m + distance_m * (across * right + upwards * up);
  }
};
FacingPlane facing(const glm::dvec3& place_m, const glm::dvec3& eyes_m, const RoomGeometry& room);

class CueOverlay {
 public:
  // Lengths without a unit are fractions of the distance: 0.01 is 0.57°.
  static constexpr double kRing_m = 0.12;    ///< least radius of the ring around the target
  static constexpr double kBeside_m = 0.02;  ///< between a large puck's rim and the ring
  static constexpr double kRim_m = 0.05;     ///< least radius of a puck's rim: where the cue begins at rest
  /// From the target to the bar: right of it, or left of it if the stroke goes to the right.
  static constexpr double kScaleRight = 0.13, kScaleLeft = -0.24;
  static constexpr double kScaleFoot = 0.14;  ///< least height of zero cost above the target
  static constexpr double kPerCost = 0.09;    ///< height of one rest energy
  static constexpr double kMostCost = 2.4;    ///< the highest cost on the scale: 0.955 c
  static constexpr double kDrawn_m = 0.15;    ///< the cue's way back for γβ = 1: as far as the hand moves

  /// Returns the height of zero cost above the target. The scale stands over the far end of a table: it
  /// covers no puck at which somebody may aim.
  static double scaleFoot(const FacingPlane& target, const glm::dvec3& eyes_m, const RoomGeometry& room);

  /// Returns the height of a cost on the scale, from the scale's foot.
  static double heightOf(double cost);

  /// Sets how far each body of the scene reaches sideways. Without it, all count as small.
  void setRims(std::vector<double> rims_m) { rims_m_ = std::move(rims_m); }

  /// Draws over the picture of `wall` for an eye in the room; costs nothing if no hand aims. The drawing
  /// context must be current here, and when this object is created and destroyed.
  void draw(const RoomGeometry& room, const Wall& wall, const glm::dvec3& eyeInRoom_m, const SeenFrame& seen,
            const RenderTarget& picture);

 private:
  void addLine(const glm::dvec3& from_m, const glm::dvec3& to_m, double halfWidth_m, const glm::vec4& colour);
  void addRing(const FacingPlane& plane, double radius_m, double halfWidth_m, const glm::vec4& colour);
  void addDot(const FacingPlane& plane, double radius_m, const glm::vec4& colour);
  void addText(const FacingPlane& plane, double across, double upwards, double height, std::string_view text);
  void addRay(const HandView& hand, const glm::dvec3& eyes_m, const RoomGeometry& room);
  void addCue(const HandView& hand, const RoomGeometry& room);
  void addArrow(const HandView& hand, const FacingPlane& plane, const RoomGeometry& room);
  void addTurning(const HandView& hand, const FacingPlane& plane, const RoomGeometry& room);
  void addScale(const HandView& hand, const ForceView& force, const FacingPlane& target,
                const glm::dvec3& eyes_m, const RoomGeometry& room);

  double rimOf(const HandView& hand) const;
  double ringOf(const HandView& hand) const;

  std::vector<double> rims_m_;
  LineBatch ribbons_;
  LetterBatch letters_;
  std::vector<Ribbon> marks_;
  std::vector<SetLetter> words_;
};

}  // namespace carom
