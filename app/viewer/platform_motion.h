#pragma once
// The motion of the platform: its thrust at each moment, as steered by hand, as the tour prescribes, or on
// the way home.
//
// All times here are game seconds (the viewer's, times the pace of Observer::step), measured as proper time
// of the platform at the head. They equal the viewer's time while they stand and run slightly faster while
// they walk, so a trip that ends at rest does so however the viewer walks meanwhile. Motion is the exact sum
// of hyperbolae (Observer::step), split where one ends inside a frame.

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "app/files/scenario.h"
#include "cave/frame/hand_view.h"
#include "cave/frame/notice.h"
#include "engine/spacetime/lorentz.h"
#include "engine/spacetime/observer.h"

namespace carom {

/// The input to the platform's motion in one frame, combined from all devices.
struct DriveWish {
  /// Fraction of the strongest thrust, in the room's axes (the rig's); a length above 1 asks for more than
  /// available.
  Vec3 steer{0.0};
  bool brake = false;     ///< held down
  bool home = false;      ///< requested in this frame
  double turn_rad = 0.0;  ///< of the room about the vertical through the head, anticlockwise from above
};

/// Returns whether anything is wished.
inline bool asksForAnything(const DriveWish& wish) {
  return wish.steer != Vec3(0.0) || wish.brake || wish.home || wish.turn_rad != 0.0;
}

class PlatformMotion {
 public:
  /// Sets home to the platform's initial position in the scenario, but at rest. If `begins`, a tour that
  /// starts at once does so; a continued session resumes neither the tour nor the way home.
  PlatformMotion(const Scenario& scenario, const RoomAxes& axes, bool begins);

  /// Starts the scenario's tour with the next frame, at its first leg. The platform must be at rest or move
  /// as in the scenario's initial state, otherwise the tour would end elsewhere; if it does not, a message
  /// says so.
  void setOut() { setsOut_ = true; }

  /// Advances the observer by dτ while the tracked head moves from `before`, where Observer has it, to
  /// `head`, as in Observer::step. The platform follows `wish`, or else its current manoeuvre.
  void live(const DriveWish& wish, double dtau_s, double pace, const Head& before, const Head& head,
            Observer& observer);

  const DriveView& view() const { return view_; }  ///< of the last frame; thrust is the mean over it
  /// Returns and clears the message since the last call; empty if there is none.
  Notice news() { return std::exchange(notice_, {}); }

 private:
  /// A constant thrust, or a turn about the head, of duration `for_s`.
  struct Manoeuvre {
    double for_s = 0.0;
    Vec3 thrust_m_s2{0.0};
    double turn_rad = 0.0;
    Vec3 turnAxisInRoom{0.0};
  };
  /// One thrust of the current trip, in the room's axes; it follows the previous one.
  struct Thrust {
    double for_s = 0.0;
    Vec3 thrust_m_s2{0.0};
  };
  /// The rest of a frame.
  struct Left {
    double platform_s = 0.0;
    double person_s = 0.0;  ///< the viewer's proper time
  };

  void obey(const DriveWish& wish);
  void begin(const Observer& observer);
  void endTour(const Observer& observer);
  Manoeuvre next(const DriveWish& wish, const Observer& observer, const Vec3& headInRoom_m, const Left& left);
  Manoeuvre steered(const Vec3& steer, const Observer& observer, double left_s);
  Manoeuvre coast(const Observer& observer, double left_s);
  Manoeuvre stopAtWall(const Observer& observer, double left_s);
  bool staysInHall(const Lorentz& boardFromRoom, const Vec3& place_m) const;
  Manoeuvre brake(const Observer& observer, double left_s) const;
  Manoeuvre returnHome(const Observer& observer, const Vec3& headInRoom_m, const Left& left);
  Manoeuvre alongWay(double left_s);
  void planTrip(const Vec3& wayInRoom_m);
  void take(std::span<const Thrust> way);
  void leaveWay(DriveMode mode);
  void sayOnce(bool& said, std::string_view words);

  double c_m_s_, strongest_m_s2_, most_u_;
  Vec3 up_;  ///< of the room
  std::optional<glm::dvec2>
      halfHall_m_;       ///< how far the head may go from the table's centre; empty: anywhere
  Pose boardFromHome_;   ///< of the room at rest, at home
  Vec3 atStart_u_{0.0};  ///< of the room in the scenario's initial state
  bool setsOut_ = false;
  /// Steered by hand at some time; otherwise the scenario intends any distance from the table.
  bool steered_ = false;
  bool thrusts_ = false;                            ///< the tour's first thrust has begun
  double setOutBoard_s_ = 0.0, setOutOwn_s_ = 0.0;  ///< when it did
  std::vector<Thrust> tour_, way_;
  std::size_t push_ = 0;   ///< current thrust of `way_`
  double pushed_s_ = 0.0;  ///< elapsed time of that thrust
  DriveView view_;
  Notice notice_;
  bool saidStrongest_ = false, saidFastest_ = false, saidFar_ = false, saidWall_ = false;
};

}  // namespace carom
