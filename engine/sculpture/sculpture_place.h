#pragma once
// Where the picture of spacetime stands in a room, with time upwards, and where an event is in it.

#include <algorithm>
#include <optional>

#include "engine/base/pose.h"
#include "engine/sculpture/spacetime_frame.h"

namespace carom {

/// The place and size of the sculpture, and the frame in which it is shown. A metre of the board and a metre
/// of light have the same length in it.
struct SculpturePlace {
  Pose roomFromFoot;      ///< of its foot's middle: x and y along the board's, z upwards; room frame
  double height_m = 2.2;  ///< of it in the room
  double scale = 0.25;    ///< metres of the room for a metre of the board
  double past_s = 0.0;    ///< board time from its foot to the present; the rest of the height is the future
  Vec3 beta{0.0};         ///< velocity on the board of the frame in which it is shown, v/c; along the board
};

/// What a rig or a scenario says of it.
struct SpacetimeSetup {
  std::optional<Vec3> place_m;  ///< of its foot's middle, room frame; none: beside the person
  double height_m = SculpturePlace{}.height_m;
  double scale = SculpturePlace{}.scale;
  std::optional<double> past_s, future_s;  ///< none: as the height allows
};

/// The most past that can be shown.
inline constexpr double kLongestSculpture_s = 600.0;

/// Returns the times and the size of the sculpture of a game; its pose is still to be set. The present is at
/// four fifths of the height where nothing else is said.
inline SculpturePlace sizeOf(const SpacetimeSetup& setup, double c_m_s) {
  constexpr double kPresentAt = 0.8;
  const double second_m = setup.scale * c_m_s;  // of its height
  const double whole_s = setup.height_m / second_m;
  const double future_s = setup.future_s.value_or(setup.past_s ? std::max(0.0, whole_s - *setup.past_s)
                                                               : (1.0 - kPresentAt) * whole_s);
  SculpturePlace place;
  place.scale = setup.scale;
  place.past_s =
      std::min({setup.past_s.value_or(std::max(0.0, whole_s - future_s)), whole_s, kLongestSculpture_s});
  place.height_m = std::min(setup.height_m, (place.past_s + future_s) * second_m);
  return place;
}

/// The fastest frame in which it can be shown, over c.
inline constexpr double kMostSculptureBeta = 0.95;

/// The radius of the ring that boosts it, at the height of the present; metres of the board.
inline constexpr double kSculptureRing_m = 1.6;

/// Maps the events of the board to the room, for one present event, which keeps its place under every boost.
class SculptureMap {
 public:
  SculptureMap(const SculpturePlace& place, const Event& present, double c_m_s)
      : place_(place),
        frame_{Lorentz::boost(uFromBeta(place.beta), c_m_s).inverse(), present},
        present_m_(present.r_m.x, present.r_m.y,
                   std::min(c_m_s * place.past_s, place.height_m / place.scale)) {}

  /// Returns where an event lies in the model: x, y and the height above its foot, metres of the board.
  Vec3 model_m(const Event& onBoard) const { return frame_.at(onBoard) + present_m_; }
  /// Returns the same in the room.
  Vec3 room_m(const Event& onBoard) const { return place_.roomFromFoot * (place_.scale * model_m(onBoard)); }
  /// Returns the event of the board, at this height over it, that is shown at a place of the model.
  Event eventAt(const Vec3& model_m, double height_m) const {
    const Vec3 d = model_m - present_m_;
    const Displacement inFrame{d.z / frame_.frameFromBoard.lightSpeed_m_s(), {d.x, d.y, 0.0}};
    Event event = frame_.about + frame_.frameFromBoard.inverse() * inFrame;
    event.r_m.z = height_m;
    return event;
  }

  const SculpturePlace& place() const { return place_; }
  double present_m() const { return present_m_.z; }                ///< its height above the foot
  double top_m() const { return place_.height_m / place_.scale; }  ///< metres of the board
  double lightSpeed_m_s() const { return frame_.frameFromBoard.lightSpeed_m_s(); }
  /// Returns the board times between which all that is shown within `away_m` of the present event lies: c Δt
  /// = h/γ + β·Δr for an event at the height h over the present.
  Span shownWithin(double away_m) const {
    const double gamma = gammaFromU(frame_.frameFromBoard.u()), aside_m = glm::length(place_.beta) * away_m;
    return {frame_.about.t_s - (present_m() / gamma + aside_m) / lightSpeed_m_s(),
            frame_.about.t_s + ((top_m() - present_m()) / gamma + aside_m) / lightSpeed_m_s()};
  }
  const Event& present() const { return frame_.about; }

 private:
  SculpturePlace place_;
  SpacetimeFrame frame_;
  Vec3 present_m_;
};

}  // namespace carom
