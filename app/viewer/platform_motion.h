#pragma once
// The motion of the platform: its thrust at each moment, as steered by hand, as the tour prescribes, or on
// the way home.
//
// All times here are game seconds (the viewer's, times the pace of Observers::step), measured as proper time
// of the platform at the head. They equal the viewer's time while they stand and run slightly faster while
// they walk, so a trip that ends at rest does so however the viewer walks meanwhile. Motion is the exact sum
// of hyperbolae (Observers::step), split where one ends inside a frame.

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "app/files/scenario.h"
#include "cave/record/hand_view.h"
#include "cave/texts/saying.h"
#include "engine/spacetime/lorentz.h"
#include "engine/spacetime/observers.h"

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

  /// Advances the observers by dτ of the fastest while their tracked heads move to `heads`, as in
  /// Observers::step. The platform follows the wish of observer `steering`, or else its current manoeuvre.
  void advance(const DriveWish& wish, double dtau_s, double pace, std::span<const Head> heads,
               Observers& observers, std::size_t steering = 0);

  const DriveView& view() const { return view_; }  ///< of the last frame; thrust is the mean over it
  /// Returns and clears the message since the last call; empty if there is none.
  texts::Saying takeNotice() { return std::exchange(notice_, {}); }

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
  /// A frame in which the heads move from where `before` has them to `heads`.
  struct Frame {
    const Observers& before;
    std::span<const Head> heads;
    double person_s;  ///< proper time of the fastest observer
    double pace;
    std::size_t steering;

    /// Returns the frame's duration in the room's time with this thrust. It runs evenly meanwhile.
    double platform_s(const Vec3& thrust_m_s2 = Vec3(0.0)) const {
      return before.roomTimeOf_s(person_s, heads, pace, thrust_m_s2, steering);
    }
  };
  /// The rest of a frame; the observers have lived the part before it.
  struct Left {
    const Frame& frame;
    const Observers& observers;
    double share;

    /// Returns its duration in the room's time with this thrust.
    double platform_s(const Vec3& thrust_m_s2 = Vec3(0.0)) const { return lasts_s(share, thrust_m_s2); }
    double person_s() const { return share * frame.person_s; }
    /// Returns how long a part of the frame, which begins here, lasts; for one observer it is in proportion.
    double lasts_s(double part, const Vec3& thrust_m_s2) const;
    /// Returns the part of the frame that lasts `for_s`, less than the rest.
    double partThatLasts(double for_s, const Vec3& thrust_m_s2) const;
  };

  void apply(const DriveWish& wish);
  void begin(const Observers& observers);
  void endTour(const Observers& observers);
  Manoeuvre next(const DriveWish& wish, const Observers& observers, const Vec3& headInRoom_m,
                 const Left& left);
  Manoeuvre steered(const Vec3& steer, const Observers& observers, const Left& left);
  Manoeuvre coast(const Observers& observers, const Left& left);
  Manoeuvre stopAtWall(const Observers& observers, const Left& left);
  bool staysInHall(const Lorentz& boardFromRoom, const Vec3& place_m) const;
  template <typename Gain>
  static Manoeuvre meanOf(const Left& left, const Gain& gain_m_s);
  Manoeuvre brake(const Observers& observers, const Left& left) const;
  Manoeuvre returnHome(const Observers& observers, const Vec3& headInRoom_m, const Left& left);
  Manoeuvre alongWay(const Left& left);
  double shareOf(const Thrust& push) const;
  Vec3 gainAlongWay_m_s(double for_s, std::size_t& push, double& pushed_s) const;
  void planTrip(const Vec3& wayInRoom_m);
  void take(std::span<const Thrust> way);
  void leaveWay(DriveMode mode);
  void sayOnce(bool& said, const texts::Saying& words);

  double c_m_s_, strongest_m_s2_, most_u_;
  std::size_t steering_ = 0;  ///< the observer about whom the room turns, and for whom its thrust is given
  Vec3 up_;                   ///< of the room
  std::optional<glm::dvec2>
      halfHall_m_;       ///< how far the head may go from the table's centre; empty: anywhere
  Pose boardFromHome_;   ///< of the room at rest, at home
  Vec3 atStart_u_{0.0};  ///< of the room in the scenario's initial state
  bool setsOut_ = false;
  /// Steered by hand at some time; otherwise the scenario intends any distance from the table.
  bool steered_ = false;
  bool thrusts_ = false;                            ///< the tour's first thrust has begun
  std::size_t setOutBy_ = 0;                        ///< by whose clock the tour is timed
  double setOutBoard_s_ = 0.0, setOutOwn_s_ = 0.0;  ///< when it did
  std::vector<Thrust> tour_, way_;
  std::size_t push_ = 0;   ///< current thrust of `way_`
  double pushed_s_ = 0.0;  ///< elapsed time of that thrust
  DriveView view_;
  texts::Saying notice_;
  bool saidStrongest_ = false, saidFastest_ = false, saidFar_ = false, saidWall_ = false;
};

}  // namespace carom
