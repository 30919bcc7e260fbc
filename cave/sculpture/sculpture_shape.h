#pragma once
// What of a frame is shown in the sculpture of spacetime, in the board's frame: where the moments of the
// viewers cut the tubes, their own lines, and the rectangle over which their surfaces are spread.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "cave/record/frame_state.h"
#include "cave/scene/scene.h"
#include "engine/sculpture/rim_cut.h"
#include "engine/sculpture/sculpture_place.h"
#include "engine/sculpture/soft_rim.h"

namespace carom {

/// The rim of one tube at one moment of one viewer: a closed line.
struct TubeCut {
  std::size_t body = 0, viewer = 0;  ///< the body's number among the sculpted
  ViewTime moment = ViewTime::seen;
  std::vector<Event> events;  ///< empty: nothing is to be seen
};

/// An event of a viewer's own line.
struct OwnEvent {
  Event event;
  double properTime_s = 0.0;
};

/// The viewers' own lines, as far as their frames have been followed.
class OwnLines {
 public:
  /// Takes a frame. Where a pass of the game begins again, the earlier pass is forgotten.
  void follow(const FrameRecord& record);
  std::span<const OwnEvent> of(std::size_t viewer) const { return lines_[viewer]; }

 private:
  std::array<std::vector<OwnEvent>, kMostViewers> lines_;
};

class SculptureShape {
 public:
  /// By how much the chords of a disc's cut may be off in the room, at rest: of the seen rim, and of those at
  /// a moment.
  static constexpr double kFine_m = 4e-5, kMomentFine_m = 2.5e-4;

  explicit SculptureShape(const SculptedGame& game);

  /// Takes a frame, once.
  void follow(const FrameRecord& record, const World& world);

  const SculptedGame& game() const { return game_; }
  /// Returns the rim of one of the sculpted bodies that is soft in this world; none while it is rigid.
  std::optional<SoftRim> softRim(std::size_t body, const World& world);
  std::span<const TubeCut> cuts() const { return std::span(cuts_).first(cutCount_); }
  /// The rectangle: the board, widened to the viewers beside it.
  const glm::dvec2& low_m() const { return low_m_; }
  const glm::dvec2& high_m() const { return high_m_; }

 private:
  void cut(std::size_t person, const FrameRecord& record, const World& world);
  void spread(const FrameRecord& record);

  SculptedGame game_;
  std::vector<Rim> rims_;
  std::vector<SoftHull> hulls_;  // made when a body becomes soft
  Rim rim_;                      // what of one is cut
  BodyView view_;
  std::vector<TubeCut> cuts_;  // memory that is used again
  std::size_t cutCount_ = 0;
  glm::dvec2 low_m_{0.0}, high_m_{0.0};
};

/// Returns the event of a surface over a place of the plane of the tops: the viewer's past light cone there,
/// a hyperboloid as the eye is higher, t = t_o − √(ρ² + (z_eye − z)²)/c; the plane of the viewer's present, t
/// = t_o + β·(r − r_o)/c, where β is the head's v/c; or the board's present, t = t_o.
Event surfaceEvent(const ObserverView& observer, ViewTime moment, const glm::dvec2& place_m, double top_m);

}  // namespace carom
